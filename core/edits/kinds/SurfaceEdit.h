// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/EditKinds.h"

#include <optional>

namespace core {

struct SurfacePath;

/// Any one edit that works on the surface that is being refined, or lays it.
using SurfaceKinds = EditKinds<LaySurface, DropSurface, FollowMask, MarkSurface, ChangeMarks,
    SpherePush, PlaneScrape, PointDrag, ApplyTemplate, SmoothSurface, AttractSurface, WriteBack,
    SurfaceBarrier>;
using SurfaceEdit = VariantOfKinds<SurfaceKinds>::Type;

/// None: it is no such edit.
[[nodiscard]] std::optional<SurfaceEdit> surfaceEditOf(const Edit& edit);

/// The way of a tool of the surface; null: it has none.
[[nodiscard]] const SurfacePath* surfacePathOf(const Edit& edit);
[[nodiscard]] SurfacePath* surfacePathOf(Edit& edit);

} // namespace core
