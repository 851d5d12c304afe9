// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/engine/KernelWarmUp.h"

#include <deque>
#include <utility>
#include <vector>

namespace gpu {

/// The work of the engine while no command waits: it updates fields that are derived from the
/// voxels, and runs kernels for the first time so that edits need not wait for their compilation.
/// Engine thread.
class IdleWork {
public:
    IdleWork(EditPrograms& programs, FieldPrograms& fieldPrograms);

    /// Requests that kernels are run once for volumes of such a size.
    void warmUp(
        const glm::ivec3& volumeSize, KernelWarmUp::Of kernels = KernelWarmUp::Of::AllTools);
    /// Cancels what warmUp() has requested and has not run yet.
    void stop() { m_warmUps.clear(); }
    /// Does one slice of work.
    /// @param fields null if no volume is open
    /// @param editing a pen may be down
    /// @return whether more is to do
    [[nodiscard]] bool doSome(VoxelFields* fields, bool editing);

private:
    [[nodiscard]] bool warmUpMore();

    EditPrograms& m_programs;
    FieldPrograms& m_fieldPrograms;
    std::deque<KernelWarmUp> m_warmUps; ///< requested, with kernels that were not run yet
    /// Kernels that were run or are being run, and for which size (KernelWarmUp::sizeLike()).
    std::vector<std::pair<KernelWarmUp::Of, glm::ivec3>> m_warm;
};

} // namespace gpu
