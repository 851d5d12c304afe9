// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace core {

/// The rules by which an edit of the surface is carried out. New edits are given the newest ones;
/// an edit that names none is of a recipe or session of before and is carried out as it was then.
///
///   1 (or none)  the surface may pass through itself
///   2            it never does (core/refine/repair/CrossingGuard.h), apart from where it did
///                before; sphere and plane hold only the sheet under the pen; what passes through
///                itself is not laid and not written back
///   3            and a template is a body through any mixture of open and closed contours, which
///                evens out what the hand was unsteady
using SurfaceRules = std::optional<int>;
constexpr int newestSurfaceRules = 3;

/// What is refused then, as argument 0 of InvalidField; argument 1: at how many pairs of faces.
inline constexpr const char* crossingSurface = "surface.crossings";

[[nodiscard]] inline bool keepsApart(const SurfaceRules& rules)
{
    return rules.value_or(1) >= 2;
}

/// Whether open contours describe a body, too.
[[nodiscard]] inline bool mixesContours(const SurfaceRules& rules)
{
    return rules.value_or(1) >= 3;
}

} // namespace core
