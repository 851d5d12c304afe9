// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace app {

/// `burin run RECIPE.json --study PATH [--series UID] --session FILE.burin [--force]`: carries out
/// a recipe without a window and prints one line of JSON per edit, once it is on disk. A recipe
/// that is refused leaves no file behind.
int runRecipe(const QStringList& arguments);

} // namespace app
