// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/labels/LayerWrites.h"

#include <algorithm>

namespace core {

namespace {

Result<void> checkLabel(std::uint8_t label)
{
    if (label == 0)
        return failure(
            ErrorCode::InvalidField, QStringLiteral("label"), Clause::saying("0 is no segment"));
    return {};
}

/// Whether listed bricks are whole, ascend and are the volume's.
template <class Brick>
bool areSound(
    const std::vector<Brick>& bricks, std::vector<std::uint8_t> Brick::*voxels, int brickCount)
{
    std::int64_t last = -1;
    for (const Brick& brick : bricks) {
        if ((brick.*voxels).size() != BrickGrid::voxelsPerBrick || std::int64_t(brick.brick) <= last
            || std::int64_t(brick.brick) >= brickCount)
            return false;
        last = brick.brick;
    }
    return true;
}

/// Whether nothing else is asked for than it knows.
bool areKnown(const std::vector<std::uint8_t>& asked)
{
    return std::all_of(
        asked.begin(), asked.end(), [](std::uint8_t each) { return each <= RelabelListed::take; });
}

/// Whether every normal is short enough for a volume of this size.
bool areSound(const std::vector<VoxelBound>& bounds, const glm::ivec3& size)
{
    for (const VoxelBound& bound : bounds) {
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t reach = std::int64_t(bound.normal[axis]) * size[axis];
            if (reach <= -(std::int64_t(1) << 29) || reach >= std::int64_t(1) << 29)
                return false;
        }
    }
    return true;
}

tl::unexpected<Error> unsoundBricks()
{
    return failure(
        ErrorCode::InvalidField, QStringLiteral("bricks"), Clause::saying("are not sound"));
}

Result<void> unsoundPlanes()
{
    return failure(
        ErrorCode::InvalidField, QStringLiteral("planes"), Clause::saying("are not sound"));
}

} // namespace

Result<void> checkSound(const LabelCarved& edit, const BrickGrid&)
{
    if (const Result<void> sound = checkSound(edit.editable); !sound)
        return sound;
    return checkLabel(edit.target.label);
}

Result<void> checkSound(const LabelSeen& edit, const BrickGrid& grid)
{
    if (!areSound(edit.bounds, grid.volumeSize))
        return failure(
            ErrorCode::InvalidField, QStringLiteral("bounds"), Clause::saying("are not sound"));
    if (const Result<void> sound = checkSound(edit.editable); !sound)
        return sound;
    return checkLabel(edit.target.label);
}

Result<void> checkSound(const LabelListed& edit, const BrickGrid& grid)
{
    if (!areSound(edit.bricks, &LabelListed::Brick::labels, grid.brickCount()))
        return unsoundBricks();
    return checkSound(edit.editable);
}

Result<void> checkSound(const LabelPlanes& edit, const BrickGrid& grid)
{
    int last = -1;
    for (const LabelListed& plane : edit.planes) {
        if (const Result<void> sound = checkSound(plane, grid); !sound)
            return sound;
        if (int(plane.plane) <= last)
            last = 256; // none comes after it
        else
            last = plane.plane;
    }
    if (last < 0 || last > 255)
        return unsoundPlanes();
    return {};
}

Result<void> checkSound(const MapPlanes& edit, const BrickGrid& grid)
{
    std::bitset<256> known;
    for (const MapLabels& plane : edit.planes) {
        if (const Result<void> sound = checkSound(plane, grid); !sound)
            return sound;
        if (known[plane.plane])
            return unsoundPlanes();
        known.set(plane.plane);
    }
    return known.any() ? Result<void>() : unsoundPlanes();
}

Result<void> checkSound(const RelabelListed& edit, const BrickGrid& grid)
{
    const bool known = std::all_of(edit.bricks.begin(), edit.bricks.end(),
        [](const RelabelListed::Brick& brick) { return areKnown(brick.asked); });
    if (!known || !areSound(edit.bricks, &RelabelListed::Brick::asked, grid.brickCount()))
        return unsoundBricks();
    if (const Result<void> sound = checkSound(edit.editable); !sound)
        return sound;
    return checkLabel(edit.target.label);
}

Result<void> checkSound(const CoverLabel& edit, const BrickGrid&)
{
    return checkLabel(edit.label);
}

Result<void> checkSound(const FoldLayer& edit, const BrickGrid&)
{
    if (edit.into == edit.layer)
        return failure(
            ErrorCode::InvalidField, QStringLiteral("into"), Clause::saying("is the layer itself"));
    return {};
}

} // namespace core
