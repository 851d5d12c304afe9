// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edits.h"

namespace core {

/// Whether an edit works on the surface that is being refined, or lays it: SurfaceEdits.h.
[[nodiscard]] bool isOfSurface(const Edit& edit);

/// The way of a tool of the surface; null: it has none.
[[nodiscard]] const SurfacePath* surfacePathOf(const Edit& edit);
[[nodiscard]] SurfacePath* surfacePathOf(Edit& edit);

} // namespace core
