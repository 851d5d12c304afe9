// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/ProtectedLabels.h"
#include "gpu/fields/VoxelFields.h"
#include "gpu/gl/Program.h"

namespace gpu {

/// Sets the uniforms of a program that includes protected.glsl: which labels are protected from
/// carving.
void setProtected(
    Program& program, const VoxelFields& fields, const core::ProtectedLabels& protectedLabels);

/// Binds the label planes that protected.glsl reads (units 2 to 5); call it before each dispatch.
void bindProtected(VoxelFields& fields, const core::ProtectedLabels& protectedLabels);

} // namespace gpu
