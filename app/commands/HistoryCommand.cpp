// SPDX-License-Identifier: Apache-2.0
#include "app/commands/HistoryCommand.h"

#include "app/steps/Arguments.h"
#include "app/steps/JsonLine.h"
#include "app/steps/SessionProblems.h"
#include "core/sessionfile/DeidentifySession.h"
#include "core/sessionfile/HistoryListing.h"
#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/SessionStudy.h"
#include "ui/report/WriteAudit.h"
#include "ui/texts/SessionTexts.h"

#include <QJsonDocument>

#include <cstdio>
#include <optional>

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

int writeReport(const QString& path, const QString& target, bool force)
{
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
    if (const core::Result<void> written = ui::writeAudit(*report, target, force); !written)
        return reportFailure(written.error());
    // A report of damage is a report, but nobody should take it for a clean one.
    for (const core::Error& error : report->damage)
        reportFailure(error);
    return report->damage.empty() ? 0 : 1;
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
        return writeReport(path, target, arguments.has("force"));
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
    .usage = "FILE.burin [--json | --as-recipe | --report OUT.html|OUT.pdf [--force]"
             " | --deidentified OUT.burin [--dates remove|keep|DAYS] [--force]]",
    .summary = "tells what was done in a session, branches included, or writes it as a recipe for "
               "burin run, as an audit report, or as a copy of the session without who the patient "
               "is, for others",
    .options = {{"json", nullptr, "prints it as JSON"},
        {"as-recipe", nullptr, "prints it as a recipe for burin run"},
        {"report", "OUT.html|OUT.pdf", "writes an audit report"},
        {"deidentified", "OUT.burin", "writes a copy without who the patient is, for others"},
        {"dates", "remove|keep|DAYS",
            "what happens to dates in that copy; DAYS moves them by this number of days"},
        {"force", nullptr, "replaces a file that exists already"}},
    .run = runHistory,
    .fontsFor = "--report"};

} // namespace app
