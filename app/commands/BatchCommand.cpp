// SPDX-License-Identifier: Apache-2.0
#include "app/commands/BatchCommand.h"

#include "app/batch/RecipeTemplate.h"
#include "app/batch/ResultsTable.h"
#include "app/batch/StudyJob.h"
#include "app/end/CommandTermination.h"
#include "app/steps/Arguments.h"
#include "app/steps/JsonLine.h"
#include "core/base/files/FileInUse.h"
#include "core/base/files/StagedFile.h"
#include "ui/base/ErrorText.h"

#include <QCoreApplication>
#include <QDir>
#include <QEventLoop>
#include <QFile>
#include <QFileInfo>
#include <QHash>
#include <QThread>

#include <algorithm>
#include <cstdio>
#include <deque>
#include <optional>

namespace app {

namespace {

using core::ErrorCode;
using core::Result;

/// A whole number of at least @p least; none: it is not one.
std::optional<int> countOf(const Arguments& arguments, const char* option, int least, int usual)
{
    if (!arguments.has(option))
        return usual;
    bool isNumber = false;
    const int number = arguments.value(option).toInt(&isNumber);
    return isNumber && number >= least && number <= 1000 ? std::optional(number) : std::nullopt;
}

/// Says which files of a folder are taken for no studies; the first of many.
void reportLeftOut(const QStringList& names)
{
    constexpr qsizetype most = 20;
    if (names.isEmpty())
        return;
    QString list = names.first(std::min(names.size(), most)).join(QStringLiteral(", "));
    if (names.size() > most)
        list += QStringLiteral(" and %1 more").arg(names.size() - most);
    std::fprintf(stderr, "taken for no studies: %s\n", qUtf8Printable(list));
}

/// What is to be done for each study. Two studies must not export to one file.
Result<std::vector<StudyTask>> tasksOf(const Arguments& arguments, int retries)
{
    const QString recipeFile = QDir::cleanPath(QDir().absoluteFilePath(arguments.rest().first()));
    const Result<RecipeTemplate> recipe = RecipeTemplate::read(recipeFile);
    if (!recipe)
        return tl::unexpected(recipe.error());
    QStringList leftOut;
    Result<std::vector<BatchStudy>> studies =
        readStudyList(arguments.value("studies"), arguments.value("into"), &leftOut);
    reportLeftOut(leftOut);
    if (!studies)
        return tl::unexpected(studies.error());
    QStringList options;
    for (const char* option : {"with-images", "apply-elsewhere"}) {
        if (arguments.has(option))
            options += QStringLiteral("--") + QLatin1String(option);
    }
    if (arguments.has("author"))
        options += {QStringLiteral("--author"), arguments.value("author")};
    const QDir into(QDir().absoluteFilePath(arguments.value("into")));
    std::vector<StudyTask> tasks;
    QHash<QString, QString> writtenBy;
    for (BatchStudy& study : *studies) {
        const QString folder = QDir::cleanPath(into.filePath(study.name));
        const Result<QByteArray> filled = recipe->filled(study, folder);
        if (!filled)
            return tl::unexpected(filled.error());
        const QStringList files = RecipeTemplate::exportsOf(*filled, folder);
        for (const QString& file : files) {
            const auto other = writtenBy.constFind(file);
            if (other != writtenBy.constEnd())
                return core::failure(ErrorCode::InvalidRecipe, recipeFile,
                    QStringLiteral("%1 would be written for '%2' and for '%3'; a name without a "
                                   "folder goes to the study's own, and ${name} tells them apart")
                        .arg(file, *other, study.name));
            writtenBy.insert(file, study.name);
        }
        tasks.push_back({.study = std::move(study),
            .folder = folder,
            .recipe = *filled,
            .recipePath = recipeFile,
            .options = options,
            .retries = retries});
    }
    return tasks;
}

/// Does the studies that are not finished, some at a time.
class Batch {
public:
    Batch(std::vector<StudyTask> tasks, int jobs, bool force, const core::Progress& progress)
        : m_waiting(std::make_move_iterator(tasks.begin()), std::make_move_iterator(tasks.end()))
        , m_jobs(std::size_t(jobs))
        , m_force(force)
        , m_progress(progress)
    {
    }

    /// @return whether all were done, now or earlier
    bool run()
    {
        bool stopped = false;
        while (!m_running.empty() || (!m_waiting.empty() && !stopped)) {
            if (m_progress.cancelled() && !stopped) {
                stopped = true;
                for (const auto& job : m_running)
                    job->stop();
            }
            // Those that another process is at come round again.
            std::size_t looks = stopped ? 0 : m_waiting.size();
            while (m_running.size() < m_jobs && looks-- > 0) {
                StudyTask task = std::move(m_waiting.front());
                m_waiting.pop_front();
                beginOne(std::move(task));
            }
            QCoreApplication::processEvents(QEventLoop::AllEvents);
            std::erase_if(m_running, [this](const std::unique_ptr<StudyJob>& job) {
                if (!job->isOver())
                    return false;
                tell(job->task(), job->succeeded() ? "done" : "failed", job->failure());
                return true;
            });
            QThread::msleep(20);
        }
        return m_all && !stopped;
    }

private:
    void beginOne(StudyTask task)
    {
        StudyResults results;
        const Result<StudyResults::Turn> turn = results.begin(task.folder);
        if (!turn)
            return tell(task, "failed", ui::errorText(turn.error()));
        if (*turn == StudyResults::Turn::Another)
            return m_waiting.push_back(std::move(task));
        // Asked under the lock: who had it before may have finished it.
        if (StudyResults::isDone(task.folder)) {
            const QString other = whyOther(task, StudyResults::record(task.folder));
            if (other.isEmpty())
                return tell(task, "was done", {});
            if (!m_force)
                return tell(task, "other",
                    QStringLiteral("%1: %2; --force does it anew").arg(task.folder, other));
        }
        auto job = std::make_unique<StudyJob>(std::move(task), std::move(results));
        if (const Result<void> begun = job->begin(); !begun)
            return tell(job->task(), "failed", ui::errorText(begun.error()));
        m_running.push_back(std::move(job));
    }

    void tell(const StudyTask& task, const char* state, const QString& why)
    {
        QJsonObject line{{QStringLiteral("name"), task.study.name},
            {QStringLiteral("state"), QLatin1String(state)},
            {QStringLiteral("record"), QDir(task.folder).filePath(QStringLiteral("record.json"))}};
        if (!why.isEmpty()) {
            m_all = false;
            line[QStringLiteral("failure")] = why;
            std::fprintf(stderr, "%s: %s\n", qUtf8Printable(task.study.path), qUtf8Printable(why));
        }
        printJsonLine(line);
    }

    std::deque<StudyTask> m_waiting;
    std::vector<std::unique_ptr<StudyJob>> m_running;
    std::size_t m_jobs;
    bool m_force;
    const core::Progress& m_progress;
    bool m_all = true;
};

/// Checks that the table takes the place of nothing but an earlier one.
Result<void> checkTable(const Arguments& arguments)
{
    constexpr qsizetype enough = 100;
    QFile file(QDir(arguments.value("into")).filePath(QStringLiteral("results.csv")));
    const QFileInfo info(file.fileName());
    if (!info.exists() && !info.isSymLink())
        return {};
    if (const Result<void> target = core::checkFileTarget(file.fileName(), true); !target)
        return target;
    if (!file.open(QIODevice::ReadOnly) || !isResultsTable(file.read(enough)))
        return core::failure(ErrorCode::FileUnwritable, file.fileName(),
            QStringLiteral("it is no table of a batch; move it away, or name another folder"));
    return {};
}

int writeTable(const std::vector<StudyTask>& tasks, const Arguments& arguments)
{
    const QString into = arguments.value("into");
    if (!QDir().mkpath(into))
        return reportFailure(
            {ErrorCode::FileUnwritable, {into, QStringLiteral("the folder cannot be made")}});
    if (const Result<void> fits = checkTable(arguments); !fits)
        return reportFailure(fits.error());
    const Result<void> written = StudyResults::write(into, "results.csv", resultsTable(tasks));
    return written ? 0 : reportFailure(written.error());
}

int runBatch(const Arguments& arguments)
{
    if (arguments.rest().size() != 1)
        return reportUsageError("batch", QStringLiteral("it needs one recipe"));
    for (const char* needed : {"studies", "into"}) {
        if (!arguments.has(needed))
            return reportUsageError(
                "batch", QStringLiteral("--%1 is missing").arg(QLatin1String(needed)));
    }
    if (arguments.has("list") + arguments.has("table") + arguments.has("only") > 1)
        return reportUsageError(
            "batch", QStringLiteral("--only, --list and --table exclude each other"));
    const std::optional<int> jobs = countOf(arguments, "jobs", 1, 1);
    const std::optional<int> retries = countOf(arguments, "retries", 0, 0);
    if (!jobs)
        return reportUsageError("batch", QStringLiteral("--jobs must be a number from 1 to 1000"));
    if (!retries)
        return reportUsageError(
            "batch", QStringLiteral("--retries must be a number from 0 to 1000"));
    const core::FileInUse recipe(arguments.rest(), core::FileInUse::As::Recipe);
    const core::FileInUse list({arguments.value("studies")}, core::FileInUse::As::List);
    Result<std::vector<StudyTask>> tasks = tasksOf(arguments, *retries);
    if (!tasks)
        return reportFailure(tasks.error());
    if (arguments.has("list")) {
        for (const StudyTask& task : *tasks)
            printJsonLine({{QStringLiteral("name"), task.study.name},
                {QStringLiteral("study"), task.study.path},
                {QStringLiteral("folder"), task.folder}});
        return 0;
    }
    if (arguments.has("table"))
        return writeTable(*tasks, arguments);
    std::vector<StudyTask> chosen = *tasks;
    if (arguments.has("only")) {
        std::erase_if(chosen, [only = arguments.value("only")](const StudyTask& task) {
            return task.study.name != only;
        });
        if (chosen.empty())
            return reportFailure({ErrorCode::FileUnreadable,
                {arguments.value("studies"),
                    QStringLiteral("it has no study named '%1'").arg(arguments.value("only"))}});
    } else if (const Result<void> fits = checkTable(arguments); !fits) {
        return reportFailure(fits.error());
    }
    CommandTermination termination;
    // Nothing needs closing here: children close what is theirs, and are waited for.
    termination.setClosing({});
    const bool all =
        Batch(std::move(chosen), *jobs, arguments.has("force"), termination.progress()).run();
    const int table = arguments.has("only") ? 0 : writeTable(*tasks, arguments);
    return termination.status(all && table == 0 ? 0 : 1);
}

} // namespace

const Command batchCommand{.name = "batch",
    .words = "RECIPE.json",
    .usage = "RECIPE.json --studies LIST|FOLDER --into FOLDER [--jobs N] [--retries N]"
             " [--only NAME | --list | --table] [--force] [--with-images] [--apply-elsewhere]"
             " [--author NAME]",
    .summary =
        "carries out a recipe on many studies (a .csv, .tsv or .json list, or a folder), each"
        " in a process of its own; what is finished is not done again, so that a batch goes"
        " on where it was ended; FOLDER gets a folder for each study, with session, exports"
        " and record.json, and results.csv",
    .options = {{"studies", "LIST", "the studies: a list or a folder"},
        {"into", "FOLDER", "where the results go"},
        {"jobs", "N", "how many studies are worked on at once; 1 by default"},
        {"retries", "N",
            "how often a study is tried again after a failure that may pass, such as a crash, too "
            "little memory, a full disk or a session that could not be closed; 0 by default"},
        {"only", "NAME", "carries out this study of the list alone, and writes no table"},
        {"list", nullptr, "lists the studies, and does nothing"},
        {"table", nullptr, "writes results.csv from what is finished, and does nothing else"},
        {"force", nullptr,
            "carries out again what was finished with another study, recipe, series, repair, "
            "spacing, session file or option"},
        {"with-images", nullptr,
            "puts the study's images, and with them who the patient is, into each session"},
        {"apply-elsewhere", nullptr,
            "allows a recipe that was made on another study, and skips what belongs to that study "
            "alone"},
        {"author", "NAME", "the name that stands in the audit trail"}},
    .run = runBatch};

} // namespace app
