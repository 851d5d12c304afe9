// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core {

/// Delete a sculpt layer with what it has carved. Not the only one. Its number is not used again.
struct RemoveLayer {
    int layer = 0; ///< id
};

} // namespace core
