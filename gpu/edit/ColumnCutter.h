// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/edit/BeforeImages.h"
#include "gpu/edit/MaskColumns.h"

#include <set>
#include <vector>

namespace gpu {

/// Lays the columns of a mask plane into the coverage of a layer (core/sculpt/MaskFrame.h, rule 6;
/// columnCut.comp). Engine thread only.
class ColumnCutter {
public:
    struct Target {
        std::uint8_t layer = 0;
        core::Laying laying = core::Laying::Carve;
    };
    /// @param cut the compiled kernel; used by one cutter at a time
    ColumnCutter(Program& cut, VoxelFields& fields, BeforeImages& before,
        const core::MaskFrame& frame, const Target& target);

    /// Lays what was set since the last time. Whoever calls tells VoxelFields.
    /// @return the bricks that changed, ascending
    [[nodiscard]] std::vector<std::uint32_t> lay(MaskColumns& columns);

    /// All that changed so far, ascending.
    [[nodiscard]] std::vector<std::uint32_t> touchedBricks() const;

private:
    [[nodiscard]] std::vector<std::uint32_t> bricksUnder(
        const std::vector<MaskColumns::PlaneBox>& boxes) const;

    Program& m_cut;
    VoxelFields& m_fields;
    BeforeImages& m_before;
    core::MaskFrame m_frame;
    Target m_target;
    std::set<std::uint32_t> m_touched;
};

} // namespace gpu
