// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace app {

/// The command line up to its verb: help, version, dispatch.
int runCommandLine(int argc, char** argv);

} // namespace app
