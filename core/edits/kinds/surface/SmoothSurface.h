// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/surface/SurfacePath.h"

namespace core {

/// Even the surface out.
struct SmoothSurface {
    SurfacePath path{};
};

} // namespace core
