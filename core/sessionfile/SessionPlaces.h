// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/sessionfile/records/SessionContents.h"

#include <QString>

namespace core {

/// Creates an empty file for a new session, readable only by its owner. Errors: FileExists,
/// FileUnwritable.
[[nodiscard]] Result<void> makeEmptySession(const QString& path);

/// The path itself if no file lies there or beside it that SQLite would take for a part of a
/// session, else one with a number, "case (2).burin".
[[nodiscard]] QString freeSessionName(const QString& path);

/// Checks that a file exists and can be opened with this access, whatever it contains. Errors:
/// FileNotFound, FileUnreadable, FileTruncated (empty), FileUnwritable.
[[nodiscard]] Result<void> checkSessionToOpen(const QString& path, SessionAccess access);

/// Checks that the file at @p target may be replaced by a session other than the one that lies
/// there. Errors: FileUnwritable.
[[nodiscard]] Result<void> checkOtherSessionAt(const QString& target);

/// Whether a path is to be opened as a session, judged by its name (.burin) or content. The file
/// may still be damaged, or be no session.
[[nodiscard]] bool isSessionNamedAt(const QString& path);

} // namespace core
