// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace core {

/// What becomes of all that an open edit has changed: it stays, or everything is as before.
enum class Ending : std::uint8_t { Commit, Rollback };

} // namespace core
