// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/past/GrowthTrace.h"

#include <vector>

namespace core {

/// What a row changed, as it comes from where it is kept.
struct RowDifferences {
    std::vector<BrickImage> images; ///< XOR, every one with its bytes
    std::vector<ChangedWords> words; ///< where in them seed words differ, if that was asked
};

} // namespace core
