// SPDX-License-Identifier: Apache-2.0
#include "app/commands/RecipeReports.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/session/EditSession.h"

#include <QMap>

#include <cstdio>
#include <utility>

namespace app {

namespace {

QString counted(const QMap<QString, int>& steps)
{
    QStringList words;
    for (auto step = steps.constBegin(); step != steps.constEnd(); ++step)
        words.append(QStringLiteral("%1 %2").arg(step.value()).arg(step.key()));
    return words.isEmpty() ? QStringLiteral("nothing") : words.join(QStringLiteral(", "));
}

} // namespace

QString recipeIfAtFault(const core::Error& error, const core::Recipe& recipe)
{
    using core::ErrorCode;
    switch (error.code) {
    case ErrorCode::UnknownEdit:
    case ErrorCode::InvalidField:
    case ErrorCode::SeedOutsideVolume:
    case ErrorCode::UnknownSegment:
    case ErrorCode::SegmentNotCoded:
    case ErrorCode::SegmentLocked:
    case ErrorCode::SegmentProtected:
    case ErrorCode::SeedsStay:
    case ErrorCode::NothingGrown:
    case ErrorCode::EverythingGrown:
    case ErrorCode::NoIslandThere:
    case ErrorCode::TooManyIslands:
    case ErrorCode::StepsEntangled:
        return recipe.path;
    default:
        return {};
    }
}

std::optional<std::vector<core::RecipeElsewhere::LeftOut>> reportElsewhere(
    const core::RecipeElsewhere& elsewhere, const core::Volume& volume, bool agreed)
{
    const core::Recipe& recipe = elsewhere.recorded();
    core::RecipeElsewhere::Foreseen foreseen = elsewhere.foreseen(core::initialDocument(volume));
    QMap<QString, int> applied;
    for (const core::RecipeStep& step : foreseen.recipe.steps)
        ++applied[core::stepName(step)];
    QMap<QString, int> bound;
    QStringList wanting;
    for (const core::RecipeElsewhere::LeftOut& left : foreseen.leftOut) {
        const QString name = core::stepName(recipe.steps[std::size_t(left.entry - 1)]);
        if (left.bound)
            ++bound[name];
        else
            wanting += QStringLiteral("edit %1 (%2): %3").arg(left.entry).arg(name, left.why);
    }
    QString sentence =
        QStringLiteral("%1 %2; skipped, bound to places in that study: %3")
            .arg(agreed ? QStringLiteral("applied:") : QStringLiteral("it would apply"),
                counted(applied), counted(bound));
    if (!wanting.isEmpty())
        sentence += QStringLiteral("; skipped for want of what they are about: ")
            + wanting.join(QStringLiteral(", "));
    std::fprintf(stderr, "%s: it was recorded on another study (%s); %s\n",
        qUtf8Printable(recipe.path), qUtf8Printable(recipe.study->differenceFrom(volume)),
        qUtf8Printable(sentence));
    if (agreed)
        return std::move(foreseen.leftOut);
    std::fprintf(stderr, "burin run: --apply-elsewhere does so\n");
    return {};
}

void reportWhereItGoesOn(const core::EditSession& session)
{
    const core::History& history = session.history();
    const auto last = core::RowId(history.rows().size());
    if (history.position() == last)
        return;
    const auto named = [&history](core::RowId row) {
        return QStringLiteral("row %1 '%2'").arg(QString::number(row), history.row(row).name);
    };
    const QString place = history.position() == 0
        ? QStringLiteral("at the beginning")
        : QStringLiteral("after ") + named(history.position());
    std::fprintf(stderr, "%s: goes on %s, not after the last one, %s\n",
        qUtf8Printable(session.file()), qUtf8Printable(place), qUtf8Printable(named(last)));
}

} // namespace app
