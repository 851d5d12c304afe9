// SPDX-License-Identifier: Apache-2.0
#include "app/batch/StudyJob.h"

#include "app/Version.h"
#include "core/export/common/MaskSelection.h"
#include "ui/base/ErrorText.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QDirIterator>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>

#include <csignal>
#include <utility>

#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>

namespace app {

namespace {

using core::Result;

QString now()
{
    return QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs);
}

/// A file with its hash; of a folder (a derived series) every file in it.
Result<QJsonArray> filesOf(const QString& path, const QDir& folder)
{
    QStringList files;
    if (QFileInfo(path).isDir()) {
        QDirIterator walk(path, QDir::Files, QDirIterator::Subdirectories);
        while (walk.hasNext())
            files += walk.next();
        files.sort();
    } else {
        files += path;
    }
    QJsonArray list;
    for (const QString& file : files) {
        const Result<QString> hash = core::sha256OfFile(file);
        if (!hash)
            return tl::unexpected(hash.error());
        const QString beside = folder.relativeFilePath(file);
        list.append(QJsonObject{
            {QStringLiteral("file"), beside.startsWith(QLatin1String("../")) ? file : beside},
            {QStringLiteral("sha256"), *hash}});
    }
    return list;
}

} // namespace

StudyJob::StudyJob(StudyTask task, StudyResults results)
    : m_task(std::move(task))
    , m_results(std::move(results))
{
}

Result<void> StudyJob::begin()
{
    const QJsonObject earlier = StudyResults::record(m_task.folder);
    m_record = {
        {QStringLiteral("name"), m_task.study.name},
        {QStringLiteral("study"), m_task.study.path},
        {QStringLiteral("variables"), m_task.study.variables},
        {QStringLiteral("state"), QStringLiteral("begun")},
        {QStringLiteral("program"), QStringLiteral("burin " BURIN_VERSION)},
        {QStringLiteral("recipe"), m_task.recipePath},
        {QStringLiteral("recipeSha256"),
            QString::fromLatin1(
                QCryptographicHash::hash(m_task.recipe, QCryptographicHash::Sha256).toHex())},
        {QStringLiteral("options"), QJsonArray::fromStringList(m_task.options)},
        {QStringLiteral("session"), m_task.study.session},
        {QStringLiteral("begun"), now()},
        // How often it was begun in all, also by processes that were killed.
        {QStringLiteral("starts"), earlier.value(QStringLiteral("starts")).toInt() + 1},
    };
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
    m_mayBeTransient = false;
    m_failure.clear();
    for (const char* each : {"failure", "source", "renderer", "stateHash", "exports", "messages"})
        m_record.remove(QLatin1String(each));
    const QDir folder(m_task.folder);
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
    QStringList words{QStringLiteral("run"), folder.filePath(QStringLiteral("recipe.json")),
        QStringLiteral("--study"), m_task.study.path, QStringLiteral("--session"),
        folder.filePath(m_task.study.session), QStringLiteral("--facts"),
        // What is replaced was left by an attempt in a folder that is ours.
        QStringLiteral("--force")};
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
        return false;
    }
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
    const QDir folder(m_task.folder);
    QJsonArray exports;
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
        if (!line.contains(QStringLiteral("export")))
            continue;
        const QString file = line.value(QStringLiteral("export")).toString();
        const Result<QJsonArray> files = filesOf(folder.absoluteFilePath(file), folder);
        if (!files) {
            m_failure = ui::errorText(files.error());
            continue;
        }
        for (const QJsonValue& each : *files)
            exports.append(each);
    }
    m_record[QStringLiteral("exports")] = exports;
}

void StudyJob::conclude()
{
    readOutput();
    const QStringList said = QString::fromUtf8(m_process->readAllStandardError())
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
    m_succeeded = m_failure.isEmpty();
    m_process.reset();
}

Result<void> StudyJob::writeRecord()
{
    return StudyResults::write(m_task.folder, "record.json", QJsonDocument(m_record).toJson());
}

} // namespace app
