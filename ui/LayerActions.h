// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

namespace ui {

class Workspace;

/// Adds a sculpt layer named "Sculpt 2" or so and makes it the active one. @return its id
core::Result<int> addLayer(Workspace& workspace);

} // namespace ui
