// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace core {

/// How an open edit ends: its changes stay, or everything is as before.
enum class Ending : std::uint8_t { Commit, Rollback };

} // namespace core
