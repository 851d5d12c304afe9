// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recipe/Recipe.h"
#include "core/session/EditSession.h"

#include <vector>

namespace app {

/// Writes what is shown and not empty, as it stands at the session's position, to each target and
/// prints one line of JSON per file.
[[nodiscard]] core::Result<void> exportFiles(
    const std::vector<core::RecipeExport>& targets, core::EditSession& session, bool force);

} // namespace app
