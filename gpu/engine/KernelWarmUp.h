// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/delta/Ending.h"
#include "core/document/Document.h"
#include "core/sculpt/labels/EditableVoxels.h"
#include "gpu/engine/EditTransaction.h"
#include "gpu/fields/textures/VolumeTextures.h"

#include <memory>
#include <optional>

namespace gpu {

/// Runs the kernels of every tool once, in a small volume of its own: drivers compile a kernel only
/// when it first runs, and no stroke should wait for that. Engine thread only.
class KernelWarmUp {
public:
    enum class Of {
        AllTools,
        EditableRanges, ///< the kernels of edits of labels within an editable range
    };
    /// The size of a small volume for which the driver compiles the same code as for @p volumeSize.
    /// llvmpipe compiles separate code for textures whose sides, in voxels or in bricks, are powers
    /// of two.
    [[nodiscard]] static glm::ivec3 sizeLike(const glm::ivec3& volumeSize);

    /// @param programs both outlive this object
    /// @param size a result of sizeLike()
    KernelWarmUp(EditPrograms& programs, FieldPrograms& fieldPrograms, const glm::ivec3& size,
        Of kernels = Of::AllTools);

    /// Begins an edit of the next tool and rolls it back. Costs what the compilation costs, up to a
    /// few tenths of a second with a software driver.
    /// @return whether more tools are left
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
    void runBarriers();
    void runPaint(const std::optional<core::EditableVoxels>& editable);
    void relabel(const std::optional<core::EditableVoxels>& editable);
    void runPaintWithin();
    void runRelabellingWithin();

    EditPrograms& m_programs;
    Of m_kernels;
    VolumeTextures m_textures;
    std::unique_ptr<VoxelFields> m_fields;
    core::Document m_document;
    std::size_t m_done = 0;
};

} // namespace gpu
