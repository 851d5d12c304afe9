// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/SparedLabels.h"
#include "gpu/fields/VoxelFields.h"
#include "gpu/gl/Program.h"

namespace gpu {

/// Tells a program with spared.glsl what is not carved.
void setSpared(Program& program, const core::SparedLabels& spared);

/// Binds the label plane that it reads (unit 2), before each dispatch.
void bindSpared(VoxelFields& fields, const core::SparedLabels& spared);

} // namespace gpu
