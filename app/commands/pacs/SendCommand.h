// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin send NODE PATH… [--json]`: sends DICOM files to a node.
extern const Command sendCommand;

} // namespace app
