// SPDX-License-Identifier: Apache-2.0
#include "app/commands/RecipeRun.h"

#include "app/commands/RecipeReports.h"
#include "app/end/CommandTermination.h"
#include "app/steps/Arguments.h"
#include "app/steps/ExportFiles.h"
#include "app/steps/JsonLine.h"
#include "app/steps/RunKeyframes.h"
#include "app/steps/RunSteps.h"
#include "app/steps/SessionProblems.h"
#include "app/steps/SessionTarget.h"
#include "core/base/Guarded.h"
#include "core/base/files/StagedFile.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/session/EditSession.h"
#include "core/session/SessionStorage.h"
#include "core/sessionfile/CloseSessionFiles.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/SessionStudy.h"
#include "core/sessionfile/database/SessionUse.h"
#include "core/study/SourceFiles.h"
#include "core/study/StudyLoader.h"
#include "gpu/engine/GpuEngine.h"
#include "ui/base/ErrorText.h"
#include "ui/texts/MaskTexts.h"

#include <QFileInfo>
#include <QScopeGuard>

#include <cstdio>
#include <utility>

namespace app {

using core::Result;

namespace {

/// @param repair of the series, where the recipe says that it was recorded on a repaired one
Result<core::LoadedVolume> loadStudy(const Arguments& arguments,
    const std::optional<core::SessionContents>& goesOn, const core::Progress& progress,
    const QString& repair = {})
{
    if (!goesOn)
        return core::loadVolume(arguments.value("study"), seriesOf(arguments, repair), progress);
    return core::loadSessionStudy(arguments.value("session"), goesOn->source,
        arguments.value("study"), arguments.value("series"), progress);
}

/// A session that goes on, and how.
struct Continued {
    SessionPlan plan;
    std::unique_ptr<core::EditSession> session;
};

/// As the window does: a damaged file keeps its bytes, and its sound rows go on in a new one.
Result<Continued> goOn(core::EditEngine& engine, core::LoadedVolume loaded,
    const Arguments& arguments, const core::SessionContents& contents)
{
    const QString file = arguments.value("session");
    if (contents.isWhole()) {
        auto session = core::EditSession::open(engine, std::move(loaded), file);
        if (!session)
            return tl::unexpected(session.error());
        return Continued{{.file = file}, *std::move(session)};
    }
    for (const bool redo : {true, false}) {
        if (!redo) {
            Result<core::LoadedVolume> again = loadStudy(arguments, contents, core::Progress());
            if (!again)
                return tl::unexpected(again.error());
            loaded = *std::move(again);
        }
        const Result<SessionPlan> plan = planFor(file, contents, redo);
        if (!plan)
            return tl::unexpected(plan.error());
        auto session = openPlanned(engine, std::move(loaded), *plan);
        if (session)
            return Continued{*plan, *std::move(session)};
        if (const Result<void> withdrawn = withdraw(*plan, file); !withdrawn)
            return tl::unexpected(withdrawn.error());
        if (plan->redo.empty() || session.error().code == core::ErrorCode::ContextLost)
            return tl::unexpected(session.error());
    }
    return core::failure(core::ErrorCode::SessionDamaged, file);
}

/// The session may not be there yet, so nobody else knows its name.
Result<void> checkExportsBeside(const core::Recipe& recipe, const QString& session)
{
    const std::optional<core::FileIdentity> own = core::FileIdentity::of(session);
    for (const core::RecipeExport& target : recipe.exports) {
        for (const QString& file : core::filesWritten(target)) {
            if (own && core::FileIdentity::of(file) == own)
                return core::failure(core::ErrorCode::FileUnwritable, file,
                    QStringLiteral("it is the session's own name"));
        }
    }
    return {};
}

void closeSessions()
{
    core::closeSessionFiles({core::ErrorCode::Cancelled, {}});
}

} // namespace

RecipeRun::RecipeRun(
    core::Recipe recipe, const Arguments& arguments, CommandTermination& termination)
    : m_recipe(std::move(recipe))
    , m_arguments(arguments)
    , m_termination(termination)
    , m_file(arguments.value("session"))
    , m_force(arguments.has("force"))
    , m_replaces(m_force && QFileInfo::exists(m_file))
    , m_place(m_replaces ? core::temporaryNameBeside(m_file) : m_file)
{
    // What another study was recorded with may make no sense on this one.
    if (m_recipe.study && !arguments.has("apply-elsewhere"))
        m_repair = m_recipe.study->repair;
}

int RecipeRun::carryOut()
{
    if (const Result<void> beside = checkExportsBeside(m_recipe, m_file); !beside)
        return reportFailure(beside.error());
    if (const std::optional<int> status = openStudy())
        return *status;
    if (const std::optional<int> status = prepareRecipe())
        return *status;
    if (const std::optional<int> status = openSession())
        return *status;
    m_termination.setClosing([replaces = m_replaces, place = m_place, file = m_file] {
        closeSessions();
        if (replaces)
            keepUnfinished(place, file);
    });
    const auto leaving = qScopeGuard([this] { m_termination.setClosing({}); });
    follow(m_steady.session());
    if (m_arguments.has("facts"))
        printJsonLine({{QStringLiteral("source"), m_source.toJson()},
            {QStringLiteral("renderer"), m_steady.engine().rendererName()},
            {QStringLiteral("driver"), m_steady.engine().versionText()},
            {QStringLiteral("stateHash"), QString::fromLatin1(m_steady.session().stateHash())}});
    if (const std::optional<int> status = carryOutSteps())
        return *status;
    if (m_replaces) {
        if (const std::optional<int> status = replaceOlder())
            return *status;
    }
    return exportAndClose();
}

std::optional<int> RecipeRun::openStudy()
{
    if (m_arguments.has("append")) {
        Result<core::SessionContents> contents = core::checkSession(m_file);
        if (!contents)
            return reportFailure(contents.error());
        m_goesOn = *std::move(contents);
        reportLeft(m_file, *m_goesOn);
    }
    m_loaded = load();
    if (!m_loaded)
        return reportFailure(m_loaded.error());
    const core::Volume& volume = m_loaded->volume;
    reportNotFromStudy(m_loaded->notFromStudy, m_file);
    reportProblems(volume, m_arguments.has("study") ? m_arguments.value("study") : m_file);
    m_source = core::SessionSource::of(volume);
    core::fillSurfaces(m_recipe, volume);
    m_sources.emplace(core::sourceFiles(volume), core::FileInUse::As::Study);
    m_masks.emplace(core::masksOf(m_recipe), core::FileInUse::As::Mask);
    return {};
}

/// Reads the masks that it names, and finds out whether it fits the study.
std::optional<int> RecipeRun::prepareRecipe()
{
    const core::Volume& volume = m_loaded->volume;
    if (!m_goesOn) {
        if (const Result<void> target = checkSessionTarget(m_file, m_force, false); !target)
            return reportFailure(target.error());
    }
    const auto notes = core::readMasks(m_recipe, volume);
    if (!notes)
        return reportFailure(notes.error());
    for (const core::RecipeMaskNote& each : *notes)
        std::fprintf(stderr, "%s: %s\n", qUtf8Printable(each.file),
            qUtf8Printable(ui::maskNoteText(each.note)));
    if (m_recipe.study && !m_recipe.study->differenceFrom(volume).isEmpty()) {
        m_elsewhere.emplace(m_recipe);
        auto reported = reportElsewhere(*m_elsewhere, volume, m_arguments.has("apply-elsewhere"));
        if (!reported)
            return 1;
        m_leftOut = *std::move(reported);
    }
    if (!m_goesOn) {
        if (const Result<void> fit = checkAgainst(core::initialDocument(volume)); !fit)
            return reportFailure(fit.error(), recipeIfAtFault(fit.error(), m_recipe));
    }
    return {};
}

Result<void> RecipeRun::checkAgainst(const core::Document& document) const
{
    const Result<void> fit = core::checkRecipe(
        m_elsewhere ? m_elsewhere->foreseen(document).recipe : m_recipe, document, m_force);
    return m_goesOn ? withoutForce(fit) : fit;
}

Result<core::LoadedVolume> RecipeRun::load() const
{
    return loadStudy(m_arguments, m_goesOn, m_termination.progress(), m_repair);
}

std::optional<int> RecipeRun::openSession()
{
    if (const Result<void> started = m_steady.start(); !started)
        return reportFailure(started.error());
    const Result<void> opened =
        m_steady.open([this](gpu::GpuEngine& engine) { return openFirst(engine); },
            [this](gpu::GpuEngine& engine) { return openAgain(engine); });
    if (!opened)
        return reportFailure(m_goesOn ? opened.error() : ofTarget(opened.error(), m_place, m_file));
    m_openFile = m_steady.session().file();
    m_made = core::FollowedFile(m_openFile);
    return {};
}

Result<SteadySession::Session> RecipeRun::openFirst(gpu::GpuEngine& engine)
{
    if (!std::exchange(m_isFirst, false)) {
        m_loaded = load();
        if (!m_loaded)
            return tl::unexpected(m_loaded.error());
    }
    engine.setVolumeGeometry(m_loaded->volume.geometry, m_loaded->volume.encoding);
    if (!m_goesOn)
        return beginSession(
            engine.edits(), *std::move(m_loaded), m_place, m_arguments.has("with-images"));
    Result<Continued> continued =
        goOn(engine.edits(), *std::move(m_loaded), m_arguments, *m_goesOn);
    if (!continued)
        return tl::unexpected(continued.error());
    m_plan = std::move(continued->plan);
    return std::move(continued->session);
}

Result<SteadySession::Session> RecipeRun::openAgain(gpu::GpuEngine& engine)
{
    // If it was renamed as it was closed, nobody was told; another file may have its name by now.
    if (const QString now = m_made.path(); !m_made.isAt(m_openFile) && !now.isEmpty())
        m_openFile = now;
    Result<core::LoadedVolume> study = readStudy(m_openFile);
    if (!study)
        return tl::unexpected(study.error());
    engine.setVolumeGeometry(study->volume.geometry, study->volume.encoding);
    auto opened = core::EditSession::open(engine.edits(), *std::move(study), m_openFile);
    if (opened)
        follow(**opened);
    return opened;
}

Result<core::LoadedVolume> RecipeRun::readStudy(const QString& session) const
{
    // Where the user says that it is; the session may not be allowed to send anybody there.
    Result<core::LoadedVolume> study = core::loadSessionStudy(
        session, m_source, m_arguments.value("study"), m_arguments.value("series"));
    if (study || study.error().code == core::ErrorCode::Cancelled)
        return study;
    // It has gone meanwhile: the session may know another place, or hold the images.
    Result<core::LoadedVolume> other = core::loadSessionStudy(session, m_source);
    return other ? std::move(other) : std::move(study);
}

void RecipeRun::follow(core::EditSession& session)
{
    session.setOrigin(
        [author = m_arguments.value("author")] { return core::presentOrigin(author); });
    // If the disk does not take a step, the step that waits for that says so.
    session.setErrorListener([this](const core::Error& error) {
        if (error.code != core::ErrorCode::SessionMoved)
            return;
        m_openFile = error.arguments.value(0);
        m_made = core::FollowedFile(m_openFile);
        std::fprintf(stderr, "burin: %s\n", qUtf8Printable(ui::errorText(error)));
    });
}

std::optional<int> RecipeRun::carryOutSteps()
{
    const std::size_t rowsBefore = m_steady.rowCount();
    Result<void> done = m_goesOn ? checkAgainst(m_steady.session().document()) : Result<void>();
    if (done) {
        if (m_plan.damage)
            reportFailure(*m_plan.damage);
        if (m_goesOn)
            reportWhereItGoesOn(m_steady.session());
        done = core::guarded([&] {
            RunKeyframes keyframes(m_steady);
            return m_elsewhere
                ? carryOutElsewhere(
                    *m_elsewhere, m_leftOut, m_steady, keyframes, m_termination.progress())
                : app::carryOut(m_recipe, m_steady, keyframes, m_termination.progress());
        });
    }
    if (done)
        return {};
    return giveUp(done.error(), rowsBefore);
}

/// Leaves behind what was promised, and nothing else.
int RecipeRun::giveUp(const core::Error& why, std::size_t rowsBefore)
{
    m_termination.setClosing({});
    const core::Error error = ofTarget(why, m_place, m_file);
    const int status = reportFailure(error, recipeIfAtFault(error, m_recipe));
    // A line that was printed is a promise: what it tells of stays.
    const bool promised = m_steady.rowCount() > rowsBefore;
    m_steady.close();
    if (!m_goesOn && !promised) {
        // Another program may have renamed it, and given its name to something else.
        if (m_made.isAt(m_place))
            core::removeSession(m_place);
    } else if (m_replaces) {
        keepUnfinished(m_place, m_file);
    } else if (!m_plan.damaged.isEmpty() && !promised && m_made.isAt(m_plan.file)) {
        if (const Result<void> withdrawn = withdraw(m_plan, m_file); !withdrawn)
            reportFailure(withdrawn.error());
    }
    return status;
}

std::optional<int> RecipeRun::replaceOlder()
{
    // From here on it is the session of that name.
    m_termination.setClosing(closeSessions);
    const Result<void> placed =
        m_steady.carryOut([&] { return m_steady.session().storage().rename(m_file); });
    if (!placed) {
        const int status = reportFailure(placed.error());
        std::fprintf(stderr, "%s: the new session is in %s\n", qUtf8Printable(m_file),
            qUtf8Printable(m_steady.isOpen() ? m_steady.session().file() : m_openFile));
        return status;
    }
    m_openFile = m_file;
    return {};
}

/// The session is whole by now and stays, whatever becomes of the exports.
int RecipeRun::exportAndClose()
{
    const std::vector<core::RecipeExport> exports =
        m_elsewhere ? m_elsewhere->exports() : m_recipe.exports;
    const Result<void> exported = core::guarded([&] {
        return exportFiles(
            exports, m_steady, m_force, [&] { return readStudy(m_openFile); },
            m_termination.progress());
    });
    if (!exported)
        return reportFailure((m_goesOn ? withoutForce(exported) : exported).error());
    m_termination.setClosing({});
    std::optional<core::Error> trouble;
    if (m_steady.isOpen()) {
        m_steady.session().storage().finishWriting();
        trouble = m_steady.session().storage().trouble();
    }
    m_steady.close();
    // The session could not be followed to its new name; its last writes lie beside it there.
    if (trouble && !m_made.isAt(m_openFile))
        return reportUnfollowed(*trouble, m_openFile);
    if (const QString wrong = whyNotOneFile(m_openFile); !wrong.isEmpty())
        return reportFailure({core::ErrorCode::FileUnwritable, {m_openFile, wrong}});
    // The steps stand, but not where they were meant to.
    return m_goesOn && m_goesOn->positionLost ? 1 : 0;
}

} // namespace app
