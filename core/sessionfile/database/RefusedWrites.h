// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core {

// Why the system refuses what SQLite wants to write. SQLite tells of a used-up quota as "disk I/O
// error", and does not keep the reason: sqlite3_system_errno() is 0 after a commit that failed, and
// that of a later call where a file could not be opened. What it keeps with a file is gone with a
// rollback journal that could not be brought to the disk, and with the file of a copy.

/// From now on, what the system refuses SQLite is noted, for each thread by itself. Calling it
/// again does nothing.
void noteRefusedWrites();

/// Forgets what was noted on this thread.
void forgetRefusedWrites();

/// The errno of the last call that was refused on this thread: opening a file for writing, writing
/// into it, setting its size, bringing it to the disk, or removing it; 0: none was.
[[nodiscard]] int lastRefusedWrite();

} // namespace core
