// SPDX-License-Identifier: Apache-2.0
#include "core/session/SessionSalvage.h"

#include "core/base/StagedFile.h"
#include "core/session/SessionFile.h"

#include <future>
#include <utility>

namespace core {

namespace {

QString reasonOf(const Error& error)
{
    // The row is named by the damage itself.
    const QString reason = error.arguments.value(1);
    return reason.startsWith(QLatin1String("row ")) ? reason.section(QLatin1String(": "), 1)
                                                    : reason;
}

Result<void> copyRows(SessionFile& from, const SessionContents& sound, SessionFile& to)
{
    for (const HistoryRow& row : sound.rows) {
        to.addRow(row);
        // One whose second half was never written is carried out again when the copy is opened.
        if (row.stateHash.isEmpty())
            continue;
        const Result<BrickDelta> delta = from.readDelta(row.id);
        if (!delta)
            return tl::unexpected(delta.error());
        to.completeRow(row.id, row.stateHash, *delta);
    }
    for (const Keyframe& keyframe : sound.keyframes) {
        std::promise<QByteArray> png;
        from.fetchKeyframe(
            keyframe.row, [&png](const QByteArray& fetched) { png.set_value(fetched); });
        to.addKeyframe({.row = keyframe.row, .at = keyframe.at, .png = png.get_future().get()});
    }
    // Rows were added in their order; redo goes where it went.
    for (const std::pair<RowId, RowId>& step : sound.visited)
        to.setPosition(step.second);
    to.setPosition(sound.position);
    to.setHiddenSegments(sound.hiddenSegments);
    to.setDisplay(sound.display);
    return to.flush();
}

} // namespace

Result<SessionContents> checkSession(const QString& path, const Progress& progress)
{
    const Result<std::unique_ptr<SessionFile>> file =
        SessionFile::open(path, SessionFile::Access::SoundPart);
    if (!file)
        return tl::unexpected(file.error());
    SessionContents contents = (*file)->contents();
    for (const HistoryRow& row : contents.rows) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        if (row.stateHash.isEmpty())
            continue;
        if (const Result<BrickDelta> delta = (*file)->readDelta(row.id); !delta) {
            const std::int64_t known = contents.damage ? contents.damage->after : 0;
            const bool lost = contents.damage && contents.damage->row > 0;
            const auto behind = std::int64_t(contents.rows.size()) - row.id;
            SessionDamage damage{.row = row.id,
                .name = row.name,
                .after = !lost  ? behind
                    : known < 0 ? -1
                                : behind + 1 + known,
                .reason = reasonOf(delta.error())};
            contents.cut(damage);
            break;
        }
        progress.report(
            QStringLiteral("Checking the session"), int(row.id), int(contents.rows.size()));
    }
    if (contents.damage && contents.rows.empty())
        return failure(ErrorCode::SessionDamaged, path, contents.damage->text());
    return contents;
}

Result<void> salvageSession(
    const QString& damaged, const SessionContents& sound, const QString& target)
{
    const Result<std::unique_ptr<SessionFile>> from =
        SessionFile::open(damaged, SessionFile::Access::SoundPart);
    if (!from)
        return tl::unexpected(from.error());
    Result<StagedFile> staged = StagedFile::create(target, false);
    if (!staged)
        return tl::unexpected(staged.error());
    {
        const Result<std::unique_ptr<SessionFile>> to =
            SessionFile::create(staged->path(), sound.source, true);
        if (!to)
            return tl::unexpected(to.error());
        if (const Result<void> copied = copyRows(**from, sound, **to); !copied)
            return copied;
    }
    return staged->commit();
}

} // namespace core
