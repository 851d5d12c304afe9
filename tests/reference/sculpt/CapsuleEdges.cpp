// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/sculpt/Capsules.h"

#include <algorithm>
#include <array>
#include <cstdlib>

// A brush that follows edges (core/sculpt/EdgeRegion.h).

namespace reference {

namespace {

std::int64_t rise14(std::int64_t value)
{
    return (value + 8192) >> 14;
}

DenseArray<std::uint8_t> noVoxels(const glm::ivec3& size)
{
    const std::size_t voxels = std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
    return {size, std::vector<std::uint8_t>(voxels, 0)};
}

} // namespace

bool Capsules::isWithin(const core::Capsule& capsule, const glm::ivec3& voxel) const
{
    const std::optional<std::int64_t> squared = distance(capsule, position(voxel));
    const std::int64_t radius =
        std::max<std::int64_t>(m_frame.radius - capsule.less, 0) >> m_frame.shift;
    return squared && *squared <= radius * radius;
}

int Capsules::edgeValue(const glm::ivec3& start) const
{
    std::vector<int> codes;
    for (int z = start.z - 1; z <= start.z + 1; ++z) {
        for (int y = start.y - 1; y <= start.y + 1; ++y) {
            for (int x = start.x - 1; x <= start.x + 1; ++x) {
                const glm::ivec3 voxel(x, y, z);
                if (!m_codes.contains(voxel))
                    continue;
                const bool isNear =
                    !m_frame.isFlat || std::abs(position(voxel)[2]) <= m_frame.halfThickness;
                if (isNear || voxel == start)
                    codes.push_back(m_codes.at(voxel));
            }
        }
    }
    std::sort(codes.begin(), codes.end());
    return codes.at((codes.size() - 1) / 2);
}

bool Capsules::areNeighbours(const glm::ivec3& step) const
{
    const int changed = std::abs(step.x) + std::abs(step.y) + std::abs(step.z);
    if (!m_frame.isFlat)
        return changed == 1;
    const std::array<std::int64_t, 3> rise{std::abs(rise14(m_frame.perI[2])),
        std::abs(rise14(m_frame.perJ[2])), std::abs(rise14(m_frame.perK[2]))};
    const auto main = int(std::max_element(rise.begin(), rise.end()) - rise.begin());
    return changed > 0 && changed - std::abs(step[main]) <= 1;
}

void Capsules::followEdges(const core::PaintLabel& paint, const core::CapsulePath& path)
{
    const glm::ivec3 size = m_codes.size;
    if (m_alike.values.empty()) {
        m_alike = noVoxels(size);
        m_under = noVoxels(size);
    }
    std::vector<glm::ivec3> all;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                all.emplace_back(x, y, z);
    const int value = edgeValue(paint.edges->start);
    for (const glm::ivec3& voxel : all) {
        const int code = m_codes.at(voxel);
        if (code < paint.lowCode || code > paint.highCode)
            continue;
        for (const core::Capsule& capsule : path.capsules) {
            const int tolerance = paint.edges->tolerance * capsule.strength / 255;
            if (std::abs(code - value) <= tolerance && isWithin(capsule, voxel))
                m_alike.at(voxel) = 1;
        }
    }
    for (const glm::ivec3& voxel : path.under) {
        if (m_under.contains(voxel))
            m_under.at(voxel) = 1;
    }
    std::vector<glm::ivec3> steps;
    for (int step = 0; step < 27; ++step) {
        const glm::ivec3 each(step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1);
        if (areNeighbours(each))
            steps.push_back(each);
    }
    DenseArray<std::uint8_t> members = noVoxels(size);
    for (bool changes = true; changes;) {
        changes = false;
        // To and fro, so that few passes are enough.
        for (const glm::ivec3& voxel : all) {
            if (!m_alike.at(voxel) || members.at(voxel))
                continue;
            const bool isReached = m_under.at(voxel)
                || std::any_of(steps.begin(), steps.end(), [&](const glm::ivec3& step) {
                       return members.contains(voxel + step) && members.at(voxel + step);
                   });
            members.at(voxel) = isReached;
            changes = changes || isReached;
        }
        std::reverse(all.begin(), all.end());
    }
    for (const glm::ivec3& voxel : all) {
        if (members.at(voxel))
            this->paint(paint, voxel);
    }
}

} // namespace reference
