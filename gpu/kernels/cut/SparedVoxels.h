// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/SparedLabels.h"
#include "gpu/fields/VoxelFields.h"
#include "gpu/gl/Program.h"

namespace gpu {

/// Sets the uniforms of a program that includes spared.glsl: the labels that are protected from
/// carving.
void setSpared(Program& program, const core::SparedLabels& spared);

/// Binds the label plane that spared.glsl reads (unit 2); call it before each dispatch.
void bindSpared(VoxelFields& fields, const core::SparedLabels& spared);

} // namespace gpu
