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

/// Where a session is kept: its file, other places that it can go on in or be copied to, and what
/// is wrong with the disk. Only rename() waits; a @p done or @p take is called once, on another
/// thread (on this one where there is no file). Part of EditSession.
class SessionStorage {
public:
    explicit SessionStorage(OperationQueue& queue);

    /// Why there is no file where one was asked for (EditSession::Options::beginWithoutFile): every
    /// step waits in memory until saveAs() gives it one. None: there is one, or none was asked for.
    [[nodiscard]] std::optional<Error> whyNoFile() const;
    /// The study's images are in the file (SessionImages.h).
    [[nodiscard]] bool holdsImages() const;

    /// Goes on in a copy of the session file (SessionFile::saveAs()). @p done may be called after
    /// the session is gone.
    void saveAs(const QString& target, bool replaceExisting,
        std::function<void(const Result<void>&)> done, SavedImages images = {});
    /// Gives the session file another name in the same folder, replacing a session that is there,
    /// and goes on there. On failure everything is as it was. Errors: FileUnwritable.
    [[nodiscard]] Result<void> rename(const QString& target);
    /// A copy of everything so far, without the study's images, in @p path, which must not exist;
    /// the session goes on where it is. Errors: those of saveAs().
    void copyTo(const QString& path, std::function<void(const Result<void>&)> done) const;
    /// The file read again and checked. A session without one says so (InvalidField).
    void audit(std::function<void(const Result<AuditReport>&)> take) const;

    /// Why steps wait in memory instead of standing on disk (a full disk, say); none: they do not.
    /// A change is told as DocumentChange::What::Disk.
    [[nodiscard]] std::optional<Error> trouble() const;
    /// Tries to write them now; every further step does so too.
    void retryWriting();

    /// How many bytes of memory the bricks of the steps that were used last may take, so that undo
    /// and redo over them need no disk; RecentSteps::usualBytes until it is set.
    void setStepMemory(std::size_t bytes);

private:
    OperationQueue& m_queue;
};

} // namespace core
