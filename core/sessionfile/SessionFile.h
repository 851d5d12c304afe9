// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/TaskThread.h"
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

/// The history on disk (README.md beside this file): an SQLite database behind one writer thread
/// that owns the connection. Writing calls return at once and are carried out in order. What cannot
/// be written (a full disk, a folder that went away) waits in memory with all that follows it, and
/// is tried again with every further call. Any thread may call.
class SessionFile {
public:
    /// A new file, readable by its owner only. Replaces nothing: who wants that makes one elsewhere
    /// and moves it by saveAs() once it is whole. Errors: FileExists, FileUnwritable.
    static Result<std::unique_ptr<SessionFile>> create(
        const QString& path, const SessionSource& source);
    /// The same in the empty file that a StagedFile has made.
    static Result<std::unique_ptr<SessionFile>> createIn(
        const StagedFile& staged, const SessionSource& source);
    /// Where create() fails with @p why and work is to begin all the same: everything waits in
    /// memory until saveAs() gives it a place.
    static std::unique_ptr<SessionFile> waiting(
        const QString& path, const SessionSource& source, const Error& why);

    using Access = SessionAccess;
    /// Checks the chain of all rows; read-only media are fine with all but Access::ReadWrite.
    /// Errors: FileNotFound, FileUnreadable (in use by another program), FileTruncated (empty),
    /// FileUnwritable, UnsupportedFormat (no session, or a newer Burin's), SessionDamaged.
    static Result<std::unique_ptr<SessionFile>> open(const QString& path, Access access);

    [[nodiscard]] static bool isNamedAt(const QString& path); ///< isSessionNamedAt()

    /// Writes what is waiting and leaves one file.
    ~SessionFile();

    /// As it was when the file was opened.
    [[nodiscard]] const SessionContents& contents() const { return m_contents; }
    [[nodiscard]] QString path() const;
    /// It is a copy of what lies at path(), until saveAs() gives it a place of its own.
    [[nodiscard]] bool isPrivateCopy() const;
    /// The study's images are in it.
    [[nodiscard]] bool holdsImages() const;
    /// Why there is no file at path() (waiting()); none: there is one.
    [[nodiscard]] std::optional<Error> whyNoFile() const;

    /// First half of a row: it becomes the position, and the child that redo goes to.
    void addRow(const HistoryRow& row);
    /// Second half.
    void completeRow(RowId row, const QByteArray& stateHash, const BrickDelta& delta);
    void setPosition(RowId position);
    void setHiddenSegments(const std::vector<int>& labels);
    void setDisplay(const QJsonObject& display);
    /// Replaces the picture that the row may have.
    void addKeyframe(const Keyframe& keyframe);
    /// The PNG of a row's picture; empty if there is none. @p take is called on the writer's
    /// thread.
    void fetchKeyframe(RowId row, std::function<void(const QByteArray& png)> take);

    /// Everything read again and checked, told on the writer's thread; what follows waits
    /// meanwhile.
    void audit(std::function<void(const Result<AuditReport>&)> take);

    /// Waits. What waits in memory is read from there. Errors: SessionDamaged.
    [[nodiscard]] Result<BrickDelta> readDelta(RowId row);
    /// Waits until everything is on disk. Errors: FileUnwritable; what is left waits on.
    [[nodiscard]] Result<void> flush();

    /// Copies everything, also what waits in memory, into @p target, which appears under its name
    /// only once it is whole and on disk; then goes on there, in line with what is written. The
    /// file before stays, closed, unless it is the one replaced. On failure nothing has changed. @p
    /// done: on the writer's thread. Errors: FileExists (unless @p replaceExisting),
    /// FileUnwritable.
    void saveAs(const QString& target, bool replaceExisting,
        std::function<void(const Result<void>&)> done, SavedImages images = {});

    /// The file under another name in its folder, replacing a session that is there. Waits. On
    /// failure nothing has changed. Errors: FileUnwritable.
    [[nodiscard]] Result<void> rename(const QString& target);

    /// Copies all but the study's images into @p path, which must not exist, and goes on where it
    /// is.
    /// @p done: on the writer's thread. Errors: FileUnwritable.
    void copyTo(const QString& path, std::function<void(const Result<void>&)> done);

    /// Tries again what waits in memory. Never waits.
    void retry();
    /// Why something waits in memory (without a file: a step); none: all is on disk or on its way.
    [[nodiscard]] std::optional<Error> trouble() const;
    /// Called on the writer's thread when writing begins to fail, and when all is written again.
    /// Set it before the first write.
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
    [[nodiscard]] SessionParts parts() const;
    [[nodiscard]] Result<void> reopen(const QString& path);

    SessionContents m_contents;
    std::function<void()> m_troubleListener;
    mutable std::mutex m_mutex;
    // Under m_mutex:
    QString m_path;
    bool m_isPrivateCopy = false;
    std::optional<Error> m_trouble;
    std::optional<Error> m_whyNoFile;
    bool m_holdsImages = false;
    // The writer's thread only:
    std::unique_ptr<SessionTables> m_tables; ///< null: there is no file
    SessionWrites m_waiting;

    std::optional<ClosableSessionFile> m_closable; ///< gone before anything else of it is
    TaskThread m_writer; ///< last: it uses all of the above
};

} // namespace core
