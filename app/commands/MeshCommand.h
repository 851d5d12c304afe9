// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin mesh MASK --study PATH --out FILE [--series UID] [--repair REPAIRS] [--segment NAME]
/// [--vertices NUMBER] [--space lps|ras] [--json] [--force]`: the surface that refinement begins
/// with, of each segment of a mask, and what it is worth.
extern const Command meshCommand;

} // namespace app
