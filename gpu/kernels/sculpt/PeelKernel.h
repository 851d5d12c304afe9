// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/MaskPeel.h"
#include "gpu/kernels/cut/ColumnCutter.h"
#include "gpu/kernels/cut/MaskPrograms.h"
#include "gpu/kernels/work/EditWork.h"

namespace gpu {

/// One peel while its depth is being chosen (rules: core/sculpt/MaskPeel.h). Begun, it has cast its
/// elements and cut nothing. Engine thread only.
///
/// A depth costs the offset surface, on the processor, and the bricks under the mask; a lesser
/// depth than before puts them back first.
class PeelKernel final : public EditWork {
public:
    PeelKernel(MaskPrograms& programs, VoxelFields& fields, BeforeImages& before,
        const core::MaskPeel& peel);

    core::Result<void> extend(const core::EngineExtension& extension) override;
    [[nodiscard]] std::vector<core::BrickKey> touchedKeys() const override;
    void finish(core::EngineResult& result) override;

private:
    void setDepth(std::int32_t depth);

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
