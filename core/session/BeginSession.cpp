// SPDX-License-Identifier: Apache-2.0
#include "core/base/Guarded.h"
#include "core/session/EditSession.h"
#include "core/session/RestoreSession.h"
#include "core/session/operations/OperationQueue.h"
#include "core/sessionfile/database/SessionUse.h"
#include "core/study/SourceFiles.h"

#include <utility>

namespace core {

Result<std::unique_ptr<EditSession>> EditSession::create(
    EditEngine& engine, LoadedVolume volume, Options options)
{
    bool made = false;
    auto begun = guarded([&]() -> Result<std::unique_ptr<EditSession>> {
        if (const Result<void> put =
                engine.takeVolume(volume.volume.geometry.size, std::move(volume.codes));
            !put)
            return tl::unexpected(put.error());
        std::unique_ptr<SessionFile> file;
        if (!options.file.isEmpty()) {
            Result<std::unique_ptr<SessionFile>> created =
                SessionFile::create(options.file, SessionSource::of(volume.volume));
            const bool waits = !created && options.beginWithoutFile
                && created.error().code == ErrorCode::FileUnwritable;
            if (!created && !waits)
                return tl::unexpected(created.error());
            made = created.has_value();
            file = created ? *std::move(created)
                           : SessionFile::waiting(
                               options.file, SessionSource::of(volume.volume), created.error());
        }
        FileInUse sources(sourceFiles(volume.volume), FileInUse::As::Study);
        std::unique_ptr<EditSession> session(new EditSession(std::make_unique<OperationQueue>(
            engine, std::move(volume.volume), std::move(file), std::move(options.wakeUp))));
        session->m_sources = std::move(sources);
        return session;
    });
    if (!begun && made)
        removeSession(options.file);
    return begun;
}

Result<std::unique_ptr<EditSession>> EditSession::open(
    EditEngine& engine, LoadedVolume volume, const QString& file, std::function<void()> wakeUp)
{
    return guarded([&]() -> Result<std::unique_ptr<EditSession>> {
        Result<std::unique_ptr<SessionFile>> opened =
            SessionFile::open(file, SessionFile::Access::ReadWrite);
        if (!opened)
            return tl::unexpected(opened.error());
        return continued(engine, std::move(volume), *std::move(opened), std::move(wakeUp));
    });
}

Result<std::unique_ptr<EditSession>> EditSession::view(EditEngine& engine, LoadedVolume volume,
    const QString& file, const QString& why, std::function<void()> wakeUp)
{
    return guarded([&]() -> Result<std::unique_ptr<EditSession>> {
        Result<std::unique_ptr<SessionFile>> opened =
            SessionFile::open(file, SessionFile::Access::PrivateCopy);
        if (!opened)
            return tl::unexpected(opened.error());
        auto session = continued(engine, std::move(volume), *std::move(opened), std::move(wakeUp));
        if (session)
            (*session)->m_whyReadOnly = why;
        return session;
    });
}

Result<std::unique_ptr<EditSession>> EditSession::continued(EditEngine& engine, LoadedVolume volume,
    std::unique_ptr<SessionFile> file, std::function<void()> wakeUp)
{
    const QString difference = file->contents().source.differenceFrom(volume.volume);
    if (!difference.isEmpty())
        return failure(ErrorCode::SessionMismatch, file->path(), difference);
    if (const Result<void> put =
            engine.takeVolume(volume.volume.geometry.size, std::move(volume.codes));
        !put)
        return tl::unexpected(put.error());
    FileInUse sources(sourceFiles(volume.volume), FileInUse::As::Study);
    auto queue = std::make_unique<OperationQueue>(
        engine, std::move(volume.volume), std::move(file), std::move(wakeUp));
    if (const Result<void> restored = restoreSession(queue->state()); !restored)
        return tl::unexpected(restored.error());
    const RowId position = queue->state().file->contents().position;
    // What a full disk does not take now waits in memory like any later step would.
    const auto settle = [&queue]() -> Result<void> {
        const Result<void> settled = queue->settle();
        return settled || settled.error().code == ErrorCode::FileUnwritable ? Result<void>()
                                                                            : settled;
    };
    if (const Result<void> settled = settle(); !settled)
        return tl::unexpected(settled.error());
    // One after the other: a row that cannot be carried out again must not be left out by the next
    // ones, whose second halves are written.
    for (std::unique_ptr<Operation>& operation : unfinishedRows(queue->state())) {
        queue->submit(std::move(operation));
        const Result<void> settled = settle();
        if (settled)
            continue;
        queue->state().file->setPosition(position); // where the next opening goes on
        return tl::unexpected(settled.error());
    }
    std::unique_ptr<EditSession> session(new EditSession(std::move(queue)));
    session->m_sources = std::move(sources);
    return session;
}

} // namespace core
