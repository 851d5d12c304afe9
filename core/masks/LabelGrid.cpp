// SPDX-License-Identifier: Apache-2.0
#include "core/masks/LabelGrid.h"

#include "core/base/ParallelFor.h"
#include "core/masks/LatticeMap.h"
#include "core/masks/MaskParts.h"

#include <cmath>
#include <optional>

namespace core {

namespace {

using SliceLabels = std::map<int, VoxelRuns>;

/// Calls visit(i, place) along a row for each voxel of it.
template <class Visit>
void alongRow(const LatticeMap& map, int columns, int j, int k, const Visit& visit)
{
    LatticeMap::Place place = map.rowStart(j, k);
    for (int i = 0; i < columns; ++i) {
        visit(i, place);
        for (std::size_t axis = 0; axis < 3; ++axis)
            place[axis] += map.step()[axis];
    }
}

/// The index of the nearest voxel of a grid; none: it lies outside.
std::optional<std::size_t> nearestVoxel(const LatticeMap::Place& place, const glm::ivec3& size)
{
    std::int64_t index[3]{};
    for (int axis = 0; axis < 3; ++axis) {
        index[axis] = LatticeMap::nearest(place[std::size_t(axis)]);
        if (index[axis] < 0 || index[axis] >= size[axis])
            return std::nullopt;
    }
    return std::size_t((index[2] * size.y + index[1]) * size.x + index[0]);
}

SliceLabels labelsOfSlice(
    const glm::ivec3& size, const LabelGrid& grid, const LatticeMap& map, int k)
{
    SliceLabels found;
    for (int j = 0; j < size.y; ++j) {
        const std::uint64_t row =
            (std::uint64_t(k) * std::uint64_t(size.y) + std::uint64_t(j)) * std::uint64_t(size.x);
        int begun = 0;
        int label = 0;
        const auto end = [&](int i) {
            if (label != 0)
                found[label].append(row + std::uint64_t(begun), std::uint64_t(i - begun));
        };
        alongRow(map, size.x, j, k, [&](int i, const LatticeMap::Place& place) {
            const auto voxel = nearestVoxel(place, grid.geometry.size);
            const int here = voxel ? int(grid.labels[*voxel]) : 0;
            if (here == label)
                return;
            end(i);
            begun = i;
            label = here;
        });
        end(size.x);
    }
    return found;
}

/// How far a voxel reaches from its centre, in the volume's columns, rows and slices.
LatticeMap::Place halfVoxel(const VolumeGeometry& grid, const glm::dmat4& worldToIndex)
{
    const glm::dmat3 directions = glm::dmat3(worldToIndex) * glm::dmat3(grid.indexToWorld);
    LatticeMap::Place half{};
    for (int axis = 0; axis < 3; ++axis) {
        double reach = 0.0;
        for (int along = 0; along < 3; ++along)
            reach += std::abs(directions[along][axis]) / 2.0;
        half[std::size_t(axis)] = std::llround(reach * double(LatticeMap::one));
    }
    return half;
}

/// How many labelled voxels of the grid lie outside the volume; one that reaches into it does not.
std::uint64_t labelledOutside(const VolumeGeometry& volume, const LabelGrid& grid, bool oneToOne)
{
    const LatticeMap back(grid.geometry, volume.worldToIndex());
    if (!back.isSound())
        return 0;
    LatticeMap::Place margin{};
    if (!oneToOne)
        margin = halfVoxel(grid.geometry, volume.worldToIndex());
    const glm::ivec3 size = grid.geometry.size;
    const auto isOutside = [&](const LatticeMap::Place& place) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (LatticeMap::nearest(place[axis] + margin[axis]) < 0
                || LatticeMap::nearest(place[axis] - margin[axis]) >= volume.size[int(axis)])
                return true;
        }
        return false;
    };
    std::vector<std::uint64_t> outside(std::size_t(size.z), 0);
    parallelFor(size.z, [&](int k) {
        for (int j = 0; j < size.y; ++j) {
            const std::size_t row =
                (std::size_t(k) * std::size_t(size.y) + std::size_t(j)) * std::size_t(size.x);
            alongRow(back, size.x, j, k, [&](int i, const LatticeMap::Place& place) {
                if (grid.labels[row + std::size_t(i)] != 0 && isOutside(place))
                    ++outside[std::size_t(k)];
            });
        }
    });
    std::uint64_t sum = 0;
    for (const std::uint64_t count : outside)
        sum += count;
    return sum;
}

} // namespace

Result<std::vector<std::uint16_t>> labelsFrom(std::span<const char> bytes, ScalarType type,
    double slope, double intercept, int layers, int layer, const QString& path)
{
    const StoredAt stored = storedAtFor(type);
    const std::size_t voxels = bytes.size() / bytesPerScalar(type) / std::size_t(layers);
    std::vector<std::uint16_t> labels(voxels);
    for (std::size_t voxel = 0; voxel < voxels; ++voxel) {
        const std::size_t place = voxel * std::size_t(layers) + std::size_t(layer);
        const double value = slope * stored(bytes.data(), place) + intercept;
        if (!(value >= 0.0 && value <= 65535.0) || value != std::floor(value))
            return holdsNoLabels(path, value);
        labels[voxel] = std::uint16_t(value);
    }
    return labels;
}

Result<LabelsOnVolume> labelsOn(
    const VolumeGeometry& volume, const LabelGrid& grid, const QString& path)
{
    const LatticeMap map(volume, grid.geometry.worldToIndex());
    if (!map.isSound())
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("its voxels are out of all proportion to the study's"));
    std::vector<SliceLabels> slices(std::size_t(volume.size.z));
    parallelFor(volume.size.z,
        [&](int k) { slices[std::size_t(k)] = labelsOfSlice(volume.size, grid, map, k); });
    LabelsOnVolume result;
    result.oneToOne = map.isOneToOne();
    for (const SliceLabels& slice : slices) {
        for (const auto& [label, voxels] : slice)
            result.voxels[label].append(voxels);
    }
    for (const std::uint16_t label : grid.labels)
        result.labelled += label != 0 ? 1 : 0;
    result.outside = labelledOutside(volume, grid, result.oneToOne);
    return result;
}

} // namespace core
