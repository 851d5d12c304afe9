// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin open [PATH] [--series UID] [--demo] [--screenshot FILE.png] [--size WxH]
/// [--trace FILE.json]`: opens the window. With --screenshot it waits until every view is fully
/// refined, saves a picture of the window and exits.
extern const Command openCommand;

} // namespace app
