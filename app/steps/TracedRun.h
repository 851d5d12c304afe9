// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// The option --trace of verbs that compute much or show a window.
[[nodiscard]] std::vector<Option> traceOption();

/// Runs a verb. With --trace FILE it records everything meanwhile (core::Trace) and writes FILE,
/// which must be a new file, when the verb has ended. Nothing is written if the verb's arguments
/// were wrong.
int traced(const Arguments& arguments, int (*run)(const Arguments&));

} // namespace app
