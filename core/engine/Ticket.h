// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace core {

/// The number of a submitted command; tickets increase by 1.
using Ticket = std::uint64_t;

} // namespace core
