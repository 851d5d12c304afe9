// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/BrushPath.h"

namespace core {

/// Shut places to growth, or open them again.
struct BarrierStroke {
    BrushPath path{};
    bool erase = false;
};

} // namespace core
