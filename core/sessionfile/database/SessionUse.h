// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/files/FileInUse.h"
#include "core/base/words/Clause.h"

#include <QString>

namespace core {

class FollowedFile;

/// Registers within this process that it has a session file open for writing.
///
/// SQLite uses POSIX locks, and closing *any* descriptor of a file releases all locks that the
/// process holds on it. So a session file in use must never be opened as a plain file, under any of
/// its names (links, or what another program renamed it to); copySession() reads its bytes. Any
/// thread.
class SessionUse {
public:
    SessionUse() = default;
    /// Errors: FileUnreadable (this process uses it already).
    static Result<SessionUse> begin(const QString& path);
    SessionUse(SessionUse&& other) noexcept;
    SessionUse& operator=(SessionUse&& other) noexcept;
    ~SessionUse();

private:
    QString m_key; ///< empty: none is registered
    FileInUse m_file;
};

/// Whether there is a session file of Burin at a path, judged by the file's header. A file in use
/// is one.
[[nodiscard]] bool isSessionFile(const QString& path);

/// Checks that what is at @p target is nothing or a session of Burin, open or not: a session
/// replaces no other file. Errors: FileUnwritable with the reason.
[[nodiscard]] Result<void> checkOnlySessionAt(const QString& target);

/// Checks that a session may take the name of an existing file: that must be a closed session with
/// no files beside it. A free name passes. Errors: FileUnwritable with the reason.
[[nodiscard]] Result<void> checkReplacedSession(const QString& path);

/// A file beside a free name that SQLite would take for a part of a session created there; empty:
/// none.
[[nodiscard]] QString strayPartOf(const QString& path);

/// Whether a session file is open for writing, in this process or another, whichever of its names
/// leads to it; also where this process has opened the file that had this name. Changes nothing.
[[nodiscard]] bool isSessionInUse(const QString& path);

/// Whether a program ended without closing it, so that its last writes are in a file beside it.
[[nodiscard]] bool isSessionUnfinished(const QString& path);

/// The reasons why a session file that is not in use is incomplete; all empty: it is complete, or
/// that is unknown.
struct SessionLoss {
    Clause cutOff; ///< "the file is cut off: 40960 of 81920 bytes are there"
    Clause foreign; ///< "it holds a trigger 't', which is no part of a session"
    Clause structure; ///< "its structure is damaged: …"; not set by sessionLoss()
    Clause leftOpen; ///< its program left it open, and the file with its last writes is missing
    /// It lacks nothing: the last writes of another session that had its name lie beside it
    /// (leftLogName()).
    Clause leftBeside;
};
/// Reads only the header of the file.
[[nodiscard]] SessionLoss sessionLoss(const QString& path);

/// The path under which the last writes of a session are kept if they could not be put into its own
/// file because another file has its name. SQLite does not recognise this path.
/// @param path of its own file, without links
/// @param number from 1, of several
[[nodiscard]] QString leftLogName(const QString& path, int number);

/// Removes the files that SQLite leaves beside a session.
void removeSessionParts(const QString& path);

/// Removes a file that SQLite keeps beside a session, wherever it is now.
void removeSessionPart(const FollowedFile& followed);

/// Gives such a file the path @p to, if that is free. @return whether it is there now
bool moveSessionPart(const FollowedFile& followed, const QString& to);

/// Removes a session with the files beside it. @return whether it is gone
bool removeSession(const QString& path);

/// Copies a session file and the files beside it as they are at one moment, even while another
/// process writes. Errors: FileUnreadable (this process writes it, it cannot be read, or it changes
/// too often), FileUnwritable (no room for the copy).
Result<void> copySession(const QString& from, const QString& to);

} // namespace core
