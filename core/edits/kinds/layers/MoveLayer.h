// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core {

/// Put a sculpt layer at another place of the list.
struct MoveLayer {
    int layer = 0; ///< id
    int place = 0; ///< 1: first; beyond the end: last
};

} // namespace core
