// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/EditKinds.h"

#include <optional>

namespace core {

struct SurfacePath;

/// Any edit that creates the surface that is refined, or works on it. Code that handles them has an
/// overload for each, so that a new kind does not compile until it is handled.
using SurfaceKinds = EditKinds<LaySurface, DropSurface, FollowMask, MarkSurface, ChangeMarks,
    SpherePush, PlaneScrape, PointDrag, ApplyTemplate, SmoothSurface, AttractSurface, WriteBack,
    SurfaceBarrier>;
using SurfaceEdit = VariantOfKinds<SurfaceKinds>::Type;
template <class E>
concept isSurfaceKind = (placeAmong<E>(SurfaceKinds()) < SurfaceKinds::count);

/// None if it is no such edit.
[[nodiscard]] std::optional<SurfaceEdit> surfaceEditOf(const Edit& edit);

/// The path of a tool of the surface: the member `path` of its edit; null if it has none.
[[nodiscard]] const SurfacePath* surfacePathOf(const Edit& edit);
[[nodiscard]] SurfacePath* surfacePathOf(Edit& edit);

} // namespace core
