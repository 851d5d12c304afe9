// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/recipe/Recipe.h"
#include "core/volume/Volume.h"

#include <functional>
#include <vector>

namespace app {

class SteadySession;

/// The study that a session was made on, read from its files: what is carved is written with their
/// values.
using ReadStudy = std::function<core::Result<core::LoadedVolume>()>;

/// Writes each target as it stands at the session's position (of segments those that are shown and
/// not empty) and prints one line of JSON per file. Cancelled, ContextLost: of the one that was
/// under way nothing is left.
[[nodiscard]] core::Result<void> exportFiles(const std::vector<core::RecipeExport>& targets,
    SteadySession& session, bool force, const ReadStudy& readStudy, const core::Progress& progress);

} // namespace app
