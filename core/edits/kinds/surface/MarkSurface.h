// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/surface/SurfacePath.h"
#include "core/refine/mesh/SurfaceMark.h"

namespace core {

/// Paint what is thought of the surface.
struct MarkSurface {
    SurfaceMark mark = SurfaceMark::Red;
    SurfacePath path{};
};

} // namespace core
