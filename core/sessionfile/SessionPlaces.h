// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/sessionfile/records/SessionContents.h"

#include <QString>

namespace core {

/// Checks that a session may get a name: a free one or, with @p replaceExisting, that of a closed
/// session; beside it nothing may lie that SQLite would take for a part of it. Errors: FileExists,
/// FileUnwritable.
[[nodiscard]] Result<void> checkSessionPlace(const QString& path, bool replaceExisting);

/// Creates an empty file for a new session, readable only by its owner. Errors: FileExists,
/// FileUnwritable.
[[nodiscard]] Result<void> makeEmptySession(const QString& path);

/// Whether a file lies there, or beside it one that SQLite would take for a part of a session.
[[nodiscard]] bool isSessionNameTaken(const QString& path);

/// The path itself if it is not taken, else one with a number, "case (2).burin".
[[nodiscard]] QString freeSessionName(const QString& path);

/// Checks that a file exists and can be opened with this access, whatever it contains. Errors:
/// FileNotFound, FileUnreadable, FileTruncated (empty), FileUnwritable.
[[nodiscard]] Result<void> checkSessionToOpen(const QString& path, SessionAccess access);

/// Checks that the file at @p target may be replaced by a session other than the one that lies
/// there: it must be a closed one, or free. Errors: FileUnwritable; that of checkOnlySessionAt()
/// only if @p replaceExisting.
[[nodiscard]] Result<void> checkOtherSessionAt(const QString& target, bool replaceExisting);

/// Whether a path is to be opened as a session, judged by its name (.burin) or content. The file
/// may still be damaged, or be no session.
[[nodiscard]] bool isSessionNamedAt(const QString& path);

} // namespace core
