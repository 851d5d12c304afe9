// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/cut/SparedVoxels.h"

namespace gpu {

void setSpared(Program& program, const core::SparedLabels& spared)
{
    program.set("sparesAny", spared.labels.any()).set("spared", spared.labels);
}

void bindSpared(VoxelFields& fields, const core::SparedLabels& spared)
{
    fields.labels(spared.plane).bindUnit(2);
}

} // namespace gpu
