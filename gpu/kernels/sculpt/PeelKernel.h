// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/ShellPeel.h"
#include "gpu/kernels/cut/ColumnCutter.h"
#include "gpu/kernels/cut/CutPrograms.h"
#include "gpu/kernels/work/EditWork.h"

namespace gpu {

/// One peel while its depth is being chosen (the rules are in core/sculpt/ShellPeel.h). The
/// constructor casts rays from the mask's elements and cuts nothing. Engine thread only.
///
/// setDepth() computes the offset surface on the processor and cuts the bricks under the mask. For
/// a smaller depth than before it restores them first.
class PeelKernel final : public EditWork {
public:
    PeelKernel(CutPrograms& programs, VoxelFields& fields, BeforeImages& before,
        const core::ShellPeel& peel);

    core::Result<void> extend(const core::EngineExtension& extension) override;
    /// Of depths that wait, the last one counts.
    [[nodiscard]] bool join(
        core::EngineExtension& earlier, core::EngineExtension& next) const override;
    [[nodiscard]] std::vector<core::BrickKey> touchedKeys() const override;
    void finish(core::EngineResult& result) override;

private:
    void setDepth(std::int32_t depth);

    VoxelFields& m_fields;
    BeforeImages& m_before;
    core::ShellPeel m_peel;
    CutColumns m_columns;
    ColumnCutter m_cutter;
    RasterHits m_cast;
    core::PeelSheet m_sheet;
    std::int32_t m_depth = 0;
};

} // namespace gpu
