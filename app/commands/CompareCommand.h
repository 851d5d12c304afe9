// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin compare MASK REFERENCE --study PATH [--series UID] [--repair REPAIRS] [--segment NAME]
/// [--reference NAME] [--json]`: measures how far a mask is from a reference mask.
extern const Command compareCommand;

} // namespace app
