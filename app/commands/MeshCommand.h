// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin mesh MASK --study PATH --out FILE [--series UID] [--repair REPAIRS] [--segment NAME]
/// [--vertices NUMBER] [--space lps|ras] [--json] [--force]`: writes, for each segment of a mask,
/// the surface with which refinement begins, and measures its quality.
extern const Command meshCommand;

} // namespace app
