// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/sculpt/HiddenHalf.h"
#include "gpu/gl/Program.h"

#include <span>
#include <vector>

namespace gpu {

/// Tells a program with hidden.glsl what is hidden.
void setHidden(Program& program, const std::vector<core::HiddenHalf>& hidden);

/// What hidden.glsl knows of each candidate brick; bind it to binding 6.
[[nodiscard]] Buffer hiddenBases(const std::vector<core::HiddenHalf>& hidden,
    const core::BrickGrid& grid, std::span<const std::uint32_t> candidates);

} // namespace gpu
