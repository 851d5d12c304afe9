// SPDX-License-Identifier: Apache-2.0
#include "core/measure/region/RegionStatistics.h"

#include "core/measure/region/RegionVoxels.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace core {

void RegionTally::add(std::span<const std::uint16_t> codes)
{
    for (const std::uint16_t code : codes)
        ++m_ofCode[code];
}

std::optional<RegionStatistics> RegionTally::statistics(const VoxelEncoding& encoding) const
{
    RegionStatistics found;
    std::int64_t sum = 0;
    int least = VoxelEncoding::codeCount;
    int greatest = 0;
    for (int code = 0; code < VoxelEncoding::codeCount; ++code) {
        const std::int64_t many = m_ofCode[std::size_t(code)];
        if (many == 0)
            continue;
        found.voxels += many;
        sum += many * code;
        least = std::min(least, code);
        greatest = code;
    }
    if (found.voxels == 0)
        return std::nullopt;
    const double meanCode = double(sum) / double(found.voxels);
    double squares = 0.0;
    for (int code = least; code <= greatest; ++code)
        squares += double(m_ofCode[std::size_t(code)]) * (code - meanCode) * (code - meanCode);
    // Values are linear in codes, and a greater code is a greater value.
    const double step = encoding.rescaleSlope * encoding.storedStep;
    found.mean = encoding.value(0) + step * meanCode;
    found.deviation = std::abs(step) * std::sqrt(squares / double(found.voxels));
    found.minimum = encoding.value(least);
    found.maximum = encoding.value(greatest);
    return found;
}

std::optional<double> RegionTally::percentile(int percent, const VoxelEncoding& encoding) const
{
    const std::int64_t all = std::accumulate(m_ofCode.begin(), m_ofCode.end(), std::int64_t(0));
    if (all == 0)
        return std::nullopt;
    const std::int64_t rank = std::max<std::int64_t>((all * percent + 99) / 100, 1);
    std::int64_t counted = 0;
    int code = -1;
    while (counted < rank)
        counted += m_ofCode[std::size_t(++code)];
    return encoding.value(code);
}

std::optional<RegionStatistics> regionStatistics(
    const Measurement& measurement, const Volume& volume, std::span<const std::uint16_t> codes)
{
    const VolumeGeometry& geometry = volume.geometry;
    const auto codeAt = [&](const glm::ivec3& voxel) {
        return codes[(std::size_t(voxel.z) * std::size_t(geometry.size.y) + std::size_t(voxel.y))
                * std::size_t(geometry.size.x)
            + std::size_t(voxel.x)];
    };
    const RegionVoxels region(measurement, geometry);
    RegionTally tally;
    std::vector<std::uint16_t> read;
    for (const glm::ivec3& voxel : region.samples())
        read.push_back(codeAt(voxel));
    tally.add(read);
    for (const VoxelBox& box : region.boxes()) {
        read.clear();
        for (int z = box.minimum.z; z < box.maximum.z; ++z) {
            for (int y = box.minimum.y; y < box.maximum.y; ++y) {
                for (int x = box.minimum.x; x < box.maximum.x; ++x)
                    read.push_back(codeAt({x, y, z}));
            }
        }
        tally.add(region.codesInside(box, read));
    }
    return tally.statistics(volume.encoding);
}

} // namespace core
