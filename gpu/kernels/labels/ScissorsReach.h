// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/kernels/labels/LabelKernel.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace gpu {

/// Computes how far the cut of scissors reaches at each element of its mask
/// (core/sculpt/labels/LabelScissors.h, rules 1 and 4). Where that depends on the first surface,
/// one ray per element finds it (scissorsCast.comp). No label may change before all rays are cast.
/// Engine thread only.
class ScissorsReach {
public:
    /// @param edit must outlive this
    ScissorsReach(LabelPrograms& programs, VoxelFields& fields, const core::LabelScissors& edit);

    /// Whether the reach of all elements is computed.
    [[nodiscard]] bool isKnown() const { return bool(m_reach); }
    /// Casts the rays of up to @p elements further elements of the mask.
    void advance(std::size_t elements);
    /// The reach of each element in mm16 (2⁻¹⁶ mm), in the order of the mask. @pre isKnown()
    [[nodiscard]] const Buffer& buffer() const { return m_reach; }

private:
    struct Rays {
        std::vector<std::size_t> elements; ///< indices into the mask
        std::vector<glm::ivec4> origins; ///< index16 (2⁻¹⁶ voxel) at sample 0
        /// Samples in the volume that are not clipped away: first, one past the last.
        std::vector<glm::ivec2> samples;
    };
    [[nodiscard]] Rays raysUpTo(std::size_t end);
    void cast(const Rays& rays);
    void finish();

    LabelPrograms& m_programs;
    VoxelFields& m_fields;
    const core::LabelScissors& m_edit;
    std::size_t m_next = 0; ///< element of the mask whose ray is cast next
    std::vector<std::int32_t> m_surfaces; ///< depth of the first surface by element, mm16
    Buffer m_concerned; ///< by brick: 0 if no voxel of it can be met
    Buffer m_reach;
};

} // namespace gpu
