// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/sessionfile/records/SavedImages.h"

#include <QString>

#include <cstddef>
#include <functional>
#include <optional>

namespace core {

class OperationQueue;
struct AuditReport;

/// Where a session is kept: its file, other places to which it can move or be copied, and problems
/// with the disk. Only rename() and finishWriting() block. @p done or @p take is called once, on
/// another thread (on this one if there is no file). Part of EditSession.
class SessionStorage {
public:
    explicit SessionStorage(OperationQueue& queue);

    /// Why there is no file although one was requested (EditSession::Options::beginWithoutFile);
    /// every step then waits in memory until saveAs(). None: there is a file, or none was
    /// requested.
    [[nodiscard]] std::optional<Error> whyNoFile() const;
    /// Whether the study's images are in the file (SessionImages.h).
    [[nodiscard]] bool holdsImages() const;

    /// Copies the session file and continues in the copy (SessionFile::saveAs()). @p done may be
    /// called after the session was destroyed.
    void saveAs(const QString& target, bool replaceExisting,
        std::function<void(const Result<void>&)> done, SavedImages images = {});
    /// Renames the session file within its folder, replacing a session of that name. If it fails,
    /// nothing changes. Errors: FileUnwritable.
    [[nodiscard]] Result<void> rename(const QString& target);
    /// Copies everything so far, without the study's images, to @p path, which must not exist; the
    /// session continues in its present file. Errors: those of saveAs().
    void copyTo(const QString& path, std::function<void(const Result<void>&)> done) const;
    /// Reads the file again and checks it. Errors: InvalidField (a session without a file),
    /// FileUnwritable (steps wait that are not in the file).
    void audit(std::function<void(const Result<AuditReport>&)> take) const;

    /// Why steps wait in memory instead of being on disk (a full disk, for example); none: they do
    /// not wait. Changes are reported as DocumentChange::What::Disk.
    [[nodiscard]] std::optional<Error> trouble() const;
    /// Tries to write them now; every further step does so too.
    void retryWriting();
    /// The same, and waits until it is known what came of it: trouble() is up to date afterwards,
    /// and if the file has another name now, that was reported (SessionMoved).
    void finishWriting();

    /// Sets how many bytes of memory the bricks of recently used steps may take; undo and redo over
    /// them need no disk. The default is RecentSteps::usualBytes.
    void setStepMemory(std::size_t bytes);

private:
    OperationQueue& m_queue;
};

} // namespace core
