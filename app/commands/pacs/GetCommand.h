// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin get NODE --study UID [--series UID] --to FOLDER [--move PORT] [--json]`: downloads a
/// study or series.
extern const Command getCommand;

} // namespace app
