// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/reference/fields/DenseFields.h"

namespace reference {

/// Radiation of a whole field of coverage, as core/sculpt/radiation/Radiation.h defines it.
[[nodiscard]] DenseArray<std::uint8_t> radiation(const DenseArray<std::uint8_t>& coverage);

} // namespace reference
