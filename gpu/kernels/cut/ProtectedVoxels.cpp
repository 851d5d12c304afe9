// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/cut/ProtectedVoxels.h"

namespace gpu {

void setProtected(Program& program, const core::ProtectedLabels& protectedLabels)
{
    program.set("protectsAny", protectedLabels.labels.any())
        .set("protectedLabels", protectedLabels.labels);
}

void bindProtected(VoxelFields& fields, const core::ProtectedLabels& protectedLabels)
{
    fields.labels(protectedLabels.plane).bindUnit(2);
}

} // namespace gpu
