// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace app {

/// The entry of the command line: handles help and version, finds the verb and runs its command.
/// @return the exit status of the program
int runCommandLine(int argc, char** argv);

} // namespace app
