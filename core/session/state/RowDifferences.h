// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/past/GrowthTrace.h"

#include <vector>

namespace core {

/// The differences of a row, read from where they are kept.
struct RowDifferences {
    std::vector<BrickImage> images; ///< XOR images, each with its bytes
    std::vector<ChangedWords> words; ///< where seed words differ in them, if requested
};

} // namespace core
