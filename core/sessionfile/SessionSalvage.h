// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/sessionfile/records/SessionContents.h"

namespace core {

/// Reads and checks all of a session file, including differences, and changes neither it nor its
/// folder. Of a damaged file it returns everything before the damage; SessionContents::damage names
/// what is lost. A row that only lost its difference is not damaged yet (SessionContents::redo).
/// Blocks; every byte is read and hashed once. Errors: those of SessionFile::open(), SessionDamaged
/// (nothing is sound), Cancelled.
[[nodiscard]] Result<SessionContents> checkSession(
    const QString& path, const Progress& progress = Progress());

/// Writes what checkSession() found sound in a damaged file to a new session file; the damaged one
/// is left as it is. The new file appears under its name only when it is complete. Rows in `redo`
/// are carried out again when it is opened, and the opener compares their hashes. Blocks. Errors:
/// FileExists, FileUnwritable, SessionDamaged (the file has changed in the meantime).
[[nodiscard]] Result<void> salvageSession(
    const QString& damaged, const SessionContents& sound, const QString& target);

} // namespace core
