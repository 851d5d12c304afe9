// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin echo NODE [--json]`: tests whether a DICOM node answers.
extern const Command echoCommand;

} // namespace app
