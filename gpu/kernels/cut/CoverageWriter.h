// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/CutFrame.h"
#include "gpu/fields/BeforeImages.h"

#include <set>
#include <vector>

namespace gpu {

/// The part that is common to all kernels which cut into the coverage of one sculpt layer
/// (coverageWrite.glsl): it saves before-images, gives pages and finds out which bricks changed.
/// Engine thread only.
class CoverageWriter {
public:
    struct Target {
        std::uint8_t layer = 0;
        core::Laying laying = core::Laying::Carve;
        core::ProtectedLabels protectedLabels{};
    };
    CoverageWriter(VoxelFields& fields, BeforeImages& before, const Target& target);

    /// Sets the uniforms of a program that includes coverageWrite.glsl.
    void prepare(Program& program) const;
    /// Drops candidates that cannot change, saves the voxels of the others, gives them pages and
    /// binds them (units 1 to 5, image 0).
    [[nodiscard]] std::vector<std::uint32_t> begin(std::vector<std::uint32_t> candidates);
    /// To be called after the kernel has run.
    /// @param flags one for each brick that begin() returned; not 0 if it changed
    /// @return the bricks that changed, ascending; the caller tells VoxelFields
    [[nodiscard]] std::vector<std::uint32_t> end(const std::vector<std::uint32_t>& flags);

    /// All bricks that changed so far, ascending.
    [[nodiscard]] std::vector<std::uint32_t> touchedBricks() const;

private:
    [[nodiscard]] bool refills() const { return m_target.laying == core::Laying::Refill; }

    VoxelFields& m_fields;
    BeforeImages& m_before;
    Target m_target;
    std::vector<std::uint32_t> m_candidates;
    std::vector<std::uint32_t> m_fresh; ///< candidates that had no page
    std::set<std::uint32_t> m_touched;
};

} // namespace gpu
