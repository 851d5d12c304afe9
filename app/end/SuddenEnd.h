// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace app {

/// From now on the program does not end without a word: what nobody catches, and a library that
/// gives up (LLVM and Qt abort where they get no memory), is told in one sentence on stderr and in
/// the window's note (EndNote.h). For want of memory it ends with status 1 and without a core dump;
/// anything else is an error of the program, and ends it as it would without this.
///
/// Nothing is closed: what is in a session's file is whole at any time.
void watchForSuddenEnd();

/// Where the reason is written besides: a file that is open; -1: nowhere.
void noteSuddenEndIn(int descriptor);

} // namespace app
