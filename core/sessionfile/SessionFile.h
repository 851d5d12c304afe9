// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/TaskThread.h"
#include "core/base/files/FollowedFile.h"
#include "core/sessionfile/CloseSessionFiles.h"
#include "core/sessionfile/SessionWrites.h"
#include "core/sessionfile/records/SavedImages.h"
#include "core/sessionfile/records/SessionContents.h"

#include <QString>

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace core {

class SessionTables;
class StagedFile;
struct SessionParts;
struct AuditReport;

/// The session file: the history on disk (core/session/README.md), an SQLite database whose
/// connection belongs to one writer thread. Calls that write return at once and are carried out in
/// order. If writing fails (the disk is full, the folder is gone), the write waits in memory with
/// all that follow it, and is tried again with each later call. Any thread may call.
///
/// Another program may rename, move, delete or replace the file while it is open. The next write,
/// retry(), flush() or saveAs() notices: the session then goes on in the file under its new name,
/// or, if it has none there that can be written, in a new file that holds everything (takeMove()).
class SessionFile {
public:
    /// Creates a file that only its owner can read. It never replaces one: to replace a file,
    /// create one elsewhere and move it by saveAs() when it is complete. Errors: FileExists,
    /// FileUnwritable.
    static Result<std::unique_ptr<SessionFile>> create(
        const QString& path, const SessionSource& source);
    /// Creates one in the empty file of a StagedFile.
    static Result<std::unique_ptr<SessionFile>> createIn(
        const StagedFile& staged, const SessionSource& source);
    /// Begins without a file after create() failed with @p why: everything waits in memory until
    /// saveAs() gives it a place.
    static std::unique_ptr<SessionFile> waiting(
        const QString& path, const SessionSource& source, const Error& why);

    using Access = SessionAccess;
    /// Opens a file and checks the chain of all rows. Read-only media work with every access but
    /// Access::ReadWrite. Errors: FileNotFound, FileUnreadable (another program uses it),
    /// FileTruncated (empty), FileUnwritable, UnsupportedFormat (no session, or one of a newer
    /// Burin), SessionDamaged.
    static Result<std::unique_ptr<SessionFile>> open(const QString& path, Access access);

    [[nodiscard]] static bool isNamedAt(const QString& path); ///< isSessionNamedAt()

    /// Writes what is waiting and closes the database as a single file.
    ~SessionFile();

    /// The contents when the file was opened.
    [[nodiscard]] const SessionContents& contents() const { return m_contents; }
    [[nodiscard]] QString path() const;
    /// Whether it is a copy of the file at path(); it remains one until saveAs() gives it its own
    /// place.
    [[nodiscard]] bool isPrivateCopy() const;
    /// Whether the study's images are in it.
    [[nodiscard]] bool holdsImages() const;
    /// The reason why there is no file at path() (waiting()); none: there is one.
    [[nodiscard]] std::optional<Error> whyNoFile() const;

    /// Writes the first half of a row, which becomes the position and the child that redo goes to.
    void addRow(const HistoryRow& row);
    /// Writes the second half.
    void completeRow(RowId row, const QByteArray& stateHash, const BrickDelta& delta);
    void setPosition(RowId position);
    void setHiddenSegments(const std::vector<int>& labels);
    void setDisplay(const QJsonObject& display);
    /// Replaces the picture of the row, if it has one.
    void addKeyframe(const Keyframe& keyframe);
    /// Reads the PNG of a row's picture; empty if there is none. @p take is called on the writer's
    /// thread.
    void fetchKeyframe(RowId row, std::function<void(const QByteArray& png)> take);

    /// Reads and checks everything again, after writing what waits in memory. @p take is called on
    /// the writer's thread; later writes wait. Errors: FileUnwritable (something still waits).
    void audit(std::function<void(const Result<AuditReport>&)> take);

    /// Blocks. A delta that still waits in memory is returned from there. Errors: SessionDamaged.
    [[nodiscard]] Result<BrickDelta> readDelta(RowId row);
    /// Blocks until everything is on disk. Errors: FileUnwritable; what was not written keeps
    /// waiting.
    [[nodiscard]] Result<void> flush();

    /// Copies everything, including writes that wait in memory, into a new file and gives that the
    /// name @p target once it is complete and on disk; the session goes on there. It comes after
    /// all writes that were asked for before. The old file is closed and stays, unless it is the
    /// one that is replaced. If it fails, the session goes on in the old file, and the file that
    /// was called @p target keeps that name; if the disk does not let a file have its name back,
    /// the error says where both files are.
    /// @param replaceExisting whether a closed session that has the name may be replaced; any other
    /// file is never replaced
    /// @param done called on the writer's thread
    /// Errors: FileExists, FileUnwritable.
    void saveAs(const QString& target, bool replaceExisting,
        std::function<void(const Result<void>&)> done, SavedImages images = {});

    /// Gives the file another name in its folder; a closed session that has the name is replaced.
    /// Blocks. If it fails, both files have their old names, or the error says where they are.
    /// Errors: FileUnwritable.
    [[nodiscard]] Result<void> rename(const QString& target);

    /// Copies everything but the study's images to @p path, which must not exist, and continues in
    /// the present file.
    /// @param done called on the writer's thread
    /// Errors: FileUnwritable.
    void copyTo(const QString& path, std::function<void(const Result<void>&)> done);

    /// SessionMoved with the file in which the session has continued since the last call, because
    /// another program took the name of its file. None: it has not moved.
    [[nodiscard]] std::optional<Error> takeMove();

    /// Tries to write what waits in memory. Never blocks.
    void retry();
    /// The reason why something waits in memory (without a file: a step); none: all is on disk or
    /// being written.
    [[nodiscard]] std::optional<Error> trouble() const;
    /// @param listener called on the writer's thread when writing begins to fail, when everything
    /// is written again, and when there is something for takeMove(); to be set before the first
    /// write
    void setTroubleListener(std::function<void()> listener);

private:
    explicit SessionFile(const QString& path);
    static Result<std::unique_ptr<SessionFile>> begin(
        const QString& emptyFile, const SessionSource& source);

    void post(SessionWrite write);
    void writeWaiting();
    void close();
    void setTrouble(const std::optional<Error>& trouble);
    [[nodiscard]] Result<void> moveTo(
        const QString& target, bool replaceExisting, const SavedImages& images);
    [[nodiscard]] Result<void> renameTo(const QString& target);
    [[nodiscard]] Result<void> goOnIn(StagedFile& staged);
    void goOnUnnamed(StagedFile& staged);
    [[nodiscard]] Result<void> closeAsOneFile();
    [[nodiscard]] Result<void> keepName();
    [[nodiscard]] bool canFollowTo(const QString& path) const;
    [[nodiscard]] Result<void> followTo(const QString& path);
    [[nodiscard]] Result<void> writeAnew();
    void noteMove(const Clause& what, const QString& before);
    [[nodiscard]] SessionParts parts() const;
    [[nodiscard]] Result<void> reopen(const QString& path);
    void openAgain();
    [[nodiscard]] Error whyNoTables() const;
    void setPath(const QString& path);

    SessionContents m_contents;
    std::function<void()> m_troubleListener;
    mutable std::mutex m_mutex;
    // Under m_mutex:
    QString m_path;
    bool m_isPrivateCopy = false;
    std::optional<Error> m_trouble;
    std::optional<Error> m_whyNoFile;
    std::optional<Error> m_moved;
    bool m_holdsImages = false;
    // The writer's thread only:
    std::unique_ptr<SessionTables> m_tables; ///< null: there is no file, or none that opens
    /// Why the file at m_path, which has all steps but those that wait, is not open; none: it is,
    /// or there is no file.
    std::optional<Error> m_whyShut;
    FollowedFile m_followed; ///< the file that is open for writing, or was and is shut
    SessionWrites m_waiting;

    std::optional<ClosableSessionFile> m_closable; ///< destroyed first
    TaskThread m_writer; ///< last, since it uses all of the above
};

} // namespace core
