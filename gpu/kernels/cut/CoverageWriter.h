// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/MaskFrame.h"
#include "gpu/fields/BeforeImages.h"

#include <set>
#include <vector>

namespace gpu {

/// What kernels share that lay cuts into the coverage of one layer (coverageWrite.glsl): images of
/// what was there before, pages, and which bricks changed. Engine thread only.
class CoverageWriter {
public:
    struct Target {
        std::uint8_t layer = 0;
        core::Laying laying = core::Laying::Carve;
        core::SparedLabels spared{};
    };
    CoverageWriter(VoxelFields& fields, BeforeImages& before, const Target& target);

    /// Tells a program with coverageWrite.glsl how to lay its cuts.
    void prepare(Program& program) const;
    /// Leaves out bricks that nothing can happen to, keeps what the others hold, gives them pages
    /// and binds them (units 1 and 2, image 0).
    /// @param candidates ascending
    [[nodiscard]] std::vector<std::uint32_t> begin(std::vector<std::uint32_t> candidates);
    /// Once the kernel is through. @param flags one for each that begin() left: not 0, it changed
    /// @return the bricks that changed, ascending; whoever calls tells VoxelFields
    [[nodiscard]] std::vector<std::uint32_t> end(const std::vector<std::uint32_t>& flags);

    /// All that changed so far, ascending.
    [[nodiscard]] std::vector<std::uint32_t> touchedBricks() const;

private:
    [[nodiscard]] bool refills() const { return m_target.laying == core::Laying::Refill; }

    VoxelFields& m_fields;
    BeforeImages& m_before;
    Target m_target;
    std::vector<std::uint32_t> m_candidates;
    std::vector<std::uint32_t> m_fresh; ///< had no page
    std::set<std::uint32_t> m_touched;
};

} // namespace gpu
