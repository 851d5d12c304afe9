// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin run RECIPE.json --study PATH [--series UID] --session FILE.burin [--force | --append]
/// [--apply-elsewhere] [--author NAME]`: carries out a recipe without a window and prints one line
/// of JSON per step, once it is on disk. The rows say that NAME made them, else nobody. A recipe
/// that is refused leaves no file behind. --append goes on with a session where it stands and finds
/// its study by itself. A recipe that was recorded on another study is only listed, unless
/// --apply-elsewhere is given; what is bound to places is left out.
extern const Command runCommand;

} // namespace app
