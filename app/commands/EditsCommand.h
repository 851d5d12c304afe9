// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin edits [--json]`: lists all edits that a recipe can hold, from the schema that parses it.
extern const Command editsCommand;

} // namespace app
