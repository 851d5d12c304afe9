// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/recipe/Recipe.h"
#include "core/recipe/RecipeElsewhere.h"

#include <vector>

namespace app {

class RunKeyframes;
class SteadySession;

/// Carries out the steps of a recipe, one after the other, and prints one line of JSON for each
/// once it is on disk. For a revised cut the line also names the later strokes that began on its
/// surface and keep their place. Errors name the entry of the recipe; Cancelled may occur between
/// two steps; ContextLost.
[[nodiscard]] core::Result<void> carryOut(const core::Recipe& recipe, SteadySession& session,
    RunKeyframes& keyframes, const core::Progress& progress);

/// The same on another study than the recipe was recorded on. Steps that turn out to need something
/// that this study lacks are named on stderr, except those in @p reportedBefore.
[[nodiscard]] core::Result<void> carryOutElsewhere(core::RecipeElsewhere& recipe,
    const std::vector<core::RecipeElsewhere::LeftOut>& reportedBefore, SteadySession& session,
    RunKeyframes& keyframes, const core::Progress& progress);

} // namespace app
