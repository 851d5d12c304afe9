// SPDX-License-Identifier: Apache-2.0
#include "core/metrics/SegmentGap.h"

#include "core/brick/BrickGrid.h"
#include "core/brick/LabelBox.h"
#include "core/metrics/CellDistances.h"
#include "core/volume/VolumeGeometry.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace core {

namespace {

std::size_t placeInMemory(const glm::ivec3& voxel, const glm::ivec3& size)
{
    return (std::size_t(voxel.z) * std::size_t(size.y) + std::size_t(voxel.y)) * std::size_t(size.x)
        + std::size_t(voxel.x);
}

/// The voxels of a segment's surface that lie in one brick, and the box around them.
struct SurfacePart {
    VoxelBox box{};
    std::vector<glm::ivec3> voxels{};
};

VoxelBox boxOf(const glm::ivec3& voxel)
{
    return {.minimum = voxel, .maximum = voxel + 1};
}

/// Voxels that have one of their six neighbours beside the segment, or beside the volume; some of
/// them if it was cancelled.
std::vector<SurfacePart> surfaceOf(std::span<const std::uint8_t> labels, std::uint8_t label,
    const glm::ivec3& size, const Progress& progress)
{
    const VoxelBox box = boxOfLabel(labels, size, label);
    const BrickGrid grid{size};
    std::map<int, SurfacePart> parts;
    const auto isOwn = [&](const glm::ivec3& at) {
        return at.x >= 0 && at.y >= 0 && at.z >= 0 && at.x < size.x && at.y < size.y
            && at.z < size.z && labels[placeInMemory(at, size)] == label;
    };
    const auto isInner = [&](const glm::ivec3& at) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const int step : {-1, 1}) {
                glm::ivec3 beside = at;
                beside[axis] += step;
                if (!isOwn(beside))
                    return false;
            }
        }
        return true;
    };
    for (int z = box.minimum.z; z < box.maximum.z && !progress.cancelled(); ++z) {
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            for (int x = box.minimum.x; x < box.maximum.x; ++x) {
                const glm::ivec3 at(x, y, z);
                if (!isOwn(at) || isInner(at))
                    continue;
                SurfacePart& part = parts[grid.brickOf(at)];
                part.box = part.box.united(boxOf(at));
                part.voxels.push_back(at);
            }
        }
    }
    std::vector<SurfacePart> all;
    for (auto& [brick, part] : parts)
        all.push_back(std::move(part));
    return all;
}

/// A voxel that both have.
std::optional<glm::ivec3> sharedVoxel(std::span<const std::uint8_t> labels, std::uint8_t label,
    std::span<const std::uint8_t> otherLabels, std::uint8_t otherLabel, const glm::ivec3& size)
{
    const VoxelBox box = boxOfLabel(labels, size, label);
    for (int z = box.minimum.z; z < box.maximum.z; ++z) {
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            for (int x = box.minimum.x; x < box.maximum.x; ++x) {
                const std::size_t voxel = placeInMemory({x, y, z}, size);
                if (labels[voxel] == label && otherLabels[voxel] == otherLabel)
                    return glm::ivec3(x, y, z);
            }
        }
    }
    return std::nullopt;
}

/// The nearest pair of voxels so far.
class Nearest {
public:
    Nearest(const CellDistances& distances, const glm::ivec3& size)
        : m_distances(distances)
        , m_size(size)
    {
    }

    [[nodiscard]] const glm::ivec3& from() const { return m_from; }
    [[nodiscard]] const glm::ivec3& to() const { return m_to; }
    /// Whether voxels of two boxes may be as near as the nearest ones.
    [[nodiscard]] bool mayBe(const VoxelBox& one, const VoxelBox& other) const
    {
        return m_distances.leastSquared(one, other) <= m_squared;
    }
    void look(const SurfacePart& one, const SurfacePart& other)
    {
        for (const glm::ivec3& from : one.voxels) {
            if (!mayBe(boxOf(from), other.box))
                continue;
            for (const glm::ivec3& to : other.voxels)
                take(from, to);
        }
    }

private:
    void take(const glm::ivec3& from, const glm::ivec3& to)
    {
        const std::int64_t squared = m_distances.squared(from, to);
        if (squared > m_squared)
            return;
        const auto placesOf = [this](const glm::ivec3& one, const glm::ivec3& other) {
            return std::pair(placeInMemory(one, m_size), placeInMemory(other, m_size));
        };
        if (squared == m_squared && placesOf(from, to) >= placesOf(m_from, m_to))
            return;
        m_squared = squared;
        m_from = from;
        m_to = to;
    }

    const CellDistances& m_distances;
    glm::ivec3 m_size;
    std::int64_t m_squared = std::numeric_limits<std::int64_t>::max();
    glm::ivec3 m_from{0};
    glm::ivec3 m_to{0};
};

/// The pair of parts that are nearest by their boxes: what is found in it rules most others out.
/// It may be another one if it was cancelled.
std::pair<std::size_t, std::size_t> mostPromising(const CellDistances& distances,
    const std::vector<SurfacePart>& parts, const std::vector<SurfacePart>& others,
    const Progress& progress)
{
    std::pair<std::size_t, std::size_t> best(0, 0);
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (std::size_t one = 0; one < parts.size() && !progress.cancelled(); ++one) {
        for (std::size_t other = 0; other < others.size(); ++other) {
            const std::int64_t bound = distances.leastSquared(parts[one].box, others[other].box);
            if (bound >= least)
                continue;
            least = bound;
            best = {one, other};
        }
    }
    return best;
}

} // namespace

Result<std::optional<SegmentGap>> segmentGap(std::span<const std::uint8_t> labels,
    std::uint8_t label, std::span<const std::uint8_t> otherLabels, std::uint8_t otherLabel,
    const VolumeGeometry& geometry, const Progress& progress)
{
    const glm::ivec3& size = geometry.size;
    if (const auto shared = sharedVoxel(labels, label, otherLabels, otherLabel, size)) {
        const glm::dvec3 place = geometry.toWorld(glm::dvec3(*shared));
        return SegmentGap{.fromLps = place, .toLps = place};
    }
    const std::vector<SurfacePart> parts = surfaceOf(labels, label, size, progress);
    const std::vector<SurfacePart> others = surfaceOf(otherLabels, otherLabel, size, progress);
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    if (parts.empty() || others.empty())
        return std::nullopt;
    const CellDistances distances(geometry);
    Nearest nearest(distances, size);
    const auto [first, second] = mostPromising(distances, parts, others, progress);
    nearest.look(parts[first], others[second]);
    for (const SurfacePart& one : parts) {
        for (const SurfacePart& other : others) {
            if (progress.cancelled())
                return failure(ErrorCode::Cancelled);
            if (nearest.mayBe(one.box, other.box))
                nearest.look(one, other);
        }
    }
    const glm::dvec3 half = 0.5 * glm::dvec3(glm::sign(nearest.to() - nearest.from()));
    return SegmentGap{.fromLps = geometry.toWorld(glm::dvec3(nearest.from()) + half),
        .toLps = geometry.toWorld(glm::dvec3(nearest.to()) - half)};
}

} // namespace core
