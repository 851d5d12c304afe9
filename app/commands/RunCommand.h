// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin run RECIPE.json --study PATH [--series UID] --session FILE.burin [--force | --append]
/// [--apply-elsewhere] [--author NAME] [--facts] [--trace FILE.json]`: carries out a recipe without
/// a window and prints one line of JSON for each step, once the step is on disk. The rows name NAME
/// as their author, or nobody. A recipe that is refused leaves no file behind. --append continues a
/// session from its position and finds its study by itself. A recipe that was recorded on another
/// study is only listed, unless --apply-elsewhere is given; then steps that are bound to places are
/// left out.
extern const Command runCommand;

} // namespace app
