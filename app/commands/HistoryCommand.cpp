// SPDX-License-Identifier: Apache-2.0
#include "app/commands/HistoryCommand.h"

#include "app/end/CommandTermination.h"
#include "app/steps/Arguments.h"
#include "app/steps/JsonLine.h"
#include "app/steps/SessionProblems.h"
#include "app/steps/SteadySession.h"
#include "core/base/files/FileInUse.h"
#include "core/base/files/StagedFile.h"
#include "core/export/common/ExportMask.h"
#include "core/export/common/ImportedSegments.h"
#include "core/session/EditSession.h"
#include "core/session/past/PastImports.h"
#include "core/session/questions/VoxelQuestions.h"
#include "core/sessionfile/DeidentifySession.h"
#include "core/sessionfile/HistoryListing.h"
#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/SessionStudy.h"
#include "gpu/engine/GpuEngine.h"
#include "ui/report/AuditSegments.h"
#include "ui/report/WriteAudit.h"
#include "ui/texts/SessionTexts.h"

#include <QJsonDocument>

#include <cstdio>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace app {

namespace {

void printRow(const core::HistoryRow& row, bool isPosition)
{
    std::printf("%c %5lld  %10lld  %s\n", isPosition ? '>' : ' ', static_cast<long long>(row.id),
        static_cast<long long>(row.statistics.voxelsChanged), qUtf8Printable(row.name));
}

void printTable(const core::SessionContents& contents)
{
    const core::History history =
        core::History::restored(contents.rows, contents.visited, contents.position);
    std::printf("    row      voxels  what\n");
    for (const core::HistoryBranch& branch : core::branchesOf(history)) {
        if (!branch.current)
            std::printf("\n  branch behind row %lld\n", static_cast<long long>(branch.forksAt));
        for (const core::RowId id : branch.rows)
            printRow(history.row(id), id == contents.position);
    }
}

/// Measures the segments where the session stands, as the window does for its report. The labels
/// come of the steps, which an engine carries out or reads; nothing is written.
core::Result<ui::AuditSegments> measuredSegments(
    const QString& path, const Arguments& arguments, const core::Progress& progress)
{
    const core::Result<core::SessionContents> contents = core::checkSession(path);
    if (!contents)
        return tl::unexpected(contents.error());
    if (!contents->isWhole())
        return core::failure(
            core::ErrorCode::SessionDamaged, path, ui::problemTexts(*contents).front());
    const core::Result<core::LoadedVolume> study = core::loadSessionStudy(
        path, contents->source, arguments.value("study"), arguments.value("series"), progress);
    if (!study)
        return tl::unexpected(study.error());
    reportNotFromStudy(study->notFromStudy, path);
    SteadySession steady;
    if (const core::Result<void> started = steady.start(); !started)
        return tl::unexpected(started.error());
    const auto look = [&](gpu::GpuEngine& engine) -> core::Result<SteadySession::Session> {
        engine.setVolumeGeometry(study->volume.geometry, study->volume.encoding);
        return core::EditSession::view(engine.edits(), core::LoadedVolume(*study), path,
            QStringLiteral("it is only looked at"));
    };
    if (const core::Result<void> opened = steady.open(look, look); !opened)
        return tl::unexpected(opened.error());
    std::map<std::uint8_t, std::vector<std::uint8_t>> labels;
    const core::Result<void> read = steady.carryOut([&]() -> core::Result<void> {
        core::EditSession& session = steady.session();
        for (const std::uint8_t plane : session.document().labelPlanes()) {
            auto bytes = session.questions().labels(plane);
            if (!bytes)
                return tl::unexpected(bytes.error());
            labels[plane] = *std::move(bytes);
        }
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    const core::EditSession& session = steady.session();
    core::ExportRequest request;
    request.segments = session.document().segments;
    for (const auto& [plane, bytes] : labels)
        request.planes.push_back({.plane = plane, .labels = bytes});
    request.codes = study->codes;
    request.imported = core::importedAs(request.segments, core::doneImports(session.history()),
        study->volume.geometry.voxelCount());
    core::Result<ui::AuditSegments> measured = ui::auditSegments(study->volume, request, progress);
    if (measured)
        measured->position = session.history().position();
    return measured;
}

/// @param segments null: the report says nothing of them
int writeReport(
    const QString& path, const QString& target, bool force, const ui::AuditSegments* segments)
{
    const core::FileInUse own({path}, core::FileInUse::As::Session);
    // A report also tells of a damaged session what is left of it.
    const auto opened = core::SessionFile::open(path, core::SessionFile::Access::SoundPart);
    if (!opened)
        return reportFailure(opened.error());
    core::SessionFile& file = **opened;
    core::Result<core::AuditReport> report;
    file.audit([&report](const core::Result<core::AuditReport>& made) { report = made; });
    if (const core::Result<void> waited = file.flush(); !waited)
        return reportFailure(waited.error());
    if (!report)
        return reportFailure(report.error());
    if (const core::Result<void> written = ui::writeAudit(*report, target, force, segments);
        !written)
        return reportFailure(written.error());
    // A report of damage is a report, but nobody should take it for a clean one.
    for (const core::Error& error : report->damage)
        reportFailure(error);
    return report->damage.empty() ? 0 : 1;
}

int writeReportWithVolumes(const QString& path, const QString& target, const Arguments& arguments)
{
    const bool force = arguments.has("force");
    if (const core::Result<void> fits = core::checkFileTarget(target, force); !fits)
        return reportFailure(fits.error());
    CommandTermination termination;
    const core::Result<ui::AuditSegments> segments =
        measuredSegments(path, arguments, termination.progress());
    if (!segments)
        return termination.status(reportFailure(segments.error()));
    return termination.status(writeReport(path, target, force, &*segments));
}

/// @param dates "remove", "keep" or days to shift by; empty: removed
std::optional<core::DeidentifyOptions> datesFrom(const QString& dates)
{
    core::DeidentifyOptions options;
    bool isNumber = false;
    options.shiftDays = dates.toInt(&isNumber);
    if (isNumber && options.shiftDays != 0)
        options.dates = core::DeidentifyOptions::Dates::Shift;
    else if (dates == QLatin1String("keep"))
        options.dates = core::DeidentifyOptions::Dates::Keep;
    else if (!dates.isEmpty() && dates != QLatin1String("remove"))
        return std::nullopt;
    return options;
}

int writeDeidentified(
    const QString& path, const QString& target, bool force, const core::DeidentifyOptions& options)
{
    // A copy for others in its place would leave nothing of who did what.
    const core::FileInUse own({path}, core::FileInUse::As::Session);
    if (const core::Result<void> fits = core::checkFileTarget(target, force); !fits)
        return reportFailure(fits.error());
    const core::Result<core::SessionContents> contents = core::checkSession(path);
    if (!contents)
        return reportFailure(contents.error());
    core::StudyIdentity patient;
    const core::Result<core::LoadedVolume> study = core::loadSessionStudy(path, contents->source);
    if (study)
        patient = study->volume.identity;
    else
        std::fprintf(stderr,
            "%s: the study is not at hand, so names given by users were not compared with the "
            "patient's\n",
            qUtf8Printable(path));
    const auto done =
        core::deidentifySession(path, target, force, core::Deidentifier(options, patient));
    if (!done)
        return reportFailure(done.error());
    printJsonLine({{QStringLiteral("export"), target},
        {QStringLiteral("written"), ui::deidentifiedTexts(*done).join(QLatin1Char(' '))}});
    return 0;
}

int runHistory(const Arguments& arguments)
{
    if (arguments.rest().size() != 1)
        return reportUsageError("history", QStringLiteral("it needs one session file"));
    const bool asJson = arguments.has("json");
    const bool asRecipe = arguments.has("as-recipe");
    const QString target = arguments.value("report");
    const bool deidentified = arguments.has("deidentified");
    if (int(asJson) + int(asRecipe) + int(!target.isEmpty()) + int(deidentified) > 1)
        return reportUsageError("history",
            QStringLiteral("--json, --as-recipe, --report and --deidentified exclude each other"));
    if (!target.isEmpty() && !ui::auditNameProblem(target).isEmpty())
        return reportUsageError(
            "history", QStringLiteral("--report: ") + ui::auditNameProblem(target));

    if (arguments.has("volumes") && target.isEmpty())
        return reportUsageError("history", QStringLiteral("--volumes is for --report"));
    for (const char* where : {"study", "series"}) {
        if (arguments.has(where) && !arguments.has("volumes"))
            return reportUsageError(
                "history", QStringLiteral("--%1 is for --volumes").arg(QLatin1String(where)));
    }

    const QString path = arguments.rest().first();
    if (deidentified) {
        const auto options = datesFrom(arguments.value("dates"));
        if (!options)
            return reportUsageError("history",
                QStringLiteral("--dates is remove, keep or a number of days to shift them by"));
        return writeDeidentified(
            path, arguments.value("deidentified"), arguments.has("force"), *options);
    }
    if (arguments.has("dates"))
        return reportUsageError("history", QStringLiteral("--dates is for --deidentified"));
    if (!target.isEmpty())
        return arguments.has("volumes")
            ? writeReportWithVolumes(path, target, arguments)
            : writeReport(path, target, arguments.has("force"), nullptr);
    const core::Result<core::SessionContents> checked = core::checkSession(path);
    if (!checked)
        return reportFailure(checked.error());
    const core::SessionContents& contents = *checked;
    reportProblems(path, contents);
    const int status = contents.damage ? 1 : 0;
    if (!asJson && !asRecipe) {
        printTable(contents);
        return status;
    }
    const QJsonObject object = asJson ? core::historyListing(contents, ui::problemTexts(contents))
                                      : core::historyAsRecipe(contents);
    std::fputs(QJsonDocument(object).toJson().constData(), stdout);
    return status;
}

} // namespace

const Command historyCommand{.name = "history",
    .words = "FILE.burin",
    .usage = "FILE.burin [--json | --as-recipe | --report OUT.html|OUT.pdf [--volumes"
             " [--study PATH] [--series UID]] [--force]"
             " | --deidentified OUT.burin [--dates remove|keep|DAYS] [--force]]",
    .summary = "tells what was done in a session, branches included, or writes it as a recipe for "
               "burin run, as an audit report, or as a copy of the session without who the patient "
               "is, for others",
    .options = {{"json", nullptr, "prints it as JSON"},
        {"as-recipe", nullptr, "prints it as a recipe for burin run"},
        {"report", "OUT.html|OUT.pdf", "writes an audit report"},
        {"volumes", nullptr,
            "also measures the segments for that report, which needs the study, or its images in "
            "the session, and the graphics driver"},
        {"study", "PATH", "where the study is, if not where the session says"},
        {"series", "UID", "which series or volume of the study"},
        {"deidentified", "OUT.burin", "writes a copy without who the patient is, for others"},
        {"dates", "remove|keep|DAYS",
            "what happens to dates in that copy; DAYS moves them by this number of days"},
        {"force", nullptr,
            "replaces a file that exists already; a copy for others replaces nothing but a closed "
            "session"}},
    .run = runHistory,
    .fontsFor = "--report"};

} // namespace app
