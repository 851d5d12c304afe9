// SPDX-License-Identifier: Apache-2.0
#include "app/RunCommand.h"

#include "app/Arguments.h"
#include "core/edits/EditJson.h"
#include "core/export/ExportChoices.h"
#include "core/recipe/Recipe.h"
#include "core/session/EditSession.h"
#include "core/study/StudyLoader.h"
#include "gpu/GpuEngine.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <cstdio>

namespace app {

namespace {

using core::Result;

/// Fields whose mistakes are the recipe's, not a file's.
QString recipeIfAtFault(const core::Error& error, const core::Recipe& recipe)
{
    using core::ErrorCode;
    switch (error.code) {
    case ErrorCode::UnknownEdit:
    case ErrorCode::InvalidField:
    case ErrorCode::SeedOutsideVolume:
    case ErrorCode::UnknownSegment:
    case ErrorCode::SegmentNotCoded:
        return recipe.path;
    default:
        return {};
    }
}

void print(const QJsonObject& object)
{
    std::printf("%s\n", QJsonDocument(object).toJson(QJsonDocument::Compact).constData());
    std::fflush(stdout);
}

/// One line for an edit that is carried out and on disk; an edit that changed nothing has no row.
void printEdit(const core::Edit& edit, const core::EditSession& session, bool changed)
{
    QJsonObject line{
        {QStringLiteral("edit"), core::editName(edit)},
        {QStringLiteral("row"), QJsonValue()},
        {QStringLiteral("name"), QStringLiteral("nothing changed")},
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
    print(line);
}

Result<void> carryOut(const core::Recipe& recipe, core::EditSession& session)
{
    for (const core::Edit& edit : recipe.edits) {
        const std::size_t rowsBefore = session.history().rows().size();
        if (const Result<void> applied = session.apply(edit); !applied)
            return applied;
        if (const Result<void> settled = session.settle(); !settled)
            return settled;
        printEdit(edit, session, session.history().rows().size() > rowsBefore);
    }
    return {};
}

Result<void> exportAll(const core::Recipe& recipe, core::EditSession& session, bool force)
{
    if (recipe.exports.empty())
        return {};
    const Result<std::vector<std::uint8_t>> labels = session.labels(0);
    if (!labels)
        return tl::unexpected(labels.error());
    core::ExportRequest request;
    request.force = force;
    request.planes = {{.plane = 0, .labels = *labels}};
    for (const core::ExportChoice& choice : core::exportChoices(session.document(), {})) {
        if (choice.chosen)
            request.segments.push_back(choice.segment);
    }
    for (const core::RecipeExport& target : recipe.exports) {
        request.format = target.format;
        request.file = target.file;
        const Result<core::ExportReport> report =
            core::exportMask(session.document().volumes.front(), request, core::Progress());
        if (!report)
            return tl::unexpected(report.error());
        const auto list = [](const QStringList& sentences) {
            return QJsonValue(sentences.join(QStringLiteral(" ")));
        };
        print({
            {QStringLiteral("export"), report->file},
            {QStringLiteral("written"), list(report->written)},
            {QStringLiteral("checked"), list(report->checked)},
            {QStringLiteral("cautions"), list(report->cautions)},
        });
    }
    return {};
}

/// What can be known without loading anything.
Result<void> checkSessionTarget(const QString& file, bool force)
{
    const QFileInfo info(file);
    if (info.exists() && !force)
        return core::failure(core::ErrorCode::FileExists, file);
    if (info.isDir())
        return core::failure(
            core::ErrorCode::FileUnwritable, file, QStringLiteral("it is a folder"));
    return {};
}

int run(const core::Recipe& recipe, const Arguments& arguments)
{
    const QString file = arguments.value("session");
    const bool force = arguments.has("force");
    Result<core::LoadedVolume> loaded =
        core::loadVolume(arguments.value("study"), arguments.value("series"));
    if (!loaded)
        return tellFailure(loaded.error());
    if (const Result<void> fits = core::checkRecipe(recipe, loaded->volume, force); !fits)
        return tellFailure(fits.error(), recipeIfAtFault(fits.error(), recipe));

    const Result<std::unique_ptr<gpu::GpuEngine>> engine = gpu::GpuEngine::create();
    if (!engine)
        return tellFailure(engine.error());
    Result<std::unique_ptr<core::EditSession>> session = core::EditSession::create(
        (*engine)->edits(), *std::move(loaded), {.file = file, .replaceExisting = force});
    if (!session)
        return tellFailure(session.error());
    if (const Result<void> done = carryOut(recipe, **session); !done) {
        const int status = tellFailure(done.error(), recipeIfAtFault(done.error(), recipe));
        session->reset();
        QFile::remove(file);
        return status;
    }
    // The session is whole by now and stays, whatever becomes of the exports.
    if (const Result<void> exported = exportAll(recipe, **session, force); !exported)
        return tellFailure(exported.error());
    return 0;
}

} // namespace

int runRecipe(const QStringList& words)
{
    const Arguments arguments(words,
        {QStringLiteral("study"), QStringLiteral("series"), QStringLiteral("session")},
        {QStringLiteral("force")});
    if (!arguments.problem().isEmpty())
        return tellUsage("run", arguments.problem());
    if (arguments.rest().size() != 1)
        return tellUsage("run", QStringLiteral("it needs one recipe"));
    for (const char* needed : {"study", "session"}) {
        if (!arguments.has(needed))
            return tellUsage("run", QStringLiteral("--%1 is missing").arg(QLatin1String(needed)));
    }
    const QString path = arguments.rest().first();
    const Result<core::Recipe> recipe = core::readRecipe(path);
    if (!recipe) {
        const core::ErrorCode code = recipe.error().code;
        const bool namesFile = code == core::ErrorCode::FileNotFound
            || code == core::ErrorCode::FileUnreadable || code == core::ErrorCode::InvalidRecipe;
        return tellFailure(recipe.error(), namesFile ? QString() : path);
    }
    const Result<void> target =
        checkSessionTarget(arguments.value("session"), arguments.has("force"));
    if (!target)
        return tellFailure(target.error());
    return run(*recipe, arguments);
}

} // namespace app
