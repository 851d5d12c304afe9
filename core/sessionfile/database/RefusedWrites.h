// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core {

// Finds out why the system refuses what SQLite wants to write. SQLite reports an exhausted quota as
// "disk I/O error" and does not keep the reason: sqlite3_system_errno() is 0 after a failed commit,
// and belongs to a later call if a file could not be opened. An error that SQLite keeps with a file
// is lost together with that file: a rollback journal that could not be written to disk, or the
// file of a copy.

/// From now on, calls of SQLite that the system refuses are recorded, separately for each thread.
/// Calling it again does nothing.
void noteRefusedWrites();

/// Forgets what was recorded on this thread.
void forgetRefusedWrites();

/// The errno of the last call that was refused on this thread: opening a file for writing, writing
/// into it, setting its size, writing it to disk, or removing it; 0: none was.
[[nodiscard]] int lastRefusedWrite();

} // namespace core
