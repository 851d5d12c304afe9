// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin send NODE PATH… [--json]`: stores DICOM files at a node.
extern const Command sendCommand;

} // namespace app
