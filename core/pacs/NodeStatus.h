// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"

#include <cstdint>

namespace core {

/// The meaning of a node's status (PS3.7 annex C, PS3.4): "it is out of resources (0xa700)".
[[nodiscard]] Clause statusText(std::uint16_t status);

} // namespace core
