// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <cstdint>

namespace core {

/// The meaning of a node's status (PS3.7 annex C, PS3.4): "it is out of resources (0xa700)".
[[nodiscard]] QString statusText(std::uint16_t status);

} // namespace core
