// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/sculpt/Rays.h"

#include <algorithm>

namespace reference {

namespace {

/// The eight voxels around a position and its fractions in 256ths.
struct Cell {
    glm::ivec3 low;
    glm::ivec3 high;
    std::array<std::uint64_t, 3> fraction;
};

Cell cellAt(const Index16& position, const glm::ivec3& size)
{
    Cell cell;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t value = std::clamp<std::int64_t>(
            position[std::size_t(axis)], 0, std::int64_t(size[axis] - 1) * 65536);
        cell.low[axis] = int(value >> 16);
        cell.high[axis] = std::min(cell.low[axis] + 1, size[axis] - 1);
        cell.fraction[std::size_t(axis)] = std::uint64_t((value & 0xFFFF) >> 8);
    }
    return cell;
}

/// Interpolation along x, y and z, dropping `shift` bits after x and after y.
template <class T>
std::uint64_t interpolated(const DenseArray<T>& field, const Index16& position, int shift)
{
    const Cell cell = cellAt(position, field.size);
    const auto mix = [](std::uint64_t a, std::uint64_t b, std::uint64_t fraction) {
        return a * (256 - fraction) + b * fraction;
    };
    std::array<std::uint64_t, 2> alongY{};
    for (int k = 0; k < 2; ++k) {
        const int z = k == 0 ? cell.low.z : cell.high.z;
        std::array<std::uint64_t, 2> alongX{};
        for (int j = 0; j < 2; ++j) {
            const int y = j == 0 ? cell.low.y : cell.high.y;
            alongX[std::size_t(j)] =
                mix(field.at({cell.low.x, y, z}), field.at({cell.high.x, y, z}), cell.fraction[0])
                >> shift;
        }
        alongY[std::size_t(k)] = mix(alongX[0], alongX[1], cell.fraction[1]) >> shift;
    }
    return mix(alongY[0], alongY[1], cell.fraction[2]);
}

glm::ivec3 nearestVoxel(const Index16& position)
{
    return {int((position[0] + 0x8000) >> 16), int((position[1] + 0x8000) >> 16),
        int((position[2] + 0x8000) >> 16)};
}

} // namespace

bool hidesPosition(const std::vector<core::IntegerHalfSpace>& hidden, const Index16& position)
{
    for (const core::IntegerHalfSpace& half : hidden) {
        std::int64_t beyond = -half.offset * 65536;
        for (int axis = 0; axis < 3; ++axis)
            beyond += half.perVoxel[axis] * position[std::size_t(axis)];
        if (beyond > 0)
            return true;
    }
    return false;
}

bool hidesVoxel(const std::vector<core::IntegerHalfSpace>& hidden, const glm::ivec3& voxel)
{
    return hidesPosition(hidden,
        {std::int64_t(voxel.x) * 65536, std::int64_t(voxel.y) * 65536,
            std::int64_t(voxel.z) * 65536});
}

bool Tissue::inside(const Index16& position) const
{
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t value = position[std::size_t(axis)];
        if (value < -32768 || value >= (2 * std::int64_t(codes.size[axis]) - 1) * 32768)
            return false;
    }
    return true;
}

std::uint64_t Tissue::density(const Index16& position) const
{
    return interpolated(codes, position, 4);
}

bool Tissue::carved(const Index16& position) const
{
    if (asWhole)
        return false;
    if (byVoxels)
        return radiation.at(nearestVoxel(position)) >= 128;
    return interpolated(radiation, position, 0) >= std::uint64_t(128) << 24;
}

bool Tissue::dense(const Index16& position, int thresholdCode) const
{
    if (byVoxels)
        return int(codes.at(nearestVoxel(position))) >= thresholdCode;
    return std::int64_t(density(position)) >= std::int64_t(thresholdCode) * 65536;
}

bool Tissue::material(const Index16& position, int thresholdCode) const
{
    return inside(position) && dense(position, thresholdCode) && !carved(position);
}

std::optional<glm::ivec3> pick(
    const Tissue& tissue, const core::PickVoxels& pick, const core::PickRay& ray)
{
    std::uint64_t transparency = 65535;
    std::uint64_t brightest = 0;
    std::optional<glm::ivec3> found;
    for (int n = 0; n < ray.samples; ++n) {
        Index16 position;
        for (int axis = 0; axis < 3; ++axis)
            position[std::size_t(axis)] =
                std::int64_t(ray.origin[axis]) + std::int64_t(n) * ray.step[axis];
        if (!tissue.inside(position) || tissue.carved(position))
            continue;
        const std::uint64_t density = tissue.density(position);
        switch (pick.seenBy) {
        case core::SeenBy::Surface:
            if (std::int64_t(density) >= std::int64_t(pick.thresholdCode) * 65536)
                return nearestVoxel(position);
            break;
        case core::SeenBy::Opacity:
            transparency =
                transparency * (65535 - pick.opacityOfCode[std::size_t(density >> 24)]) / 65535;
            if (transparency <= 32767)
                return nearestVoxel(position);
            break;
        case core::SeenBy::BrightestVoxel:
            if (!found || density > brightest) {
                brightest = density;
                found = nearestVoxel(position);
            }
            break;
        case core::SeenBy::Segment:
            break; // pickSegment()
        }
    }
    return found;
}

std::optional<glm::ivec3> pickSegment(const std::vector<const DenseArray<std::uint8_t>*>& planes,
    const core::PickVoxels& pick, const core::PickRay& ray)
{
    for (std::int64_t n = 0; n < ray.samples; ++n) {
        const glm::ivec3 voxel = nearestVoxel({ray.origin.x + n * ray.step.x,
            ray.origin.y + n * ray.step.y, ray.origin.z + n * ray.step.z});
        for (const DenseArray<std::uint8_t>* labels : planes) {
            if (labels->contains(voxel) && pick.segments[labels->at(voxel)])
                return voxel;
        }
    }
    return std::nullopt;
}

} // namespace reference
