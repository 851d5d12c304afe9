// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/files/FileInUse.h"

#include <QString>

namespace core {

/// That this process has a session file open for writing, told to the rest of the process.
///
/// SQLite locks a file with POSIX locks, and closing *any* descriptor of a file drops all of them
/// that its process holds. So nothing here may open a session file as a plain file while it is in
/// use; who needs its bytes goes through copySession(). Any thread.
class SessionUse {
public:
    SessionUse() = default;
    /// Errors: FileUnreadable (this process uses it already).
    static Result<SessionUse> begin(const QString& path);
    SessionUse(SessionUse&& other) noexcept;
    SessionUse& operator=(SessionUse&& other) noexcept;
    ~SessionUse();

private:
    QString m_key; ///< empty: nothing is used
    FileInUse m_file;
};

/// Whether a path leads to a session file of Burin's, by the head of the file. One that is in use
/// is one.
[[nodiscard]] bool isSessionFile(const QString& path);

/// Whether a session may take a name where something lies: another session that is closed, with
/// nothing beside it. A free name passes. Errors: FileUnwritable with the reason.
[[nodiscard]] Result<void> checkReplacedSession(const QString& path);

/// What lies beside a free name that SQLite would take for a part of a session made there; empty:
/// nothing.
[[nodiscard]] QString strayPartOf(const QString& path);

/// Whether a session file is open for writing, in this process or another. Touches nothing.
[[nodiscard]] bool isSessionInUse(const QString& path);

/// Whether a program ended without closing it: what it wrote last lies in a file beside.
[[nodiscard]] bool isSessionUnfinished(const QString& path);

/// Why a session file that is not in use is not whole; all empty: it is, or nobody can tell.
struct SessionLoss {
    QString cutOff; ///< "the file is cut off: 40960 of 81920 bytes are there"
    QString foreign; ///< "it holds a trigger 't', which is no part of a session"
    QString structure; ///< "its structure is damaged: …"; sessionLoss() does not look for that
    QString leftOpen; ///< its program left it open, and what it wrote last is not beside it
};
/// Reads no more than the file's head.
[[nodiscard]] SessionLoss sessionLoss(const QString& path);

/// With what lies beside it. @return whether it is gone
bool removeSession(const QString& path);

/// The bytes of a session file and of what lies beside it, as they are at one moment, even if
/// another process goes on writing.
/// Errors: FileUnreadable (this process writes it, it cannot be read, or it changes too fast),
/// FileUnwritable (no room for the copy).
Result<void> copySession(const QString& from, const QString& to);

} // namespace core
