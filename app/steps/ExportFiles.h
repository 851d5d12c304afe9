// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/recipe/Recipe.h"
#include "core/volume/Volume.h"

#include <functional>
#include <vector>

namespace app {

class SteadySession;

/// A function that reads the study of a session from its files again: a carved volume is written
/// with the original values.
using ReadStudy = std::function<core::Result<core::LoadedVolume>()>;

/// Writes each target for the state at the session's position (segments only if they are shown and
/// not empty) and prints one line of JSON per file. Errors include Cancelled and ContextLost: the
/// file that was under way is then removed.
[[nodiscard]] core::Result<void> exportFiles(const std::vector<core::RecipeExport>& targets,
    SteadySession& session, bool force, const ReadStudy& readStudy, const core::Progress& progress);

/// Returns the same failure for a session that is continued, without the advice to use --force,
/// which would replace the session too and is refused there.
[[nodiscard]] core::Result<void> withoutForce(const core::Result<void>& checked);

} // namespace app
