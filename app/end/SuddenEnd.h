// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace app {

/// Makes sure that the program does not end without an explanation: an uncaught exception, or a
/// library that aborts (LLVM and Qt do when they get no memory), is reported in one sentence on
/// stderr and in the window's note (EndNote.h). If memory ran out the program exits with status 1
/// and without a core dump; any other case is a bug, and ends the program as it would without this
/// function.
///
/// Nothing is closed, because a session's file is complete at any time.
void watchForSuddenEnd();

/// Ends the program at once, with status 1, and says that memory was refused, like an exception
/// that nobody catches. For places where nothing may be thrown and work cannot go on. Takes no
/// memory.
[[noreturn]] void endForWantOfMemory();

/// Sets a file descriptor to which the reason is also written; −1 for none.
void noteSuddenEndIn(int descriptor);

} // namespace app
