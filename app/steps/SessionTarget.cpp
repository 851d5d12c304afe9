// SPDX-License-Identifier: Apache-2.0
#include "app/steps/SessionTarget.h"

#include "app/steps/SessionPlan.h"
#include "core/base/files/FollowedFile.h"
#include "core/base/files/ReadableFile.h"
#include "core/base/files/StagedFile.h"
#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/SessionPlaces.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/database/SessionUse.h"
#include "core/sessionfile/records/SessionImages.h"

#include <QDir>
#include <QFileInfo>

#include <cstdio>
#include <utility>

namespace app {

using core::Result;

namespace {

/// A name that is free, for what was done of a session that was to replace another one.
QString nameForUnfinished(const QString& file)
{
    const QFileInfo info(file);
    QString path;
    int count = 1;
    do {
        const QString number = count == 1 ? QString() : QStringLiteral(" %1").arg(count);
        path = info.absoluteDir().filePath(
            QStringLiteral("%1 (unfinished%2).burin").arg(info.completeBaseName(), number));
        ++count;
    } while (core::isSessionNameTaken(path));
    return path;
}

} // namespace

Result<void> checkSessionTarget(const QString& file, bool force, bool append)
{
    if (append && !QFileInfo::exists(file))
        return core::failure(core::ErrorCode::FileNotFound, file);
    if (append)
        return core::checkReadsToAnEnd(file);
    if (const Result<void> target = core::checkFileTarget(file, force); !target)
        return target;
    // One that was left open is closed as it would be by opening it; what cannot be is refused.
    if (core::isSessionUnfinished(file) && core::isSessionFile(file) && !core::isSessionInUse(file))
        static_cast<void>(core::SessionFile::open(file, core::SessionAccess::ReadWrite));
    return core::checkReplacedSession(file);
}

Result<std::unique_ptr<core::EditSession>> beginSession(
    core::EditEngine& engine, core::LoadedVolume loaded, const QString& file, bool withImages)
{
    if (!withImages)
        return core::EditSession::create(engine, std::move(loaded), {.file = file});
    if (const Result<void> place = core::checkSessionPlace(file, false); !place)
        return tl::unexpected(place.error());
    Result<core::StagedFile> staged = core::stageImages(file, false, loaded);
    if (!staged)
        return tl::unexpected(staged.error());
    const core::FollowedFile made(staged->path());
    if (const Result<void> placed = staged->commit(); !placed)
        return tl::unexpected(placed.error());
    auto session = core::EditSession::open(engine, std::move(loaded), file);
    // Another program may have put another file in its place.
    if (!session && made.isAt(file))
        core::removeSession(file);
    return session;
}

QString whyNotOneFile(const QString& file)
{
    if (core::isSessionUnfinished(file))
        return QStringLiteral("it could not be closed as one file: what was done last lies in "
                              "'%1' beside it; keep both together and open it once")
            .arg(QFileInfo(file).fileName() + QStringLiteral("-wal"));
    return core::sessionLoss(file).leftOpen;
}

core::Error ofTarget(core::Error error, const QString& place, const QString& file)
{
    error.arguments.replace(place, file);
    return error;
}

void keepUnfinished(const QString& place, const QString& file)
{
    const QString kept = nameForUnfinished(file);
    // What could not be folded back goes with it, and stays with it.
    const bool named = QFileInfo::exists(place) && renameSession(place, kept);
    std::fprintf(stderr, "%s: stays as it was; what was done is in %s\n", qUtf8Printable(file),
        qUtf8Printable(named ? kept : place));
}

} // namespace app
