// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// The option --trace, of verbs that compute much or show a window.
[[nodiscard]] std::vector<Option> traceOption();

/// Runs a verb. With --trace FILE, a new file, everything is recorded meanwhile (core::Trace) and
/// written when the verb has ended, whatever its status, but not if its arguments were wrong.
/// @return the exit status of the verb; 1 if the file cannot be written
int traced(const Arguments& arguments, int (*run)(const Arguments&));

} // namespace app
