// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin replay FILE.burin --verify [--to ROW] [--study PATH] [--series UID]`: carries out every
/// row of a session again, from nothing, branches included (or the rows that lead to one), and
/// compares the state hash after each. `--export FILE` then writes the masks of that state
/// (--to; else where the session stands), or with `--format coverage --layer N` what a sculpt layer
/// carves, or with `--format carved-volume [--fill VALUE]` the study without what is carved. The
/// session file is only read.
extern const Command replayCommand;

} // namespace app
