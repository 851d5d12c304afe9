// SPDX-License-Identifier: Apache-2.0
#include "app/ReplayCommand.h"

#include "app/Arguments.h"
#include "core/session/EditSession.h"
#include "core/session/SessionFile.h"
#include "core/session/SessionStudy.h"
#include "gpu/GpuEngine.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <cstdio>

namespace app {

namespace {

using core::Result;

tl::unexpected<core::Error> disagrees(
    const core::SessionFile& file, const core::HistoryRow& row, const QString& how)
{
    return core::failure(core::ErrorCode::SessionDamaged, file.path(),
        QStringLiteral("row %1 ('%2') does not agree: %3").arg(row.id).arg(row.name, how));
}

/// Carries out one row where it belongs and compares.
Result<void> replay(
    const core::HistoryRow& row, core::SessionFile& file, core::EditSession& session)
{
    if (const Result<void> moved = session.goTo(row.parent); !moved)
        return moved;
    if (const Result<void> settled = session.settle(); !settled)
        return settled;
    if (const Result<void> applied = session.apply(row.edit); !applied)
        return disagrees(file, row, QStringLiteral("it is refused now"));
    if (const Result<void> settled = session.settle(); !settled)
        return settled;
    const std::vector<core::HistoryRow>& rows = session.history().rows();
    if (rows.size() != std::size_t(row.id))
        return disagrees(file, row, QStringLiteral("it changes nothing now"));
    const QByteArray hash = rows.back().stateHash;
    const bool finished = !row.stateHash.isEmpty();
    if (finished && hash != row.stateHash)
        return disagrees(file, row,
            QStringLiteral("recorded %1, replayed %2")
                .arg(QString::fromLatin1(row.stateHash), QString::fromLatin1(hash)));
    if (finished) {
        if (const Result<core::BrickDelta> delta = file.readDelta(row.id); !delta)
            return tl::unexpected(delta.error());
    }
    const QJsonObject line{
        {QStringLiteral("row"), qint64(row.id)},
        {QStringLiteral("name"), row.name},
        {QStringLiteral("hash"), QString::fromLatin1(hash)},
        {QStringLiteral("agrees"), finished ? QJsonValue(true) : QJsonValue()},
    };
    std::printf("%s\n", QJsonDocument(line).toJson(QJsonDocument::Compact).constData());
    return {};
}

int replayAll(core::SessionFile& file, core::LoadedVolume volume)
{
    const Result<std::unique_ptr<gpu::GpuEngine>> engine = gpu::GpuEngine::create();
    if (!engine)
        return tellFailure(engine.error());
    const Result<std::unique_ptr<core::EditSession>> session =
        core::EditSession::create((*engine)->edits(), std::move(volume), {});
    if (!session)
        return tellFailure(session.error());
    int unfinished = 0;
    for (const core::HistoryRow& row : file.contents().rows) {
        if (const Result<void> replayed = replay(row, file, **session); !replayed)
            return tellFailure(replayed.error());
        unfinished += row.stateHash.isEmpty() ? 1 : 0;
    }
    const auto rows = int(file.contents().rows.size());
    std::fprintf(
        stderr, "%s: %d of %d rows agree", qUtf8Printable(file.path()), rows - unfinished, rows);
    if (unfinished > 0)
        std::fprintf(stderr, "; %d were not finished when the session was left", unfinished);
    std::fprintf(stderr, "\n");
    return 0;
}

} // namespace

int runReplay(const QStringList& words)
{
    const Arguments arguments(
        words, {QStringLiteral("study"), QStringLiteral("series")}, {QStringLiteral("verify")});
    if (!arguments.problem().isEmpty())
        return tellUsage("replay", arguments.problem());
    if (arguments.rest().size() != 1)
        return tellUsage("replay", QStringLiteral("it needs one session file"));
    if (!arguments.has("verify"))
        return tellUsage(
            "replay", QStringLiteral("--verify is missing: it is all that replay does"));

    const Result<std::unique_ptr<core::SessionFile>> file =
        core::SessionFile::open(arguments.rest().first(), core::SessionFile::Access::ReadOnly);
    if (!file)
        return tellFailure(file.error());
    Result<core::LoadedVolume> volume = core::loadSessionStudy((*file)->path(),
        (*file)->contents().source, arguments.value("study"), arguments.value("series"));
    if (!volume)
        return tellFailure(volume.error());
    return replayAll(**file, *std::move(volume));
}

} // namespace app
