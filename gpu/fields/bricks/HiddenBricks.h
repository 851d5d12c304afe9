// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/sculpt/IntegerHalfSpace.h"
#include "gpu/gl/Program.h"

#include <span>
#include <vector>

namespace gpu {

/// Sets the uniforms of a program that includes hidden.glsl: the half spaces whose voxels are
/// hidden.
void setHidden(Program& program, const std::vector<core::IntegerHalfSpace>& hidden);

/// For each candidate brick the values that hidden.glsl starts from. Bind the buffer to binding 6.
[[nodiscard]] Buffer hiddenBases(const std::vector<core::IntegerHalfSpace>& hidden,
    const core::BrickGrid& grid, std::span<const std::uint32_t> candidates);

} // namespace gpu
