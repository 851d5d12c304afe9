// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace core {

/// "Undo only here": takes back older rows of the history and leaves what came after them. Their
/// bricks must not have been written or read since (session/past/RowReach.h).
struct RevertRows {
    std::vector<std::int64_t> rows{}; ///< RowId, ascending
};

} // namespace core
