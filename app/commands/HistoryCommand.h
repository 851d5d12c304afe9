// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin history FILE.burin [--json | --as-recipe | --report OUT.html|OUT.pdf [--force]]`: prints
/// what was done, as a table, as JSON, as a recipe for `burin run`, or as an audit report. The file
/// is only read; neither the study nor a display is needed.
extern const Command historyCommand;

} // namespace app
