// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin compare MASK REFERENCE --study PATH [--series UID] [--repair REPAIRS] [--segment NAME]
/// [--reference NAME] [--json]`: how far a mask is from the one that is held for the truth.
extern const Command compareCommand;

} // namespace app
