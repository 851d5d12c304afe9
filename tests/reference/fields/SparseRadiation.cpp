// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/fields/SparseRadiation.h"

#include <algorithm>

namespace reference {

SparseField sparseRadiation(
    std::span<const SparsePoint> points, const glm::ivec3& origin, const glm::ivec3& size)
{
    const std::size_t count = std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
    SparseField field{
        {size, std::vector<std::uint32_t>(count)}, {size, std::vector<std::uint8_t>(count)}};
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::ivec3 voxel(x, y, z);
                std::uint32_t greatest = 0;
                for (const SparsePoint& point : points) {
                    const std::uint32_t part =
                        core::radiation::sparseContribution(point.footprint, origin + voxel);
                    field.sums.at(voxel) += part;
                    if (part == 0 || part < greatest)
                        continue;
                    std::uint8_t& label = field.labels.at(voxel);
                    label = part > greatest ? point.label : std::max(label, point.label);
                    greatest = part;
                }
            }
        }
    }
    return field;
}

} // namespace reference
