// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/surface/SurfacePath.h"

namespace core {

/// The vertex nearest to the first point is drawn along, and what is around it like a rubber sheet.
struct PointDrag {
    SurfacePath path{};
};

} // namespace core
