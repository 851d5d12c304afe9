// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recipe/RecipeElsewhere.h"

#include <optional>
#include <vector>

namespace core {
class EditSession;
}

namespace app {

/// The path of the recipe, if an error is about what stands in it and not about a file; empty
/// otherwise.
[[nodiscard]] QString recipeIfAtFault(const core::Error& error, const core::Recipe& recipe);

/// Says on stderr which steps of a recipe are carried out on another study than it was recorded on.
/// @return what is left out; nothing where the user has to agree first
[[nodiscard]] std::optional<std::vector<core::RecipeElsewhere::LeftOut>> reportElsewhere(
    const core::RecipeElsewhere& elsewhere, const core::Volume& volume, bool agreed);

/// Says on stderr where a session goes on, unless that is after its last row: if steps were undone,
/// or somebody went back to an earlier one, new rows begin a branch there.
void reportWhereItGoesOn(const core::EditSession& session);

} // namespace app
