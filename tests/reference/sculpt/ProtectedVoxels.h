// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/ProtectedLabels.h"
#include "tests/reference/fields/DenseFields.h"

#include <algorithm>
#include <bitset>
#include <cstdint>
#include <vector>

namespace reference {

/// Which voxels are protected from carving (core/sculpt/ProtectedLabels.h). Fields are borrowed.
class ProtectedVoxels {
public:
    ProtectedVoxels(DenseFields& fields, const core::ProtectedLabels& asked)
        : m_labels(asked.labels)
    {
        for (std::size_t plane = 0; plane < asked.planes.size(); ++plane) {
            if (asked.planes[plane])
                m_planes.push_back(&fields.labels(std::uint8_t(plane)));
        }
    }
    [[nodiscard]] bool hold(const glm::ivec3& voxel) const
    {
        return std::any_of(m_planes.begin(), m_planes.end(),
            [&](const DenseArray<std::uint8_t>* plane) { return m_labels[plane->at(voxel)]; });
    }

private:
    std::bitset<256> m_labels;
    std::vector<const DenseArray<std::uint8_t>*> m_planes;
};

} // namespace reference
