// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin info --gl`: prints the renderer, and the memory that a volume takes on it.
/// `burin info PATH [--json]`: prints what a folder or file holds; decodes every volume to report
/// its value range and checksum.
extern const Command infoCommand;

} // namespace app
