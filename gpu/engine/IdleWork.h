// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/engine/KernelWarmUp.h"

#include <optional>
#include <vector>

namespace gpu {

/// The work of the engine while no command waits: it updates fields that are derived from the
/// voxels, and runs kernels for the first time so that edits need not wait for their compilation.
/// Engine thread.
class IdleWork {
public:
    IdleWork(EditPrograms& programs, FieldPrograms& fieldPrograms);

    /// Requests that kernels are run once for volumes of such a size.
    void warmUp(const glm::ivec3& volumeSize);
    /// Cancels what warmUp() has requested and has not run yet.
    void stop() { m_warmUp.reset(); }
    /// Does one slice of work.
    /// @param fields null if no volume is open
    /// @param editing a pen may be down
    /// @return whether more is to do
    [[nodiscard]] bool doSome(VoxelFields* fields, bool editing);

private:
    [[nodiscard]] bool warmUpMore();

    EditPrograms& m_programs;
    FieldPrograms& m_fieldPrograms;
    std::optional<KernelWarmUp> m_warmUp; ///< kernels that were not run yet
    /// Sizes (KernelWarmUp::sizeLike()) that were run or are being run.
    std::vector<glm::ivec3> m_warmSizes;
};

} // namespace gpu
