// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/surface/SurfacePath.h"

namespace core {

/// Draw the surface to where values change most.
struct AttractSurface {
    SurfacePath path{};
};

} // namespace core
