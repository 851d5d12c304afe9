// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/parts/HiddenSides.h"
#include "core/edits/kinds/parts/SparedSegments.h"

namespace core {

/// Carves, or restores what was carved, along a path.
struct BrushStroke {
    int layer = 1;
    BrushPath path{};
    bool restore = false;
    HiddenSides hidden{};
    SparedSegments spared{};
};

} // namespace core
