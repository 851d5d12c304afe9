// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/FloodFill.h"

#include "core/brick/BrickBits.h"
#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/parts/BrushPath.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace core {

using namespace rowWords;

namespace {

/// A disc of the brush in its oblique slice; how large it is does not matter.
BrushPath discIn(const FloodFill& edit)
{
    return {.radiusMm = 1.0,
        .shape = BrushPath::Shape::Disc,
        .normalLps = edit.normalLps,
        .pointsLps = {edit.placeLps}};
}

Result<CapsuleFrame> sliceOf(const FloodFill& edit, const VolumeGeometry& geometry)
{
    return capsuleFrame(discIn(edit), geometry, QStringLiteral("floodFill"));
}

/// The bricks in which voxels of its oblique slice may lie.
std::set<std::uint32_t> bricksIn(const CapsuleFrame& slice, const BrickGrid& grid)
{
    const glm::dvec3 rise(
        strokeStep(slice.perI).z, strokeStep(slice.perJ).z, strokeStep(slice.perK).z);
    constexpr double half = (BrickGrid::side - 1) / 2.0;
    const double reach = half * (std::abs(rise.x) + std::abs(rise.y) + std::abs(rise.z));
    constexpr double slack = 16.0; // mm16, more than rounding comes to
    std::set<std::uint32_t> bricks;
    for (int brick = 0; brick < grid.brickCount(); ++brick) {
        const double height =
            strokeBase(slice, grid.boxOf(brick).minimum).z + half * (rise.x + rise.y + rise.z);
        if (std::abs(height) <= reach + slice.halfThickness + slack)
            bricks.insert(std::uint32_t(brick));
    }
    return bricks;
}

} // namespace

Result<void> check(const FloodFill& edit, const Document& document)
{
    if (!(edit.tolerance >= 0.0))
        return failure(ErrorCode::InvalidField, QStringLiteral("floodFill.tolerance"),
            Clause::saying("is less than nothing"));
    if (edit.within && edit.normalLps)
        return failure(ErrorCode::InvalidField, QStringLiteral("floodFill.normalLps"),
            Clause::saying("has no meaning beside within"));
    if (const auto first = firstVoxel(edit, document.volumes.front().geometry); !first)
        return tl::unexpected(first.error());
    return checkEditable(edit.segment, edit.editable, document, "floodFill");
}

Result<bool> apply(const FloodFill&, Document&)
{
    return false;
}

EditEffects effects(const FloodFill& edit)
{
    return {.task = EditTask::Islands,
        .standsOpen = false,
        .writesTo = edit.segment,
        .fills = {.label = edit.erase ? std::nullopt : std::optional(edit.segment)},
        .boundToStudy = true};
}

RowTitle rowTitle(const FloodFill& edit, const RowFacts& row)
{
    const bool slice = isInSlice(edit);
    RowTitleCode code = slice ? RowTitleCode::FloodSlice : RowTitleCode::FloodVolume;
    if (edit.erase)
        code = slice ? RowTitleCode::FloodEraseSlice : RowTitleCode::FloodEraseVolume;
    return segmentChanged(code, edit.segment, row);
}

/// Within a slice it depends on the bricks of that slice. In all directions it is unknown how far
/// it would reach with other labels, so it depends on the whole plane.
EditDependencies dependencies(const FloodFill& edit, const DependencyFacts& row)
{
    const Result<glm::ivec3> first = firstVoxel(edit, row.geometry());
    if (!isInSlice(edit) || !first)
        return row.alsoReading(edit.editable, dependsOn::Plane{.plane = row.planeOf(edit.segment)});
    const BrickGrid grid = row.grid();
    if (const std::optional<CapsuleFrame> slice = obliqueSlice(edit, row.geometry())) {
        std::set<std::uint32_t> near = bricksIn(*slice, grid);
        near.insert(std::uint32_t(grid.brickOf(*first)));
        return row.alsoReading(edit.editable, row.labelled(near, row.planeOf(edit.segment)));
    }
    const int along = alongOf(*edit.within);
    std::set<std::uint32_t> bricks;
    for (int brick = 0; brick < grid.brickCount(); ++brick) {
        const VoxelBox box = grid.boxOf(brick);
        if (box.minimum[along] <= (*first)[along] && (*first)[along] < box.maximum[along])
            bricks.insert(std::uint32_t(brick));
    }
    return row.alsoReading(edit.editable, row.labelled(bricks, row.planeOf(edit.segment)));
}

std::optional<CapsuleFrame> obliqueSlice(const FloodFill& edit, const VolumeGeometry& geometry)
{
    if (!edit.normalLps)
        return std::nullopt;
    const Result<CapsuleFrame> slice = sliceOf(edit, geometry);
    return slice ? std::optional(*slice) : std::nullopt;
}

Result<glm::ivec3> firstVoxel(const FloodFill& edit, const VolumeGeometry& geometry)
{
    std::optional<glm::ivec3> voxel;
    if (edit.normalLps) {
        if (const Result<CapsuleFrame> slice = sliceOf(edit, geometry); !slice)
            return tl::unexpected(slice.error());
        const std::vector<glm::ivec3> under = voxelsUnder(discIn(edit), geometry);
        if (!under.empty())
            voxel = under.front();
    } else {
        voxel = voxelNearest(edit.placeLps, geometry);
    }
    if (!voxel)
        return failure(ErrorCode::InvalidField, QStringLiteral("floodFill.placeLps"),
            Clause::saying("%1 lies outside the volume", pointText(edit.placeLps)));
    return *voxel;
}

CodeInterval floodInterval(const FloodFill& edit, const VoxelEncoding& encoding, int code)
{
    const double value = encoding.value(code);
    // The code of the place itself always belongs to it, however values are rounded.
    return {.low = std::min(code, encoding.lowestCodeAtLeast(value - edit.tolerance)),
        .high = std::max(code, encoding.highestCodeAtMost(value + edit.tolerance))};
}

Result<RelabelListed> relabelListed(const FloodFill& edit, const Document& document,
    const std::map<std::uint32_t, BrickBits>& found)
{
    Result<LabelTarget> target =
        segmentTarget(edit.segment, edit.overwriteUnlocked && !edit.erase, document);
    if (!target)
        return tl::unexpected(target.error());
    if (edit.erase && found.empty())
        return failure(ErrorCode::NoIslandThere, document.segment(edit.segment)->name);
    const std::uint8_t asked = edit.erase ? RelabelListed::take : RelabelListed::give;
    RelabelListed relabel{.target = *std::move(target), .bricks = {}};
    for (const auto& [brick, voxels] : found) {
        std::vector<std::uint8_t> each(BrickGrid::voxelsPerBrick, 0);
        voxels.forEach([&each, asked](std::size_t voxel) { each[voxel] = asked; });
        relabel.bricks.push_back({brick, std::move(each)});
    }
    return keepingTo(edit.editable, document, "floodFill", std::move(relabel));
}

} // namespace core
