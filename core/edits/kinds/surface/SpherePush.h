// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/surface/SurfacePath.h"

namespace core {

/// A ball pushes the surface out from inside of it, and in from outside.
struct SpherePush {
    SurfacePath path{};
};

} // namespace core
