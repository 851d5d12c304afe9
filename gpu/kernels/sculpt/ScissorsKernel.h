// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/OutlineCut.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/kernels/cut/CutPrograms.h"
#include "gpu/kernels/work/EditWork.h"

namespace gpu {

/// Carries out core::OutlineCut, as one gather over the bricks below the mask; it is complete as
/// soon as it has begun. Engine thread only.
class ScissorsKernel final : public EditWork {
public:
    ScissorsKernel(CutPrograms& programs, VoxelFields& fields, BeforeImages& before,
        const core::OutlineCut& scissors);

    [[nodiscard]] std::vector<core::BrickKey> touchedKeys() const override;
    void finish(core::EngineResult& result) override;

private:
    std::vector<core::BrickKey> m_changed;
    std::optional<std::int32_t> m_searchedTo; ///< how deep the surface was looked for
};

} // namespace gpu
