// SPDX-License-Identifier: Apache-2.0
#include "app/batch/StudyJob.h"

#include "app/Version.h"
#include "app/steps/Arguments.h"
#include "ui/base/ErrorText.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <csignal>
#include <utility>

#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>

namespace app {

namespace {

using core::Result;

/// In a record: what lies there was done by an earlier job, and this one has not replaced it.
const auto keepsDoneField = QStringLiteral("keepsResults");

QString now()
{
    return QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs);
}

QString sha256Of(const QByteArray& recipe)
{
    return QString::fromLatin1(
        QCryptographicHash::hash(recipe, QCryptographicHash::Sha256).toHex());
}

/// Those of which the results depend.
QStringList decisive(QStringList options)
{
    if (const qsizetype author = options.indexOf(QLatin1String("--author")); author >= 0)
        options.remove(author, std::min<qsizetype>(2, options.size() - author));
    return options;
}

/// What was asked for, for a sentence about it.
QString shown(const QString& words)
{
    return words.isEmpty() ? QStringLiteral("none") : words;
}

} // namespace

QString whyOther(const StudyTask& task, const QJsonObject& record)
{
    const QString study = record.value(QStringLiteral("study")).toString();
    if (study != task.study.path)
        return QStringLiteral("it holds results of another study, %1").arg(study);
    if (record.value(QStringLiteral("recipeSha256")).toString() != sha256Of(task.recipe))
        return QStringLiteral("it holds results of another recipe");
    const struct {
        const char* key;
        const QString& asked;
        const char* what;
    } fields[] = {{"series", task.study.series, "another series"},
        {"repair", task.study.repair, "another repair"},
        {"spacing", task.study.spacing, "another spacing"},
        {"session", task.study.session, "another session file"}};
    for (const auto& field : fields) {
        const QJsonValue made = record.value(QLatin1String(field.key));
        if (made.isString() && made.toString() != field.asked)
            return QStringLiteral("it holds results of %1 (%2)")
                .arg(QLatin1String(field.what), shown(made.toString()));
    }
    const QJsonValue options = record.value(QStringLiteral("options"));
    QStringList made;
    for (const QJsonArray list = options.toArray(); const QJsonValue& each : list)
        made += each.toString();
    made = decisive(made);
    if (options.isArray() && made != decisive(task.options))
        return QStringLiteral("it holds results of other options (%1)")
            .arg(shown(made.join(QLatin1Char(' '))));
    return {};
}

StudyJob::StudyJob(StudyTask task, StudyResults results)
    : m_task(std::move(task))
    , m_results(std::move(results))
    , m_attempt(
          m_task.folder, m_task.study.session, m_task.recipe, StudyResults::record(m_task.folder))
{
}

Result<void> StudyJob::begin()
{
    const QJsonObject earlier = StudyResults::record(m_task.folder);
    const bool wasDone = earlier.value(QStringLiteral("state")).toString() == QLatin1String("done");
    m_keepsDone = wasDone || earlier.value(keepsDoneField).toBool();
    const int starts = earlier.value(QStringLiteral("starts")).toInt();
    // A record of an earlier version does not tell how many attempts one start made.
    m_attemptsBefore = wasDone ? 0 : earlier.value(QStringLiteral("attemptsInAll")).toInt(starts);
    m_record = {
        {QStringLiteral("name"), m_task.study.name},
        {QStringLiteral("study"), m_task.study.path},
        {QStringLiteral("series"), m_task.study.series},
        {QStringLiteral("repair"), m_task.study.repair},
        {QStringLiteral("spacing"), m_task.study.spacing},
        {QStringLiteral("variables"), m_task.study.variables},
        {QStringLiteral("state"), QStringLiteral("begun")},
        {QStringLiteral("program"), QStringLiteral("burin " BURIN_VERSION)},
        {QStringLiteral("recipe"), m_task.recipePath},
        {QStringLiteral("recipeSha256"), sha256Of(m_task.recipe)},
        {QStringLiteral("options"), QJsonArray::fromStringList(m_task.options)},
        {QStringLiteral("session"), m_task.study.session},
        {QStringLiteral("begun"), now()},
        // How often it was begun in all, also by processes that were killed.
        {QStringLiteral("starts"), starts + 1},
        {QStringLiteral("attemptsInAll"), m_attemptsBefore},
    };
    if (m_keepsDone)
        m_record[keepsDoneField] = true;
    if (const Result<void> removed = m_attempt.removeLeft(); !removed)
        return removed;
    m_attempt.noteIn(m_record);
    if (const Result<void> fits = m_attempt.check(); !fits) {
        // The record of what is finished stays with it.
        if (!wasDone) {
            m_record.remove(QStringLiteral("attempt"));
            m_record[QStringLiteral("state")] = QStringLiteral("failed");
            m_record[QStringLiteral("failure")] = ui::errorText(fits.error());
            static_cast<void>(writeRecord());
        }
        return fits;
    }
    // An attempt counts even if this process is killed during it.
    m_record[QStringLiteral("attemptsInAll")] = m_attemptsBefore + 1;
    if (const Result<void> written = writeRecord(); !written)
        return written;
    if (const Result<void> written =
            StudyResults::write(m_task.folder, "recipe.json", m_task.recipe);
        !written)
        return written;
    m_clock.start();
    start();
    return {};
}

void StudyJob::start()
{
    ++m_attempts;
    m_record[QStringLiteral("attemptsInAll")] = m_attemptsBefore + m_attempts;
    m_mayBeTransient = false;
    m_failure.clear();
    for (const char* each :
        {"failure", "source", "renderer", "driver", "stateHash", "messages", "signal", "exitCode"})
        m_record.remove(QLatin1String(each));
    if (const Result<void> begun = m_attempt.begin(); !begun) {
        m_failure = ui::errorText(begun.error());
        m_mayBeTransient = mayPass(begun.error());
        return;
    }
    m_process = std::make_unique<QProcess>();
    m_process->setWorkingDirectory(m_task.folder);
    const int lock = m_results.lock();
    const pid_t parent = ::getpid();
    // Between fork and exec: the child inherits the lock of its own study only, and ends with us.
    m_process->setChildProcessModifier([lock, parent] {
        ::prctl(PR_SET_PDEATHSIG, SIGTERM);
        if (::getppid() != parent)
            ::_exit(1);
        ::fcntl(lock, F_SETFD, 0);
    });
    QStringList words{QStringLiteral("run"), m_attempt.recipePath(), QStringLiteral("--study"),
        m_task.study.path, QStringLiteral("--session"), m_attempt.sessionPath(),
        QStringLiteral("--facts")};
    const auto add = [&words](const char* option, const QString& value) {
        if (!value.isEmpty())
            words += {QLatin1String(option), value};
    };
    add("--series", m_task.study.series);
    add("--repair", m_task.study.repair);
    add("--spacing", m_task.study.spacing);
    m_process->setStandardInputFile(QProcess::nullDevice());
    m_process->start(QCoreApplication::applicationFilePath(), words + m_task.options);
}

bool StudyJob::isOver()
{
    if (m_process && m_process->state() != QProcess::NotRunning)
        return false;
    conclude();
    if (!m_succeeded && m_mayBeTransient && !m_stopped && m_attempts <= m_task.retries) {
        start();
        static_cast<void>(writeRecord());
        return false;
    }
    takeResults();
    m_record[QStringLiteral("attempts")] = m_attempts;
    m_record[QStringLiteral("ended")] = now();
    m_record[QStringLiteral("seconds")] = double(m_clock.elapsed()) / 1000.0;
    m_record[QStringLiteral("state")] = m_succeeded ? QStringLiteral("done")
        : m_stopped                                 ? QStringLiteral("stopped")
                                                    : QStringLiteral("failed");
    if (!m_succeeded)
        m_record[QStringLiteral("failure")] = m_failure;
    if (const Result<void> written = writeRecord(); !written) {
        m_succeeded = false;
        m_failure = ui::errorText(written.error());
    }
    m_results.end();
    return true;
}

void StudyJob::stop()
{
    m_stopped = true;
    if (m_process)
        m_process->terminate();
}

void StudyJob::readOutput()
{
    const QList<QByteArray> lines = m_process->readAllStandardOutput().split('\n');
    for (const QByteArray& text : lines) {
        const QJsonObject line = QJsonDocument::fromJson(text).object();
        if (line.contains(QStringLiteral("hash")))
            m_record[QStringLiteral("stateHash")] = line.value(QStringLiteral("hash"));
        for (const char* fact : {"source", "renderer", "driver", "stateHash"}) {
            if (line.contains(QLatin1String(fact)))
                m_record[QLatin1String(fact)] = line.value(QLatin1String(fact));
        }
        if (line.value(QStringLiteral("mayBeTransient")).toBool())
            m_mayBeTransient = true;
    }
}

/// Also of a run that failed: what it has finished is whole. But it does not replace what was done.
/// One that crashed has closed nothing.
void StudyJob::takeResults()
{
    const bool crashed = m_record.contains(QStringLiteral("signal"));
    const bool takes = !crashed && (m_succeeded || !m_keepsDone);
    Result<void> taken;
    if (takes)
        taken = m_attempt.survey();
    if (takes && taken) {
        // Before anything gets its name it is on record whose it is.
        m_attempt.noteIn(m_record);
        taken = writeRecord();
    }
    if (takes && taken)
        taken = m_attempt.place();
    if (taken) {
        m_attempt.concludeIn(m_record);
    } else if (m_succeeded) {
        m_succeeded = false;
        m_failure = ui::errorText(taken.error());
    }
    if (m_succeeded)
        m_record.remove(keepsDoneField);
    else if (!takes && m_keepsDone)
        m_failure += QStringLiteral("; what was done before stays as it is");
    m_attempt.discard();
    m_record.remove(QStringLiteral("attempt"));
}

void StudyJob::conclude()
{
    m_succeeded = false;
    // Not even begun: there was no place for its files.
    if (!m_process)
        return;
    readOutput();
    const QStringList said = m_attempt.told(QString::fromUtf8(m_process->readAllStandardError()))
                                 .split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    m_record[QStringLiteral("messages")] = QJsonArray::fromStringList(said);
    if (m_process->error() == QProcess::FailedToStart) {
        m_failure = QStringLiteral("burin run cannot be started: %1").arg(m_process->errorString());
        m_mayBeTransient = true;
    } else if (m_process->exitStatus() == QProcess::CrashExit) {
        // Qt has the signal's number there.
        m_record[QStringLiteral("signal")] = m_process->exitCode();
        m_failure = QStringLiteral("burin run was ended by signal %1").arg(m_process->exitCode());
        m_mayBeTransient = true;
    } else {
        m_record[QStringLiteral("exitCode")] = m_process->exitCode();
        // 128 and more: it was told to end, and not by us.
        m_mayBeTransient |= m_process->exitCode() >= 128;
        if (m_process->exitCode() != 0 && m_failure.isEmpty())
            m_failure = said.isEmpty()
                ? QStringLiteral("burin run ended with status %1").arg(m_process->exitCode())
                : said.last();
    }
    // The disk, or whoever ended it, was at fault, not the recipe.
    m_mayBeTransient |= !m_failure.isEmpty() && m_attempt.isSessionLeftOpen();
    if (m_failure.isEmpty() && !m_attempt.closeSession()) {
        m_failure = QStringLiteral("its session could not be closed as one file");
        m_mayBeTransient = true;
    }
    m_succeeded = m_failure.isEmpty();
    m_process.reset();
}

Result<void> StudyJob::writeRecord()
{
    return StudyResults::write(m_task.folder, "record.json", QJsonDocument(m_record).toJson());
}

} // namespace app
