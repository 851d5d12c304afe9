// SPDX-License-Identifier: Apache-2.0
#include "app/commands/ReplayCommand.h"

#include "app/end/CommandTermination.h"
#include "app/steps/Arguments.h"
#include "app/steps/ExportFiles.h"
#include "app/steps/JsonLine.h"
#include "app/steps/SessionProblems.h"
#include "app/steps/SteadySession.h"
#include "app/steps/TracedRun.h"
#include "core/base/files/FileInUse.h"
#include "core/sessionfile/HistoryListing.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/SessionStudy.h"
#include "gpu/engine/GpuEngine.h"
#include "ui/texts/SessionTexts.h"

#include <QJsonObject>

#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace app {

namespace {

using core::Result;

/// A session file as far as it is sound.
struct Recorded {
    QString path;
    core::SessionContents contents;

    /// Why what a row changed cannot be read; empty: it can.
    [[nodiscard]] QString lostDifference(core::RowId row) const
    {
        for (const core::SessionDamage& lost : contents.redo) {
            if (lost.row == row)
                return lost.reason;
        }
        return {};
    }
};

tl::unexpected<core::Error> disagrees(
    const Recorded& recorded, const core::HistoryRow& row, const QString& how)
{
    return core::failure(core::ErrorCode::SessionDamaged, recorded.path,
        QStringLiteral("row %1 ('%2') does not agree: %3").arg(row.id).arg(row.name, how));
}

/// Carries out one row in @p session and compares.
/// @param numbers rows of the file and what they are in the session
Result<void> replay(const core::HistoryRow& row, const std::map<core::RowId, core::RowId>& numbers,
    const Recorded& recorded, core::EditSession& session)
{
    if (const Result<void> moved = session.goTo(numbers.at(row.parent)); !moved)
        return moved;
    if (const Result<void> settled = session.settle(); !settled)
        return settled;
    const std::size_t before = session.history().rows().size();
    if (const Result<void> applied = session.apply(core::renumbered(row.edit, numbers)); !applied)
        return disagrees(recorded, row, QStringLiteral("it is refused now"));
    if (const Result<void> settled = session.settle(); !settled)
        return settled;
    const std::vector<core::HistoryRow>& rows = session.history().rows();
    if (rows.size() == before)
        return disagrees(recorded, row, QStringLiteral("it changes nothing now"));
    const QByteArray hash = rows.back().stateHash;
    const bool finished = !row.stateHash.isEmpty();
    if (finished && hash != row.stateHash)
        return disagrees(recorded, row,
            QStringLiteral("recorded %1, replayed %2")
                .arg(QString::fromLatin1(row.stateHash), QString::fromLatin1(hash)));
    return {};
}

/// One line for a row that was carried out and agrees.
void printAgreement(
    const core::HistoryRow& row, const Recorded& recorded, const core::EditSession& session)
{
    const QByteArray hash = session.history().rows().back().stateHash;
    const bool finished = !row.stateHash.isEmpty();
    const QString lost = recorded.lostDifference(row.id);
    QJsonObject line{
        {QStringLiteral("row"), qint64(row.id)},
        {QStringLiteral("name"), row.name},
        {QStringLiteral("hash"), QString::fromLatin1(hash)},
        {QStringLiteral("agrees"), finished ? QJsonValue(lost.isEmpty()) : QJsonValue()},
    };
    if (!lost.isEmpty())
        line[QStringLiteral("problem")] = lost;
    printJsonLine(line);
}

struct Task {
    std::optional<core::RowId> to; ///< where the user wants it to stop; none: nothing was said
    core::RowId exportAt = 0; ///< the row whose state is exported
    std::vector<core::RecipeExport> exports;
    bool force = false;
    bool verify = false;
};

/// The rows to carry out: all, branches included, or those that lead to the one that is asked for.
/// Their parents come first, as ids ascend.
std::vector<core::RowId> rowsOf(const core::SessionContents& contents, const Task& task)
{
    if (task.to || !task.verify)
        return core::History::restored(contents.rows, contents.visited, contents.position)
            .pathTo(task.to.value_or(task.exportAt));
    std::vector<core::RowId> all;
    for (const core::HistoryRow& row : contents.rows)
        all.push_back(row.id);
    return all;
}

int replayRows(const Recorded& recorded, core::LoadedVolume volume, const Task& task,
    const ReadStudy& readStudy, const core::Progress& progress)
{
    for (const core::RecipeExport& target : task.exports) {
        if (const Result<void> fits = core::checkExportTarget(target, volume.volume, task.force);
            !fits)
            return reportFailure(fits.error());
    }
    SteadySession steady;
    if (const Result<void> started = steady.start(); !started)
        return reportFailure(started.error());
    const auto rowOf = [&recorded](core::RowId id) -> const core::HistoryRow& {
        return recorded.contents.rows[std::size_t(id - 1)];
    };
    // On a path rows are numbered anew; here is what became of each.
    std::map<core::RowId, core::RowId> replayed{{0, 0}};
    bool allReplayed = false;
    const auto goToExported = [&](core::EditSession& session) -> Result<void> {
        if (const Result<void> moved = session.goTo(replayed.at(task.exportAt)); !moved)
            return moved;
        return session.settle();
    };
    std::optional<core::LoadedVolume> study = std::move(volume);
    // It is kept in no file: what was done of it is done again.
    const auto begin = [&](gpu::GpuEngine& engine) -> Result<SteadySession::Session> {
        if (!study) {
            Result<core::LoadedVolume> read = readStudy();
            if (!read)
                return tl::unexpected(read.error());
            study = *std::move(read);
        }
        auto begun =
            core::EditSession::create(engine.edits(), *std::exchange(study, std::nullopt), {});
        for (const auto& [id, number] : replayed) {
            if (!begun || id == 0)
                continue;
            if (const Result<void> done = replay(rowOf(id), replayed, recorded, **begun); !done)
                return tl::unexpected(done.error());
        }
        if (begun && allReplayed) {
            if (const Result<void> moved = goToExported(**begun); !moved)
                return tl::unexpected(moved.error());
        }
        return begun;
    };
    if (const Result<void> begun = steady.open(begin, begin); !begun)
        return reportFailure(begun.error());
    const std::vector<core::RowId> rows = rowsOf(recorded.contents, task);
    int unfinished = 0;
    int damaged = 0;
    for (const core::RowId id : rows) {
        if (progress.cancelled())
            return reportFailure({core::ErrorCode::Cancelled, {}});
        const core::HistoryRow& row = rowOf(id);
        const Result<void> done =
            steady.carryOut([&] { return replay(row, replayed, recorded, steady.session()); });
        if (!done)
            return reportFailure(done.error());
        printAgreement(row, recorded, steady.session());
        replayed[id] = steady.session().history().position();
        unfinished += row.stateHash.isEmpty() ? 1 : 0;
        damaged += recorded.lostDifference(id).isEmpty() ? 0 : 1;
    }
    const auto count = int(rows.size());
    std::fprintf(stderr, "%s: %d of %d rows agree", qUtf8Printable(recorded.path),
        count - unfinished - damaged, count);
    if (unfinished > 0)
        std::fprintf(stderr, "; %d were not finished when the session was left", unfinished);
    std::fprintf(stderr, "\n");
    if (!task.exports.empty()) {
        allReplayed = true;
        const Result<void> moved = steady.carryOut([&] { return goToExported(steady.session()); });
        if (!moved)
            return reportFailure(moved.error());
    }
    if (const Result<void> exported =
            exportFiles(task.exports, steady, task.force, readStudy, progress);
        !exported)
        return reportFailure(exported.error());
    const bool lost = !task.to && recorded.contents.damage;
    return task.verify && (lost || damaged > 0) ? 1 : 0;
}

/// Why the rows that are asked for cannot be carried out: they are lost with others.
Result<void> checkSound(const Arguments& arguments, const Recorded& recorded)
{
    const std::optional<core::SessionDamage>& damage = recorded.contents.damage;
    const qlonglong to = arguments.value("to").toLongLong();
    if (damage && damage->row > 0 && arguments.has("to") && to >= damage->row
        && (damage->after < 0 || to <= damage->row + damage->after))
        return tl::unexpected(damage->error(recorded.path));
    // Another state than the one that is asked for is not to go under its name.
    if (recorded.contents.positionLost && arguments.has("export") && !arguments.has("to"))
        return core::failure(core::ErrorCode::SessionDamaged, recorded.path,
            QStringLiteral("%1; --to says which of the rows 0 to %2 is exported")
                .arg(ui::damageText(*damage))
                .arg(recorded.contents.rows.size()));
    return {};
}

/// ".dcm, .nii.gz, … or .seg.nrrd"
QString knownEndings()
{
    QStringList endings;
    for (const core::ExportFormatFacts& facts : core::exportFormats()) {
        for (const char* ending : {facts.ending, facts.otherEnding}) {
            if (*ending != '\0' && !endings.contains(QLatin1String(ending)))
                endings += QLatin1String(ending);
        }
    }
    const QString last = endings.takeLast();
    return endings.join(QStringLiteral(", ")) + QStringLiteral(" or ") + last;
}

/// The words of an export are those of one in a recipe.
/// @return what is wrong with them; empty if nothing
QString readExport(const Arguments& arguments, Task& task)
{
    const QString file = arguments.value("export");
    QString format = arguments.value("format");
    if (format.isEmpty()) {
        const std::optional<core::ExportFormat> known = core::exportFormatOfFile(file);
        if (!known)
            return QStringLiteral("--export: the name ends in %1").arg(knownEndings());
        format = QLatin1String(core::factsOf(*known).name);
    }
    QJsonObject words{{QStringLiteral("format"), format}, {QStringLiteral("file"), file}};
    if (arguments.has("space"))
        words[QStringLiteral("space")] = arguments.value("space").toUpper();
    for (const char* wish : {"deidentify", "deflated"}) {
        if (arguments.has(wish))
            words[QLatin1String(wish)] = true;
    }
    for (const char* number : {"layer", "fill"}) {
        if (!arguments.has(number))
            continue;
        bool isNumber = false;
        const double value = arguments.value(number).toDouble(&isNumber);
        // "nan" and "inf" are read as numbers, too, and no recipe can hold them.
        if (!isNumber || !std::isfinite(value))
            return QStringLiteral("--%1: must be a number").arg(QLatin1String(number));
        words[QLatin1String(number)] = value;
    }
    const Result<core::RecipeExport> target = core::exportFromJson(words);
    if (target) {
        task.exports.push_back(*target);
        return {};
    }
    QString option = target.error().arguments.value(0);
    option.replace(QStringLiteral("export."), QStringLiteral("--"));
    const QString reason = target.error().arguments.value(1);
    return reason == QLatin1String("unknown field")
        ? QStringLiteral("%1 means nothing to --format %2").arg(option, format)
        : QStringLiteral("%1: %2").arg(option, reason);
}

/// @return what is wrong with the words; empty if nothing
QString readTask(const Arguments& arguments, const core::SessionContents& contents, Task& task)
{
    task.force = arguments.has("force");
    task.verify = arguments.has("verify");
    if (arguments.has("to")) {
        bool isNumber = false;
        const qlonglong row = arguments.value("to").toLongLong(&isNumber);
        if (!isNumber || row < 0 || row > qlonglong(contents.rows.size()))
            return QStringLiteral("--to: the history has rows 0 to %1").arg(contents.rows.size());
        task.to = row;
    }
    if (!arguments.has("export"))
        return {};
    task.exportAt = task.to.value_or(contents.position);
    return readExport(arguments, task);
}

int runReplay(const Arguments& arguments)
{
    if (arguments.rest().size() != 1)
        return reportUsageError("replay", QStringLiteral("it needs one session file"));
    if (!arguments.has("verify") && !arguments.has("export"))
        return reportUsageError("replay", QStringLiteral("--verify or --export is missing"));
    for (const char* detail : {"format", "layer", "fill", "space", "deidentify", "deflated"}) {
        if (arguments.has(detail) && !arguments.has("export"))
            return reportUsageError(
                "replay", QStringLiteral("--%1 is for --export").arg(QLatin1String(detail)));
    }

    const QString path = arguments.rest().first();
    // No export replaces what it is made of, with --force either.
    const core::FileInUse own({path}, core::FileInUse::As::Session);
    Result<core::SessionContents> contents = core::checkSession(path);
    if (!contents)
        return reportFailure(contents.error());
    const Recorded recorded{.path = path, .contents = *std::move(contents)};
    if (const Result<void> sound = checkSound(arguments, recorded); !sound)
        return reportFailure(sound.error());
    Task task;
    if (const QString problem = readTask(arguments, recorded.contents, task); !problem.isEmpty())
        return reportUsageError("replay", problem);
    reportProblems(path, recorded.contents);
    CommandTermination termination;
    Result<core::LoadedVolume> volume = core::loadSessionStudy(path, recorded.contents.source,
        arguments.value("study"), arguments.value("series"), termination.progress());
    if (!volume)
        return termination.status(reportFailure(volume.error()));
    reportNotFromStudy(volume->notFromStudy, path);
    const auto readStudy = [&] {
        return core::loadSessionStudy(
            path, recorded.contents.source, arguments.value("study"), arguments.value("series"));
    };
    return termination.status(
        replayRows(recorded, *std::move(volume), task, readStudy, termination.progress()));
}

} // namespace

const Command replayCommand{.name = "replay",
    .words = "FILE.burin",
    .usage = "FILE.burin [--verify] [--to ROW] [--export FILE [--format FORMAT] [--layer NUMBER]"
             " [--fill VALUE] [--space lps|ras] [--deidentify] [--deflated] [--force]]"
             " [--study PATH] [--series UID] [--trace FILE.json]",
    .summary = "carries out a session's history again, from nothing, and compares every hash: all "
               "of it with --verify, and what leads to the exported state with --export, one of "
               "which is needed; --export writes the masks of that state; with --format coverage "
               "--layer NUMBER it writes what a sculpt layer carves (.nii.gz), with --format "
               "carved-volume the study without what is carved (.nii.gz, or a new folder for a "
               "DICOM series), where --fill gives the value that stands there, by default the "
               "least; --deidentify leaves out who the patient is, --deflated makes a DICOM SEG "
               "smaller",
    .options =
        std::vector<Option>{{"verify", nullptr,
                                "carries out every step, also of other branches unless --to "
                                "names one, and compares every hash"},
            {"to", "ROW", "carries out only what leads to this row, and stops there"},
            {"export", "FILE",
                "writes the masks of that state; without --to, of where the session stands"},
            {"format", "FORMAT",
                "the format of that file, if its ending does not say; coverage is what a layer "
                "carves, carved-volume the study without what is carved"},
            {"layer", "NUMBER", "the sculpt layer whose coverage is written"},
            {"fill", "VALUE",
                "the value that stands where something is carved; the least value by default"},
            {"space", "lps|ras", "in which axes surfaces are written"},
            {"deidentify", nullptr, "leaves out who the patient is"},
            {"deflated", nullptr, "makes a DICOM SEG smaller"},
            {"force", nullptr, "replaces a file that exists already"},
            {"study", "PATH", "where the study is, if not where the session says"},
            {"series", "UID", "which series or volume of the study"}}
        + traceOption(),
    .run = [](const Arguments& arguments) { return traced(arguments, runReplay); }};

} // namespace app
