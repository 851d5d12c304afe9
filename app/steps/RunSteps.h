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

/// Carries out a recipe's steps, one after the other, and prints one line of JSON for each once it
/// is on disk; of a revised cut also the later strokes that began on its surface and keep their
/// place. Errors name the entry of the recipe; Cancelled, between two steps; ContextLost.
[[nodiscard]] core::Result<void> carryOut(const core::Recipe& recipe, SteadySession& session,
    RunKeyframes& keyframes, const core::Progress& progress);

/// Likewise on another study than it was recorded on. Steps that turn out to need what is not here
/// are named on stderr, those in @p toldBefore not again.
[[nodiscard]] core::Result<void> carryOutElsewhere(core::RecipeElsewhere& recipe,
    const std::vector<core::RecipeElsewhere::LeftOut>& toldBefore, SteadySession& session,
    RunKeyframes& keyframes, const core::Progress& progress);

} // namespace app
