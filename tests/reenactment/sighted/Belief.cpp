// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/sighted/Belief.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace reenact {

namespace {

/// Farther off than this, readings say nothing about what lies between slices.
constexpr float mostOffMm = 15.0F;
/// How far around what is surely wrong a quarrel goes, in voxels.
constexpr int reach = 2;

/// What is set and hangs together with the cores, no farther than `reach` from them.
Mask grownWithin(const Mask& allowed, Mask cores)
{
    for (int round = 0; round < reach; ++round) {
        const Mask before = cores;
        std::size_t at = 0;
        for (int z = 0; z < allowed.size.z; ++z) {
            for (int y = 0; y < allowed.size.y; ++y) {
                for (int x = 0; x < allowed.size.x; ++x, ++at) {
                    if (allowed.values[at] == 0 || before.values[at] != 0)
                        continue;
                    for (int side = 0; side < 27 && cores.values[at] == 0; ++side) {
                        const glm::ivec3 near(
                            x + side % 3 - 1, y + side / 3 % 3 - 1, z + side / 9 - 1);
                        if (before.contains(near) && before.at(near) != 0)
                            cores.values[at] = 1;
                    }
                }
            }
        }
    }
    return cores;
}

} // namespace

Belief::Belief(const core::VolumeGeometry& geometry)
    : m_geometry(geometry)
{
}

void Belief::take(int slice, const SeenPlane& view)
{
    const int columns = m_geometry.size.x;
    const int rows = m_geometry.size.y;
    const glm::dvec2 spacing(m_geometry.spacingMm());
    const auto count = std::size_t(columns) * std::size_t(rows);
    std::vector<float> squares(count, mostOffMm * mostOffMm);
    std::vector<std::uint8_t> inside(count, 0);
    const glm::dmat4 toIndex = m_geometry.worldToIndex();
    for (const PlaneLine& line : view.readings) {
        std::vector<glm::dvec2> points;
        for (const glm::dvec3& place : line)
            points.emplace_back(toIndex * glm::dvec4(place, 1.0));
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::dvec2 from = points[i];
            const glm::dvec2 to = points[(i + 1) % points.size()];
            // Every voxel to the right of where a line crosses its row changes sides.
            const double low = std::min(from.y, to.y);
            const double high = std::max(from.y, to.y);
            for (int y = std::max(0, int(std::ceil(low))); y < rows && double(y) < high; ++y) {
                const double x = from.x + (double(y) - from.y) / (to.y - from.y) * (to.x - from.x);
                for (int at = std::max(0, int(std::floor(x)) + 1); at < columns; ++at)
                    inside[std::size_t(y * columns + at)] ^= 1;
            }
            const glm::dvec2 margin = double(mostOffMm) / spacing;
            const glm::ivec2 least =
                glm::max(glm::ivec2(glm::floor(glm::min(from, to) - margin)), glm::ivec2(0));
            const glm::ivec2 most = glm::min(glm::ivec2(glm::ceil(glm::max(from, to) + margin)),
                glm::ivec2(columns - 1, rows - 1));
            const glm::dvec2 way = (to - from) * spacing;
            const double length = glm::dot(way, way);
            for (int y = least.y; y <= most.y; ++y) {
                for (int x = least.x; x <= most.x; ++x) {
                    const glm::dvec2 off = (glm::dvec2(x, y) - from) * spacing;
                    const double share =
                        length > 0.0 ? std::clamp(glm::dot(off, way) / length, 0.0, 1.0) : 0.0;
                    const glm::dvec2 apart = off - share * way;
                    float& square = squares[std::size_t(y * columns + x)];
                    square = std::min(square, float(glm::dot(apart, apart)));
                }
            }
        }
    }
    Slice& read = m_slices[slice];
    read.isEmpty = view.readings.empty();
    read.offMm.resize(count);
    for (std::size_t at = 0; at < count; ++at)
        read.offMm[at] = (inside[at] != 0 ? -1.0F : 1.0F) * std::sqrt(squares[at]);
}

Mask Belief::organ() const
{
    const auto offOf = [](const Slice& slice, std::size_t at, float apartMm) {
        return slice.isEmpty ? apartMm : slice.offMm[at];
    };
    const glm::ivec3 size = m_geometry.size;
    const auto count = std::size_t(size.x) * std::size_t(size.y);
    Mask organ{size, std::vector<std::uint8_t>(count * std::size_t(size.z), 0)};
    for (auto above = m_slices.begin(); above != m_slices.end(); ++above) {
        const auto below = above == m_slices.begin() ? above : std::prev(above);
        // Where a slice shows nothing of the organ, it ends about halfway to the next.
        const auto apartMm = float(double(above->first - below->first) * m_geometry.spacingMm().z);
        for (int slice = above == below ? above->first : below->first + 1; slice <= above->first;
             ++slice) {
            const float share = above == below
                ? 1.0F
                : float(slice - below->first) / float(above->first - below->first);
            for (std::size_t at = 0; at < count; ++at) {
                const float off = (1.0F - share) * offOf(below->second, at, apartMm)
                    + share * offOf(above->second, at, apartMm);
                organ.values[std::size_t(slice) * count + at] = off < 0.0F ? 1 : 0;
            }
        }
    }
    return organ;
}

Mask meantOf(const Mask& seen, const Mask& organ, const core::VolumeGeometry& geometry)
{
    const double voxelMm = std::cbrt(geometry.voxelVolumeMm3());
    const Field offOrgan = signedDistance(organ);
    const Field offSeen = signedDistance(seen);
    const auto least = std::size_t(leastQuarrelShare * double(countOf(organ)));
    Mask meant = seen;
    for (const std::uint8_t wanted : {std::uint8_t(0), std::uint8_t(1)}) {
        Mask apart{seen.size, std::vector<std::uint8_t>(seen.values.size(), 0)};
        Mask cores = apart;
        for (std::size_t at = 0; at < seen.values.size(); ++at) {
            if (seen.values[at] == organ.values[at] || organ.values[at] != wanted)
                continue;
            apart.values[at] = 1;
            const double off = std::max(
                std::abs(double(offOrgan.values[at])), std::abs(double(offSeen.values[at])));
            cores.values[at] = off * voxelMm > leastQuarrelMm ? 1 : 0;
        }
        for (const MaskPart& part : partsOf(grownWithin(apart, cores))) {
            if (part.voxels.size() < std::max<std::size_t>(least, 4))
                continue;
            for (const glm::ivec3& voxel : part.voxels)
                meant.at(voxel) = wanted;
        }
    }
    return meant;
}

} // namespace reenact
