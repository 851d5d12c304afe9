// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace core {

/// The version of the rules by which an edit of the surface is carried out. New edits get the
/// newest version. An edit without a version comes from an older recipe or session and is carried
/// out by the rules of that time.
/// - 1, or none: the surface may pass through itself.
/// - 2: it never does (core/refine/repair/CrossingGuard.h), except where it did before. The sphere
///   and the plane affect only the sheet of the surface under the pen. A surface that passes
///   through itself is neither accepted when it is laid (LaySurface.h) nor written back.
/// - 3: in addition, a template forms a body through any mixture of open and closed contours, and
///   evens out the unsteadiness of the hand.
/// - 4: in addition, a surface that is laid with as many vertices as it takes may get twice as many
///   as before (core/refine/deform/RefineSurface.h), so that it follows bones.
using SurfaceRules = std::optional<int>;
constexpr int newestSurfaceRules = 4;

/// Argument 0 of the error InvalidField when a surface is refused because it passes through itself;
/// argument 1 is the number of pairs of faces that do.
inline constexpr const char* crossingSurface = "surface.crossings";

[[nodiscard]] inline bool keepsApart(const SurfaceRules& rules)
{
    return rules.value_or(1) >= 2;
}

/// Whether a template may contain open contours.
[[nodiscard]] inline bool mixesContours(const SurfaceRules& rules)
{
    return rules.value_or(1) >= 3;
}

/// Whether a surface may be laid with mostVertices, not mostVerticesOnce.
[[nodiscard]] inline bool laysFiner(const SurfaceRules& rules)
{
    return rules.value_or(1) >= 4;
}

} // namespace core
