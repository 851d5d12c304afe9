// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/splitting/SplitIslands.h"

#include "core/brick/RunRows.h"
#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/IslandSizes.h"
#include "core/edits/engine/ListedRuns.h"
#include "core/edits/open/OpenStroke.h"
#include "core/islands/SegmentIslands.h"
#include "core/sculpt/labels/HeldVoxels.h"

#include <algorithm>
#include <bitset>
#include <limits>

namespace core {

using namespace rowWords;

namespace {

/// Whether any of an island's voxels may change.
bool mayChange(const VoxelRuns& island, const HeldVoxels& held, const SplitGround& ground,
    const glm::ivec3& size, int anyCode)
{
    const glm::ivec3 extent = ground.box.maximum - ground.box.minimum;
    bool may = false;
    forEachRowPart(island, size, [&](const glm::ivec3& at, int count, std::uint64_t first) {
        const glm::ivec3 in = at - ground.box.minimum;
        const std::size_t row =
            (std::size_t(in.z) * std::size_t(extent.y) + std::size_t(in.y)) * std::size_t(extent.x)
            + std::size_t(in.x);
        for (int i = 0; i < count && !may; ++i) {
            const int code =
                ground.codes.empty() ? anyCode : int(ground.codes[row + std::size_t(i)]);
            may = !held.holds(at + glm::ivec3(i, 0, 0), std::size_t(first) + std::size_t(i), code);
        }
    });
    return may;
}

/// Without islands that have no voxel that may change.
void keepEditable(FurtherIslands& further, const EditableVoxels& editable,
    const SplitGround& ground, const glm::ivec3& size)
{
    const HeldVoxels held(editable, ground.planes);
    std::erase_if(further.islands, [&](const VoxelRuns& island) {
        return !mayChange(island, held, ground, size, editable.lowCode);
    });
    further.count = std::int64_t(further.islands.size());
}

} // namespace

Result<void> check(const SplitIslands& edit, const Document& document)
{
    if (const auto editable = editableVoxels(edit.editable, document, "splitIslands"); !editable)
        return tl::unexpected(editable.error());
    if (const auto segment = unlockedSegment("splitIslands.segment", edit.segment, document);
        !segment)
        return tl::unexpected(segment.error());
    return checkApplied(edit, document);
}

Result<bool> apply(const SplitIslands& edit, Document& document)
{
    if (!edit.into)
        return false;
    return addParts(
        "splitIslands.segment", edit.segment, "splitIslands.into", *edit.into, document);
}

EditEffects effects(const SplitIslands& edit)
{
    // Elsewhere there may be more islands, or fewer.
    EditEffects all =
        splitEffects(edit.segment, edit.into.has_value() || namesPlaces(edit.editable));
    all.standsOpen = opens<SplitIslands>();
    if (!edit.into)
        all.fills.added = AddedSegments::UnknownNumber;
    return all;
}

/// A preview, for the user to decide.
OpenManner openManner(const SplitIslands&)
{
    return {.withoutPen = true, .endsIfRefused = true};
}

/// "Split 3 islands off 'Liver', −1 204 voxels"
RowTitle rowTitle(const SplitIslands& edit, const RowFacts& row)
{
    const LabelFlow flow = row.flowOf(edit.segment);
    return {.code = RowTitleCode::SplitIslands,
        .arguments = {TitleCount{std::int64_t(edit.into ? edit.into->size() : 0)},
            segmentName(edit.segment, row.document)},
        .then = {flowTitle(flow.gained, flow.lost)}};
}

/// Every voxel of the plane may decide what hangs together.
EditDependencies dependencies(const SplitIslands& edit, const DependencyFacts& row)
{
    return row.alsoReading(edit.editable, dependsOn::Plane{.plane = row.planeOf(edit.segment)});
}

std::int64_t leastVoxels(const SplitIslands& edit, const VolumeGeometry& geometry)
{
    return edit.mm3 ? fewestVoxels(*edit.mm3, geometry) : 1;
}

Result<LabelListed> labelListed(SplitIslands& edit, const Document& document,
    const SplitGround& ground, const Progress& progress)
{
    const Result<std::optional<EditableVoxels>> editable =
        editableVoxels(edit.editable, document, "splitIslands");
    if (!editable)
        return tl::unexpected(editable.error());
    const Result<const Segment*> unlocked =
        unlockedSegment("splitIslands.segment", edit.segment, document);
    if (!unlocked)
        return tl::unexpected(unlocked.error());
    const Segment& segment = **unlocked;
    const std::size_t room = roomForSegments(document);
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    const std::size_t asked = edit.into ? std::min(edit.into->size(), room) : room;
    // Which of them become segments is only known when all are.
    const std::size_t most = *editable ? std::numeric_limits<std::size_t>::max() : asked;
    Result<FurtherIslands> further = furtherIslands(labelsOfPlane(ground.planes, segment.plane),
        geometry.size, segment.label, leastVoxels(edit, geometry), most, progress);
    if (!further)
        return tl::unexpected(further.error());
    if (*editable) {
        keepEditable(*further, **editable, ground, geometry.size);
        further->islands.resize(std::min(further->islands.size(), asked));
    }
    if (!edit.into && further->count > std::int64_t(room))
        return failure(ErrorCode::TooManyIslands, segment.name, QString::number(further->count),
            QString::number(room));
    if (edit.into && further->islands.size() < edit.into->size())
        return failure(ErrorCode::InvalidField, QStringLiteral("splitIslands.into"),
            Clause::saying("names %1 segments, and there are %2 islands beside the largest, with "
                           "room for %3 segments more",
                edit.into->size(), further->count, room));
    ListedRuns listed(geometry.size);
    for (std::size_t place = 0; place < further->islands.size(); ++place)
        listed.add(
            further->islands[place], std::uint8_t(document.lastLabelGiven() + 1 + int(place)));
    if (!edit.into && !further->islands.empty())
        edit.into = usualParts(document, segment, further->islands.size());
    std::bitset<256> overwritable;
    overwritable.set(segment.label);
    LabelListed label = listed.label(segment.plane, overwritable, 0);
    label.editable = *editable;
    return label;
}

} // namespace core
