// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/BrushPath.h"

#include <optional>

namespace core {

/// Paints a segment, or erases it, along a path.
struct PaintStroke {
    int segment = 0; ///< label
    BrushPath path{};
    bool erase = false;
    std::optional<double> lower{}; ///< modality units, inclusive; none: any
    std::optional<double> upper{};
    bool overwriteUnlocked = false;
    bool seeds = false; ///< what is painted takes part in growth: it goes on from there
};

} // namespace core
