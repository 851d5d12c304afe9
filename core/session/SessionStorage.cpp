// SPDX-License-Identifier: Apache-2.0
#include "core/session/SessionStorage.h"

#include "core/base/Guarded.h"
#include "core/session/operations/OperationQueue.h"
#include "core/sessionfile/AuditReport.h"

#include <utility>

namespace core {

namespace {

SessionFile* fileOf(OperationQueue& queue)
{
    return queue.state().file.get();
}

} // namespace

SessionStorage::SessionStorage(OperationQueue& queue)
    : m_queue(queue)
{
}

std::optional<Error> SessionStorage::whyNoFile() const
{
    const SessionFile* file = fileOf(m_queue);
    return file ? file->whyNoFile() : std::nullopt;
}

bool SessionStorage::holdsImages() const
{
    const SessionFile* file = fileOf(m_queue);
    return file && file->holdsImages();
}

void SessionStorage::saveAs(const QString& target, bool replaceExisting,
    std::function<void(const Result<void>&)> done, SavedImages images)
{
    m_queue.closeOpen();
    if (SessionFile* file = fileOf(m_queue))
        file->saveAs(target, replaceExisting, std::move(done), std::move(images));
    else
        done(failure(ErrorCode::FileUnwritable, target,
            Clause::saying("this session is kept in memory only")));
}

Result<void> SessionStorage::rename(const QString& target)
{
    return guarded([&]() -> Result<void> {
        if (const Result<void> settled = m_queue.settle(); !settled)
            return settled;
        SessionFile* file = fileOf(m_queue);
        return file
            ? file->rename(target)
            : failure(ErrorCode::FileUnwritable, target, Clause::saying("there is no file"));
    });
}

void SessionStorage::copyTo(
    const QString& path, std::function<void(const Result<void>&)> done) const
{
    if (SessionFile* file = fileOf(m_queue))
        file->copyTo(path, std::move(done));
    else
        done(failure(ErrorCode::FileUnwritable, path,
            Clause::saying("this session is kept in memory only")));
}

void SessionStorage::audit(std::function<void(const Result<AuditReport>&)> take) const
{
    if (SessionFile* file = fileOf(m_queue))
        file->audit(std::move(take));
    else
        take(failure(ErrorCode::InvalidField, QStringLiteral("session"),
            Clause::saying("it is kept in no file")));
}

std::optional<Error> SessionStorage::trouble() const
{
    const SessionFile* file = fileOf(m_queue);
    return file ? file->trouble() : std::nullopt;
}

void SessionStorage::retryWriting()
{
    if (SessionFile* file = fileOf(m_queue))
        file->retry();
}

void SessionStorage::finishWriting()
{
    m_queue.finishWriting();
}

void SessionStorage::setStepMemory(std::size_t bytes)
{
    m_queue.state().recent.setMostBytes(bytes);
}

} // namespace core
