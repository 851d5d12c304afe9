// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin find NODE [filters] [--json]`: lists the studies at a DICOM node, or the series of one.
extern const Command findCommand;

} // namespace app
