// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/DrillCut.h"
#include "gpu/kernels/cut/ColumnCutter.h"
#include "gpu/kernels/cut/CutColumns.h"
#include "gpu/kernels/cut/CutPrograms.h"
#include "gpu/kernels/cut/SurfaceCaster.h"
#include "gpu/kernels/work/EditWork.h"

#include <map>
#include <vector>

namespace gpu {

/// One drill stroke while the pen is down (the rules are in core/sculpt/DrillCut.h).
///
/// extend() casts rays from the elements that the mask reaches for the first time, cuts below those
/// that went deeper and updates radiation there. Cost ∝ what the new piece of path touches. Engine
/// thread only.
class DrillKernel final : public EditWork {
public:
    DrillKernel(CutPrograms& programs, VoxelFields& fields, BeforeImages& before,
        const core::DrillCut& cut);

    core::Result<void> extend(const core::EngineExtension& extension) override;
    [[nodiscard]] bool join(
        core::EngineExtension& earlier, core::EngineExtension& next) const override;
    [[nodiscard]] std::vector<core::BrickKey> touchedKeys() const override;
    void finish(core::EngineResult& result) override;

private:
    struct Element {
        glm::ivec2 at{0};
        bool cast = false;
        core::SurfaceHit hit;
        std::int32_t depth = 0;
        std::int64_t sum = 0; ///< mode Rate
    };
    /// An element of the mask plane under a sample.
    struct Touch {
        Element* element = nullptr;
        std::int32_t weight = 0;
    };
    struct Press {
        core::DrillSample sample;
        std::vector<Touch> touched;
    };

    void follow(const std::vector<core::DrillSample>& samples);
    [[nodiscard]] Press press(const core::DrillSample& sample);
    void castNew();
    void deepen(const Press& press);
    [[nodiscard]] std::int32_t farthestSurface(const Press& press) const;
    [[nodiscard]] Element& element(const glm::ivec2& at);

    VoxelFields& m_fields;
    core::DrillCut m_cut;
    CutColumns m_columns;
    SurfaceCaster m_caster;
    ColumnCutter m_cutter;
    std::map<std::pair<int, int>, std::vector<Element>> m_tiles; ///< of 16 × 16
    std::vector<Element*> m_uncast;
};

} // namespace gpu
