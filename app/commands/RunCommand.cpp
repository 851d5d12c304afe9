// SPDX-License-Identifier: Apache-2.0
#include "app/commands/RunCommand.h"

#include "app/end/CommandTermination.h"
#include "app/steps/Arguments.h"
#include "app/steps/ExportFiles.h"
#include "app/steps/JsonLine.h"
#include "app/steps/RunKeyframes.h"
#include "app/steps/RunSteps.h"
#include "app/steps/SessionPlan.h"
#include "app/steps/SessionProblems.h"
#include "app/steps/SessionTarget.h"
#include "app/steps/SteadySession.h"
#include "app/steps/TracedRun.h"
#include "core/base/Guarded.h"
#include "core/base/files/FileInUse.h"
#include "core/base/files/FollowedFile.h"
#include "core/base/files/StagedFile.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/Edit.h"
#include "core/recipe/Recipe.h"
#include "core/session/EditSession.h"
#include "core/session/SessionStorage.h"
#include "core/sessionfile/CloseSessionFiles.h"
#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/SessionStudy.h"
#include "core/sessionfile/database/SessionUse.h"
#include "core/sessionfile/records/SessionImages.h"
#include "core/study/SourceFiles.h"
#include "core/study/StudyLoader.h"
#include "gpu/engine/GpuEngine.h"
#include "ui/base/ErrorText.h"
#include "ui/texts/MaskTexts.h"

#include <QFile>
#include <QFileInfo>
#include <QMap>
#include <QScopeGuard>

#include <cstdio>
#include <optional>
#include <utility>

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

QString counted(const QMap<QString, int>& steps)
{
    QStringList words;
    for (auto step = steps.constBegin(); step != steps.constEnd(); ++step)
        words.append(QStringLiteral("%1 %2").arg(step.value()).arg(step.key()));
    return words.isEmpty() ? QStringLiteral("nothing") : words.join(QStringLiteral(", "));
}

/// What of a recipe is carried out on another study, told on stderr.
/// @return what is left out; nothing where the user has to agree first
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

/// @param repair of the series, where the recipe says that it was recorded on a repaired one
Result<core::LoadedVolume> load(const Arguments& arguments,
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
            Result<core::LoadedVolume> again = load(arguments, contents, core::Progress());
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

/// A new session.
Result<std::unique_ptr<core::EditSession>> begin(
    core::EditEngine& engine, core::LoadedVolume loaded, const QString& file, bool withImages)
{
    if (!withImages)
        return core::EditSession::create(engine, std::move(loaded), {.file = file});
    Result<core::StagedFile> staged = core::stageImages(file, false, loaded);
    if (!staged)
        return tl::unexpected(staged.error());
    if (const Result<void> placed = staged->commit(); !placed)
        return tl::unexpected(placed.error());
    return core::EditSession::open(engine, std::move(loaded), file);
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

/// If steps were undone, or somebody went back to an earlier one, new rows do not follow the last:
/// says so.
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

void closeSessions()
{
    core::closeSessionFiles({core::ErrorCode::Cancelled, {}});
}

int run(core::Recipe recipe, const Arguments& arguments, CommandTermination& termination)
{
    const QString file = arguments.value("session");
    const bool force = arguments.has("force");
    // A session that is to be replaced stays until the new one is whole.
    const bool replaces = force && QFileInfo::exists(file);
    const QString place = replaces ? core::temporaryNameBeside(file) : file;
    if (const Result<void> beside = checkExportsBeside(recipe, file); !beside)
        return reportFailure(beside.error());
    std::optional<core::SessionContents> goesOn;
    if (arguments.has("append")) {
        Result<core::SessionContents> contents = core::checkSession(file);
        if (!contents)
            return reportFailure(contents.error());
        goesOn = *std::move(contents);
        reportLeft(file, *goesOn);
    }
    // What another study was recorded with may make no sense on this one.
    const QString repair =
        recipe.study && !arguments.has("apply-elsewhere") ? recipe.study->repair : QString();
    Result<core::LoadedVolume> loaded = load(arguments, goesOn, termination.progress(), repair);
    if (!loaded)
        return reportFailure(loaded.error());
    reportNotFromStudy(loaded->notFromStudy, file);
    reportProblems(loaded->volume, arguments.has("study") ? arguments.value("study") : file);
    core::fillSurfaces(recipe, loaded->volume);
    const core::FileInUse sources(core::sourceFiles(loaded->volume), core::FileInUse::As::Study);
    const core::FileInUse masks(core::masksOf(recipe), core::FileInUse::As::Mask);
    if (!goesOn) {
        if (const Result<void> target = checkSessionTarget(file, force, false); !target)
            return reportFailure(target.error());
    }
    const auto notes = core::readMasks(recipe, loaded->volume);
    if (!notes)
        return reportFailure(notes.error());
    for (const core::RecipeMaskNote& each : *notes)
        std::fprintf(stderr, "%s: %s\n", qUtf8Printable(each.file),
            qUtf8Printable(ui::maskNoteText(each.note)));
    std::optional<core::RecipeElsewhere> elsewhere;
    std::vector<core::RecipeElsewhere::LeftOut> leftOut;
    if (recipe.study && !recipe.study->differenceFrom(loaded->volume).isEmpty()) {
        elsewhere.emplace(recipe);
        auto reported =
            reportElsewhere(*elsewhere, loaded->volume, arguments.has("apply-elsewhere"));
        if (!reported)
            return 1;
        leftOut = *std::move(reported);
    }
    const auto fits = [&](const core::Document& document) {
        const Result<void> fit = core::checkRecipe(
            elsewhere ? elsewhere->foreseen(document).recipe : recipe, document, force);
        return goesOn ? withoutForce(fit) : fit;
    };
    if (!goesOn) {
        if (const Result<void> fit = fits(core::initialDocument(loaded->volume)); !fit)
            return reportFailure(fit.error(), recipeIfAtFault(fit.error(), recipe));
    }

    SteadySession steady;
    if (const Result<void> started = steady.start(); !started)
        return reportFailure(started.error());
    SessionPlan plan;
    const core::SessionSource source = core::SessionSource::of(loaded->volume);
    // Where the user says that it is; the session may not be allowed to send anybody there.
    const auto readStudy = [&](const QString& session) {
        Result<core::LoadedVolume> study = core::loadSessionStudy(
            session, source, arguments.value("study"), arguments.value("series"));
        if (study || study.error().code == core::ErrorCode::Cancelled)
            return study;
        // It has gone meanwhile: the session may know another place, or hold the images.
        Result<core::LoadedVolume> other = core::loadSessionStudy(session, source);
        return other ? std::move(other) : std::move(study);
    };
    QString openFile = place; ///< of the session, closed or open
    core::FollowedFile made; ///< that file
    const auto follow = [author = arguments.value("author"), &openFile, &made](
                            core::EditSession& session) {
        session.setOrigin([author] { return core::presentOrigin(author); });
        // If the disk does not take a step, the step that waits for that says so.
        session.setErrorListener([&openFile, &made](const core::Error& error) {
            if (error.code != core::ErrorCode::SessionMoved)
                return;
            openFile = error.arguments.value(0);
            made = core::FollowedFile(openFile);
            std::fprintf(stderr, "burin: %s\n", qUtf8Printable(ui::errorText(error)));
        });
    };
    bool isFirst = true;
    const auto first = [&](gpu::GpuEngine& engine) -> Result<SteadySession::Session> {
        if (!std::exchange(isFirst, false)) {
            loaded = load(arguments, goesOn, termination.progress(), repair);
            if (!loaded)
                return tl::unexpected(loaded.error());
            if (!goesOn)
                core::removeSession(place);
        }
        engine.setVolumeGeometry(loaded->volume.geometry, loaded->volume.encoding);
        if (!goesOn)
            return begin(engine.edits(), *std::move(loaded), place, arguments.has("with-images"));
        Result<Continued> continued = goOn(engine.edits(), *std::move(loaded), arguments, *goesOn);
        if (!continued)
            return tl::unexpected(continued.error());
        plan = std::move(continued->plan);
        return std::move(continued->session);
    };
    const auto again = [&](gpu::GpuEngine& engine) -> Result<SteadySession::Session> {
        // If it was renamed as it was closed, nobody was told; another file may have its name by
        // now.
        if (const QString now = made.path(); !made.isAt(openFile) && !now.isEmpty())
            openFile = now;
        Result<core::LoadedVolume> study = readStudy(openFile);
        if (!study)
            return tl::unexpected(study.error());
        engine.setVolumeGeometry(study->volume.geometry, study->volume.encoding);
        auto opened = core::EditSession::open(engine.edits(), *std::move(study), openFile);
        if (opened)
            follow(**opened);
        return opened;
    };
    if (const Result<void> opened = steady.open(first, again); !opened)
        return reportFailure(goesOn ? opened.error() : ofTarget(opened.error(), place, file));
    openFile = steady.session().file();
    made = core::FollowedFile(openFile);
    termination.setClosing([replaces, place, file] {
        closeSessions();
        if (replaces)
            keepUnfinished(place, file);
    });
    const auto leaving = qScopeGuard([&termination] { termination.setClosing({}); });
    follow(steady.session());
    if (arguments.has("facts"))
        printJsonLine({{QStringLiteral("source"), source.toJson()},
            {QStringLiteral("renderer"), steady.engine().rendererName()},
            {QStringLiteral("driver"), steady.engine().versionText()},
            {QStringLiteral("stateHash"), QString::fromLatin1(steady.session().stateHash())}});
    const std::size_t rowsBefore = steady.rowCount();
    Result<void> done = goesOn ? fits(steady.session().document()) : Result<void>();
    if (done) {
        if (plan.damage)
            reportFailure(*plan.damage);
        if (goesOn)
            reportWhereItGoesOn(steady.session());
        done = core::guarded([&] {
            RunKeyframes keyframes(steady);
            return elsewhere
                ? carryOutElsewhere(*elsewhere, leftOut, steady, keyframes, termination.progress())
                : carryOut(recipe, steady, keyframes, termination.progress());
        });
    }
    if (!done) {
        termination.setClosing({});
        const core::Error error = ofTarget(done.error(), place, file);
        const int status = reportFailure(error, recipeIfAtFault(error, recipe));
        // A line that was printed is a promise: what it tells of stays.
        const bool promised = steady.rowCount() > rowsBefore;
        steady.close();
        if (!goesOn && !promised) {
            // Another program may have renamed it, and given its name to something else.
            if (made.isAt(place))
                core::removeSession(place);
        } else if (replaces) {
            keepUnfinished(place, file);
        } else if (!plan.damaged.isEmpty() && !promised) {
            if (const Result<void> withdrawn = withdraw(plan, file); !withdrawn)
                reportFailure(withdrawn.error());
        }
        return status;
    }
    if (replaces) {
        // From here on it is the session of that name.
        termination.setClosing(closeSessions);
        const Result<void> placed =
            steady.carryOut([&] { return steady.session().storage().rename(file); });
        if (!placed) {
            const int status = reportFailure(placed.error());
            std::fprintf(stderr, "%s: the new session is in %s\n", qUtf8Printable(file),
                qUtf8Printable(steady.isOpen() ? steady.session().file() : openFile));
            return status;
        }
        openFile = file;
    }
    // The session is whole by now and stays, whatever becomes of the exports.
    const std::vector<core::RecipeExport> exports =
        elsewhere ? elsewhere->exports() : recipe.exports;
    const Result<void> exported = core::guarded([&] {
        return exportFiles(
            exports, steady, force, [&] { return readStudy(openFile); }, termination.progress());
    });
    if (!exported)
        return reportFailure((goesOn ? withoutForce(exported) : exported).error());
    termination.setClosing({});
    std::optional<core::Error> trouble;
    if (steady.isOpen()) {
        steady.session().storage().finishWriting();
        trouble = steady.session().storage().trouble();
    }
    steady.close();
    // The session could not be followed to its new name; its last writes lie beside it there.
    if (trouble && !made.isAt(openFile))
        return reportUnfollowed(*trouble, openFile);
    if (const QString why = whyNotOneFile(openFile); !why.isEmpty())
        return reportFailure({core::ErrorCode::FileUnwritable, {openFile, why}});
    // The steps stand, but not where they were meant to.
    return goesOn && goesOn->positionLost ? 1 : 0;
}

int runRecipe(const Arguments& arguments)
{
    if (arguments.rest().size() != 1)
        return reportUsageError("run", QStringLiteral("it needs one recipe"));
    if (const QString wrong = repairProblem(arguments); !wrong.isEmpty())
        return reportUsageError("run", wrong);
    if (arguments.has("facts"))
        tellFailuresAsFacts();
    const bool append = arguments.has("append");
    if (append && arguments.has("force"))
        return reportUsageError("run", QStringLiteral("--append and --force exclude each other"));
    if (append && (arguments.has("repair") || arguments.has("spacing")))
        return reportUsageError("run",
            QStringLiteral("--repair and --spacing are for a new session; one that goes on "
                           "keeps those that it was made with"));
    if (append && arguments.has("with-images"))
        return reportUsageError("run",
            QStringLiteral("--with-images is for a new session; one that goes on keeps what it "
                           "holds"));
    if (!append && !arguments.has("study"))
        return reportUsageError("run", QStringLiteral("--study is missing"));
    if (!arguments.has("session"))
        return reportUsageError("run", QStringLiteral("--session is missing"));
    const QString path = arguments.rest().first();
    const core::FileInUse recipeFile({path}, core::FileInUse::As::Recipe);
    // Of a folder it is known later which of its files are the study's.
    const QString study = arguments.value("study");
    const core::FileInUse studyFile(
        QFileInfo(study).isFile() ? QStringList{study} : QStringList(), core::FileInUse::As::Study);
    const Result<core::Recipe> recipe = core::readRecipe(path);
    if (!recipe) {
        const core::ErrorCode code = recipe.error().code;
        const bool namesFile = code == core::ErrorCode::FileNotFound
            || code == core::ErrorCode::FileUnreadable || code == core::ErrorCode::InvalidRecipe;
        return reportFailure(recipe.error(), namesFile ? QString() : path);
    }
    const Result<void> target =
        checkSessionTarget(arguments.value("session"), arguments.has("force"), append);
    if (!target)
        return reportFailure(target.error());
    CommandTermination termination;
    return termination.status(run(*recipe, arguments, termination));
}

} // namespace

const Command runCommand{.name = "run",
    .words = "RECIPE.json",
    .usage = "RECIPE.json --study PATH [--series UID] [--repair REPAIRS]"
             " [--spacing COLUMNS,ROWS,SLICES] --session FILE.burin [--force | --append] "
             "[--with-images] [--apply-elsewhere] [--author NAME] [--facts] [--trace FILE.json]",
    .summary =
        "carries out a recipe without a window (burin edits lists what it can hold); --with-images "
        "puts the study's images, and with them who the patient is, into the session; --force "
        "replaces a session, which stays until the new one is whole; --repair, here and in info "
        "and open, says how the series is repaired on loading: tilt, spacing=even, gap=fill, "
        "gap=split:NUMBER, duplicates=first, duplicates=last, separated by commas, or none; "
        "--spacing says how many mm the voxels of PNG and TIFF pictures are apart",
    .options =
        std::vector<Option>{{"study", "PATH", "the study, as a file or folder"},
            {"session", "FILE.burin", "the session file in which every step is kept"},
            {"force", nullptr,
                "replaces a session, which stays until the new one is whole, and exported files"},
            {"append", nullptr, "goes on with a session that exists already"},
            {"with-images", nullptr,
                "puts the study's images, and with them who the patient is, into the session"},
            {"apply-elsewhere", nullptr,
                "allows a recipe that was made on another study, and skips what belongs to that "
                "study alone"},
            {"author", "NAME", "the name that stands in the audit trail"},
            {"facts", nullptr,
                "also prints, as lines of JSON, which study and graphics driver it is, and what "
                "kind a failure is"}}
        + seriesOptions() + spacingOption() + traceOption(),
    .run = [](const Arguments& arguments) { return traced(arguments, runRecipe); }};

} // namespace app
