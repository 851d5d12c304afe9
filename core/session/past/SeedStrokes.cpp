// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/SeedStrokes.h"

#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/growth/GrowCriteria.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/segments/PaintStroke.h"

#include <utility>

namespace core {

namespace {

bool asksForStrokes(const Edit& edit)
{
    const GrowCriteria* criteria = growCriteriaOf(edit);
    return criteria && criteria->sigmas && criteria->perStroke.value_or(false);
}

} // namespace

std::optional<int> segmentOfSeeds(const Edit& edit)
{
    if (const auto* sketched = edit.as<SeedStroke>())
        return sketched->segment;
    const auto* painted = edit.as<PaintStroke>();
    return painted && painted->seeds ? std::optional(painted->segment) : std::nullopt;
}

std::vector<SeedGroup> seedStrokes(const History& history, const Document& document, int plane)
{
    std::vector<SeedGroup> strokes;
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    for (const RowId id : history.standing()) {
        const auto* stroke = history.row(id).edit.as<SeedStroke>();
        // The seeds of a segment that was deleted went with it.
        const Segment* segment = stroke ? document.segment(stroke->segment) : nullptr;
        if (!segment || segment->plane != plane || stroke->pointsLps.empty())
            continue;
        if (auto voxels = seedVoxels(stroke->pointsLps, geometry, "pointsLps"))
            strokes.push_back({.label = segment->label, .voxels = *std::move(voxels)});
    }
    return strokes;
}

void addSeedStrokes(
    GrowBurst& burst, const Edit& edit, const History& history, const Document& document)
{
    if (asksForStrokes(edit))
        burst.seedGroups = seedStrokes(history, document, burst.plane);
}

} // namespace core
