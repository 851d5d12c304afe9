// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/LaserCut.h"
#include "gpu/fields/bricks/PlaneBricks.h"
#include "gpu/kernels/cut/CoverageWriter.h"
#include "gpu/kernels/cut/SurfaceCaster.h"
#include "gpu/kernels/work/EditWork.h"

#include <map>
#include <set>
#include <vector>

namespace gpu {

/// The compiled kernels of the laser.
struct LaserPrograms {
    explicit LaserPrograms(const ShaderLibrary& library);

    Program cast;
    Program gradient;
    Program exit;
    Program cut;
};

/// One stroke of the laser while the pen is down (the rules are in core/sculpt/LaserCut.h).
///
/// extend() makes the new beams, cuts along beams that are new or went deeper and updates radiation
/// there. Cost ∝ these beams. Engine thread only.
class LaserKernel final : public EditWork {
public:
    LaserKernel(LaserPrograms& programs, VoxelFields& fields, BeforeImages& before,
        const core::LaserCut& cut);

    core::Result<void> extend(const core::EngineExtension& extension) override;
    [[nodiscard]] bool join(
        core::EngineExtension& earlier, core::EngineExtension& next) const override;
    [[nodiscard]] std::vector<core::BrickKey> touchedKeys() const override;
    void finish(core::EngineResult& result) override;

private:
    /// The sum of what the samples in one element demand.
    struct Press {
        std::int32_t deepest = 0;
        std::int64_t sum = 0; ///< mode Rate
    };
    struct Beam {
        glm::ivec2 element{0};
        core::LaserBeam lies;
        std::int32_t exit = core::SurfaceHit::none;
        std::int32_t depth = 0;
        std::int64_t dose = 0; ///< mode Rate
    };
    using Place = std::pair<int, int>; ///< of an element

    void follow(const std::vector<core::DrillSample>& samples);
    void makeBeams(const std::vector<glm::ivec2>& elements);
    void findGradients(std::vector<Beam>& fresh, const std::vector<std::int32_t>& surfaces);
    void findExits(std::vector<Beam>& fresh, const std::vector<glm::ivec3>& feet);
    [[nodiscard]] std::vector<std::size_t> deepen(const std::map<Place, Press>& more);
    void lay(const std::vector<std::size_t>& beams);
    [[nodiscard]] std::vector<std::uint32_t> bricksOf(const Beam& beam) const;

    LaserPrograms& m_programs;
    VoxelFields& m_fields;
    core::LaserCut m_cut;
    SurfaceCaster m_caster;
    CoverageWriter m_writer;
    Buffer m_mask;
    std::map<Place, Press> m_presses;
    std::vector<Beam> m_beams;
};

} // namespace gpu
