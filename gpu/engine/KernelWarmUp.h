// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "gpu/engine/EditTransaction.h"
#include "gpu/fields/textures/VolumeTextures.h"

#include <memory>

namespace gpu {

/// Runs the kernels of every tool once, in a small volume of its own, since drivers compile a
/// kernel only when it first runs. Engine thread only.
class KernelWarmUp {
public:
    /// The size of a small volume for whose textures a driver compiles what it will need for those
    /// of this one: llvmpipe has code of its own for sides that are powers of two, of voxels and of
    /// bricks.
    [[nodiscard]] static glm::ivec3 sizeLike(const glm::ivec3& volumeSize);

    /// @param programs both outlive this @param size one of sizeLike()
    KernelWarmUp(EditPrograms& programs, FieldPrograms& fieldPrograms, const glm::ivec3& size);

    /// The next tool, begun and rolled back. Costs what its compilation costs, up to a few tenths
    /// of a second with a software driver. @return whether more are left
    [[nodiscard]] bool runNext();

private:
    void run(const core::EngineEdit& edit, const std::vector<core::EngineExtension>& extensions,
        core::Ending ending = core::Ending::Rollback);
    void runDrill();
    void runLaser();
    void runPeel();
    void runScissors();
    void runBrushes();
    void runTakingGrowth();
    void runGrowth();
    void runTolerance();
    void runRelabelling();
    void runShutting();

    EditPrograms& m_programs;
    VolumeTextures m_textures;
    std::unique_ptr<VoxelFields> m_fields;
    core::Document m_document;
    std::size_t m_done = 0;
};

} // namespace gpu
