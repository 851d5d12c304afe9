// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/engine/KernelWarmUp.h"

#include <optional>
#include <vector>

namespace gpu {

/// What the engine does when nothing else is to be done: it derives fields from the voxels, and
/// makes ready what edits will need. Engine thread.
class IdleWork {
public:
    IdleWork(EditPrograms& programs, FieldPrograms& fieldPrograms);

    /// Has kernels run for volumes of such a size, once each.
    void warmUp(const glm::ivec3& volumeSize);
    /// Nothing is made ready any more.
    void stop() { m_warmUp.reset(); }
    /// One slice. @param fields null: no volume is open. @param editing a pen may be down
    /// @return whether more is to do
    [[nodiscard]] bool doSome(VoxelFields* fields, bool editing);

private:
    [[nodiscard]] bool warmUpMore();

    EditPrograms& m_programs;
    FieldPrograms& m_fieldPrograms;
    std::optional<KernelWarmUp> m_warmUp; ///< what is left to run for the first time
    std::vector<glm::ivec3> m_warmSizes; ///< of KernelWarmUp, that were run or are
};

} // namespace gpu
