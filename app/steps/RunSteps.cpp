// SPDX-License-Identifier: Apache-2.0
#include "app/steps/RunSteps.h"

#include "app/steps/JsonLine.h"
#include "app/steps/RunKeyframes.h"
#include "app/steps/SteadySession.h"
#include "core/edits/EditJson.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/session/StepFindings.h"
#include "ui/base/RevisionText.h"

#include <QJsonArray>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace app {

namespace {

using core::Result;

QString nothingChanged(const core::Edit& edit, const core::EditSession& session)
{
    const QString name = QStringLiteral("nothing changed");
    const std::optional<core::SketchedSeeds>& seeds = session.findings().sketchedSeeds();
    if (!edit.is<core::SeedStroke>() || !seeds || seeds->voxels == 0)
        return name;
    return name + QStringLiteral(": ")
        + core::canonicalName(core::sketchedTitle(*seeds, session.document()));
}

/// One line for an edit that is carried out and on disk; an edit that changed nothing has no row.
void printEdit(const core::Edit& edit, const core::EditSession& session, bool changed)
{
    QJsonObject line{
        {QStringLiteral("edit"), core::editName(edit)},
        {QStringLiteral("row"), QJsonValue()},
        {QStringLiteral("name"), nothingChanged(edit, session)},
        {QStringLiteral("voxelsChanged"), 0},
        {QStringLiteral("bricks"), 0},
        {QStringLiteral("ms"), 0},
        {QStringLiteral("hash"), QString::fromLatin1(session.stateHash())},
    };
    if (changed) {
        const core::HistoryRow& row = session.history().rows().back();
        line[QStringLiteral("row")] = qint64(row.id);
        line[QStringLiteral("name")] = row.name;
        line[QStringLiteral("voxelsChanged")] = qint64(row.statistics.voxelsChanged);
        line[QStringLiteral("bricks")] = row.statistics.bricks;
        line[QStringLiteral("ms")] = std::round(row.statistics.milliseconds * 1000.0) / 1000.0;
        line[QStringLiteral("hash")] = QString::fromLatin1(row.stateHash);
    }
    const bool revised = changed && edit.is<core::ReviseStroke>();
    const std::vector<core::RowId> keep =
        revised ? session.findings().strokesOnRevisedSurface() : std::vector<core::RowId>();
    if (revised) {
        QJsonArray rows;
        for (const core::RowId row : keep)
            rows.append(qint64(row));
        line[QStringLiteral("begunOnItsSurface")] = rows;
    }
    printJsonLine(line);
    if (!keep.empty())
        std::fprintf(stderr, "%s: %s\n", qUtf8Printable(session.history().rows().back().name),
            qUtf8Printable(ui::keepsPlaceText(keep.size())));
}

/// One line for a walk through the history: where it arrived.
void printMove(const core::RecipeStep& step, const core::EditSession& session)
{
    const core::RowId position = session.history().position();
    printJsonLine({
        {QStringLiteral("edit"), core::stepName(step)},
        {QStringLiteral("row"), qint64(position)},
        {QStringLiteral("name"),
            position == 0 ? QStringLiteral("the beginning") : session.history().row(position).name},
        {QStringLiteral("hash"), QString::fromLatin1(session.stateHash())},
    });
}

Result<void> walk(const core::HistoryMove& move, core::EditSession& session)
{
    switch (move.kind) {
    case core::HistoryMove::Kind::Undo:
        return session.undo();
    case core::HistoryMove::Kind::Redo:
        return session.redo();
    case core::HistoryMove::Kind::GoTo:
        return session.goTo(move.row);
    }
    return {};
}

/// Where a session stands.
struct Place {
    std::size_t rows = 0;
    core::RowId position = 0;

    [[nodiscard]] static Place of(const core::EditSession& session)
    {
        return {session.history().rows().size(), session.history().position()};
    }
};

/// Whether a step was done before the context was lost that it was begun in.
bool isDone(const core::RecipeStep& step, const core::EditSession& session, const Place& before)
{
    const Place now = Place::of(session);
    if (std::holds_alternative<core::Edit>(step))
        return now.rows > before.rows;
    // A walk to a row may have come half the way, and arrives there when it is begun again.
    return std::get<core::HistoryMove>(step).kind != core::HistoryMove::Kind::GoTo
        && now.position != before.position;
}

Result<void> attempt(const core::RecipeStep& step, core::EditSession& session, const Place& before)
{
    if (isDone(step, session, before))
        return {};
    const auto* edit = std::get_if<core::Edit>(&step);
    const Result<void> begun =
        edit ? session.apply(*edit) : walk(std::get<core::HistoryMove>(step), session);
    return begun ? session.settle() : begun;
}

/// What a line tells of is on disk before the line is out.
Result<void> carryOutOne(const core::RecipeStep& step, SteadySession& steady,
    RunKeyframes& keyframes, const core::Progress& progress)
{
    if (progress.cancelled())
        return core::failure(core::ErrorCode::Cancelled);
    const Place before = Place::of(steady.session());
    const Result<void> done =
        steady.carryOut([&] { return attempt(step, steady.session(), before); });
    if (!done)
        return done;
    const core::EditSession& session = steady.session();
    if (const auto* edit = std::get_if<core::Edit>(&step))
        printEdit(*edit, session, session.history().rows().size() > before.rows);
    else
        printMove(step, session);
    keyframes.follow();
    return {};
}

/// What the disk or the graphics driver says is no matter of an entry, nor is an end that somebody
/// asked for.
tl::unexpected<core::Error> at(int entry, const core::Error& error)
{
    const bool ofEntry = error.code != core::ErrorCode::FileUnwritable
        && error.code != core::ErrorCode::Cancelled && error.code != core::ErrorCode::ContextLost;
    return tl::unexpected<core::Error>(ofEntry ? core::atEdit(error, entry) : error);
}

} // namespace

Result<void> carryOut(const core::Recipe& recipe, SteadySession& session, RunKeyframes& keyframes,
    const core::Progress& progress)
{
    for (std::size_t i = 0; i < recipe.steps.size(); ++i) {
        const Result<void> done = carryOutOne(recipe.steps[i], session, keyframes, progress);
        if (!done)
            return at(int(i) + 1, done.error());
    }
    keyframes.close();
    return {};
}

Result<void> carryOutElsewhere(core::RecipeElsewhere& recipe,
    const std::vector<core::RecipeElsewhere::LeftOut>& reportedBefore, SteadySession& session,
    RunKeyframes& keyframes, const core::Progress& progress)
{
    for (std::size_t i = 0; i < recipe.recorded().steps.size(); ++i) {
        const core::Document before = session.session().document();
        const tl::expected<core::Edit, core::RecipeElsewhere::LeftOut> edit =
            recipe.here(i, before);
        if (!edit) {
            const auto isThis = [entry = edit.error().entry](
                                    const auto& told) { return told.entry == entry; };
            if (std::none_of(reportedBefore.begin(), reportedBefore.end(), isThis))
                std::fprintf(stderr, "%s: edit %d (%s) is skipped: %s\n",
                    qUtf8Printable(recipe.recorded().path), edit.error().entry,
                    qUtf8Printable(core::stepName(recipe.recorded().steps[i])),
                    qUtf8Printable(edit.error().why));
            continue;
        }
        const Result<void> done =
            carryOutOne(core::RecipeStep(*edit), session, keyframes, progress);
        if (!done)
            return at(int(i) + 1, done.error());
        recipe.carriedOut(i, before, session.session().document());
    }
    keyframes.close();
    return {};
}

} // namespace app
