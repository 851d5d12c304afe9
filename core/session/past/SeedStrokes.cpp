// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/SeedStrokes.h"

#include "core/edits/answers/EditEffects.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/GrowthKinds.h"
#include "core/edits/kinds/IsOneOf.h"

#include <utility>

namespace core {

namespace {

bool asksForStrokes(const Edit& edit)
{
    const GrowCriteria* criteria = growCriteriaOf(edit);
    return criteria && criteria->sigmas && criteria->perStroke.value_or(false);
}

/// The segment whose seeds an edit sets or takes away. Only the engine sets seeds, so each kind
/// that it carries out has to be named, and that as one of growth (GrowthKinds.h) or as none.
struct SegmentOfSeeds {
    using Found = std::optional<int>;

    Found operator()(const SeedStroke& sketched) const { return sketched.segment; }
    Found operator()(const PaintStroke& painted) const
    {
        return painted.seeds ? Found(painted.segment) : std::nullopt;
    }
    template <class E>
    requires isOneOf<E, BarrierStroke, ChangeInterval, GrowFromSeeds, GrowSteps, PlugLeak,
        ResumeGrowth, ShrinkAt, ShrinkSteps>
        Found operator()(const E&) const
    {
        static_assert(isGrowthKind<E>);
        return std::nullopt;
    }
    template <class E>
    requires isOneOf<E, BrushStroke, CombineSegments, DrillStroke, FillOutline, InvertSegment,
        LaserStroke, LayerToSegment, MergeLayers, PeelCut, RemoveLayer, RemoveSegment, ScissorsCut,
        SegmentScissors, SegmentSeen, SegmentToLayer, ThresholdSegment>
        Found operator()(const E&) const
    {
        static_assert(!isGrowthKind<E>);
        return std::nullopt;
    }
    template <class E>
    requires(!hasEngineEdit<E>) Found operator()(const E&) const { return std::nullopt; }
};

} // namespace

std::optional<int> segmentOfSeeds(const Edit& edit)
{
    return visitEdit(SegmentOfSeeds(), edit);
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
