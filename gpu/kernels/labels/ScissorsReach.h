// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/kernels/labels/LabelKernel.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace gpu {

/// How far each element of scissors reaches (core/sculpt/labels/LabelScissors.h, rules 1 and 4),
/// found by a ray for each where that depends on what they meet (scissorsCast.comp). No label may
/// change before all are cast. Engine thread only.
class ScissorsReach {
public:
    /// @param edit outlives it
    ScissorsReach(LabelPrograms& programs, VoxelFields& fields, const core::LabelScissors& edit);

    [[nodiscard]] bool isKnown() const { return bool(m_reach); }
    /// Casts the rays of up to so many further elements; the last ones make it known.
    void advance(std::size_t elements);
    /// mm16, in the order of the mask; only once it is known.
    [[nodiscard]] const Buffer& buffer() const { return m_reach; }

private:
    struct Rays {
        std::vector<std::size_t> elements; ///< places in the mask
        std::vector<glm::ivec4> origins; ///< index16 at sample 0
        std::vector<glm::ivec2> samples; ///< in the volume and not hidden: first, one past the last
    };
    [[nodiscard]] Rays raysUpTo(std::size_t end);
    void cast(const Rays& rays);
    void finish();

    LabelPrograms& m_programs;
    VoxelFields& m_fields;
    const core::LabelScissors& m_edit;
    std::size_t m_next = 0; ///< element of the mask whose ray is next
    std::vector<std::int32_t> m_surfaces; ///< by element
    Buffer m_concerned; ///< by brick
    Buffer m_reach;
};

} // namespace gpu
