// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/growth/SeedSpread.h"
#include "tests/reference/fields/DenseFields.h"

namespace reference {

/// Gives voxels to the nearest seeds' labels (core::SpreadLabels). Errors: InvalidField (seeds of
/// fewer than two labels; nothing is changed then).
core::Result<void> spreadLabels(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const core::SpreadLabels& spread);

} // namespace reference
