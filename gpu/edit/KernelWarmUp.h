// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "gpu/edit/EditTransaction.h"
#include "gpu/textures/VolumeTextures.h"

#include <memory>

namespace gpu {

/// Runs the kernels of every tool once, in a small volume of its own, since drivers compile a
/// kernel only when it first runs. Engine thread only.
class KernelWarmUp {
public:
    /// @param programs both outlive this
    KernelWarmUp(EditPrograms& programs, FieldPrograms& fieldPrograms);

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
    void runGrowth();
    void runTolerance();

    EditPrograms& m_programs;
    VolumeTextures m_textures;
    std::unique_ptr<VoxelFields> m_fields;
    core::Document m_document;
    std::size_t m_done = 0;
};

} // namespace gpu
