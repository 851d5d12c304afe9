// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/MaskPeel.h"
#include "gpu/kernels/cut/ColumnCutter.h"
#include "gpu/kernels/cut/MaskPrograms.h"

namespace gpu {

/// One peel while its depth is being chosen (rules: core/sculpt/MaskPeel.h). Begun, it has cast its
/// elements and cut nothing. Engine thread only.
///
/// A depth costs the offset surface, on the processor, and the bricks under the mask; a lesser
/// depth than before puts them back first.
class PeelKernel {
public:
    PeelKernel(MaskPrograms& programs, VoxelFields& fields, BeforeImages& before,
        const core::MaskPeel& peel);

    void setDepth(std::int32_t depth);

    /// How deep the surface was looked for.
    [[nodiscard]] std::optional<std::int32_t> searchedTo() const { return m_cast.searchedTo; }
    /// Bricks whose coverage was changed at any depth.
    [[nodiscard]] std::vector<std::uint32_t> touchedBricks() const
    {
        return m_cutter.touchedBricks();
    }

private:
    VoxelFields& m_fields;
    BeforeImages& m_before;
    core::MaskPeel m_peel;
    MaskColumns m_columns;
    ColumnCutter m_cutter;
    MaskHits m_cast;
    core::PeelSheet m_sheet;
    std::int32_t m_depth = 0;
};

} // namespace gpu
