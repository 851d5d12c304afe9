// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin info --gl`: the renderer, and the memory that a volume takes on it.
/// `burin info PATH [--json]`: what a folder or file holds; decodes every volume for its value
/// range and checksum.
extern const Command infoCommand;

} // namespace app
