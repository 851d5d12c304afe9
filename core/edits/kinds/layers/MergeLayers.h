// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core {

/// Lay what a layer has carved into another one, by the greater value, and delete it. Both carve,
/// or neither does, so that nothing looks different.
struct MergeLayers {
    int from = 0; ///< id
    int into = 0; ///< id
};

} // namespace core
