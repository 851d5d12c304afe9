// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin demo DIR`: writes the demonstration study, with its reference mask, into a new folder.
extern const Command demoCommand;

} // namespace app
