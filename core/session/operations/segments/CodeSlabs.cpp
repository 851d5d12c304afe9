// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/segments/CodeSlabs.h"

#include <algorithm>
#include <cstdint>

namespace core {

namespace {

constexpr std::int64_t codesAtOnce = 1 << 21; // of two bytes

} // namespace

std::optional<VoxelBox> CodeSlabs::take()
{
    if (m_left.empty())
        return std::nullopt;
    VoxelBox slab = m_left;
    const glm::ivec3 extent = slab.maximum - slab.minimum;
    const int slices = std::max(1, int(codesAtOnce / (std::int64_t(extent.x) * extent.y)));
    slab.maximum.z = std::min(slab.minimum.z + slices, slab.maximum.z);
    m_left.minimum.z = slab.maximum.z;
    return slab;
}

} // namespace core
