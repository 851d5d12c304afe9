// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/SessionSalvage.h"

#include "core/base/files/StagedError.h"
#include "core/base/files/StagedFile.h"
#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/SessionPlaces.h"
#include "core/sessionfile/records/SessionImages.h"

#include <algorithm>
#include <future>
#include <utility>

namespace core {

namespace {

Clause reasonOf(const Error& error)
{
    // The row is named by the damage itself.
    const Clause reason = error.arguments.value(1);
    if (qstrcmp(reason.form(), "row %1: %2") == 0)
        return reason.arguments()[1];
    return reason.startsWith(QLatin1String("row ")) ? Clause(reason.section(QLatin1String(": "), 1))
                                                    : reason;
}

Result<void> copyRows(SessionFile& from, const SessionContents& sound, SessionFile& to)
{
    for (const HistoryRow& row : sound.rows) {
        to.addRow(row);
        // One that lacks its second half is carried out again when the copy is opened.
        const bool again = std::any_of(sound.redo.begin(), sound.redo.end(),
            [&row](const SessionDamage& lost) { return lost.row == row.id; });
        if (row.stateHash.isEmpty() || again)
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
        if (const QByteArray picture = png.get_future().get(); !picture.isEmpty())
            to.addKeyframe({.row = keyframe.row, .at = keyframe.at, .png = picture});
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
    const auto count = std::int64_t(contents.rows.size());
    const bool lost = contents.damage && contents.damage->row > 0;
    const std::int64_t behind = lost ? contents.damage->after : 0;
    for (const HistoryRow& row : contents.rows) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        progress.report(ProgressStep::CheckingSession, int(row.id), int(count));
        if (row.stateHash.isEmpty())
            continue;
        if (const Result<BrickDelta> delta = (*file)->readDelta(row.id); !delta)
            contents.redo.push_back({.row = row.id,
                .name = row.name,
                .after = behind < 0 ? -1 : count - row.id + (lost ? 1 + behind : 0),
                .reason = reasonOf(delta.error())});
    }
    if (contents.damage && contents.rows.empty())
        return tl::unexpected(contents.damage->error(path));
    return contents;
}

Result<void> salvageSession(
    const QString& damaged, const SessionContents& sound, const QString& target)
{
    const Result<std::unique_ptr<SessionFile>> from =
        SessionFile::open(damaged, SessionFile::Access::SoundPart);
    if (!from)
        return tl::unexpected(from.error());
    if (const Result<void> place = checkSessionPlace(target, false); !place)
        return place;
    Result<StagedFile> staged = StagedFile::create(target, false);
    if (!staged)
        return tl::unexpected(staged.error());
    {
        const Result<std::unique_ptr<SessionFile>> to =
            SessionFile::createIn(*staged, sound.source);
        if (!to)
            return tl::unexpected(namingTarget(to.error(), *staged));
        if (const Result<void> copied = copyRows(**from, sound, **to); !copied)
            return tl::unexpected(namingTarget(copied.error(), *staged));
    }
    // Images that are damaged are left behind; whoever has the study does not miss them.
    if (sound.holdsImages) {
        const Result<void> copied = copySessionImages(damaged, staged->path());
        if (!copied && copied.error().code != ErrorCode::SessionDamaged
            && copied.error().code != ErrorCode::NoImages)
            return tl::unexpected(namingTarget(copied.error(), *staged));
    }
    return staged->commit();
}

} // namespace core
