// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin replay FILE.burin --verify [--to ROW] [--study PATH] [--series UID]`: carries out every
/// row of a session again from nothing, including branches (with --to only the rows that lead to
/// one), and compares the state hash after each. `--export FILE` then writes the masks of that
/// state (of --to, else of the session's position); with `--format coverage --layer N` it writes
/// what a sculpt layer carves, with `--format carved-volume [--fill VALUE]` the study without what
/// is carved. The session file is only read.
extern const Command replayCommand;

} // namespace app
