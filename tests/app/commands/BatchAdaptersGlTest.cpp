// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/servers/ProcessTable.h"
#include "tests/support/servers/Python.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QProcess>
#include <QTest>

#include <csignal>

namespace batchAdaptersGlTest {

using test::key;
using test::RunningProcess;

/// One list of studies through `burin batch`, Snakemake and Dask (packaging/adapters), each with
/// two workers, one of which is killed at work. Nothing is lost, nothing is done twice, and all
/// three come to the same files.
///
/// BURIN_STUDIES sets how many studies (6; with BURIN_LONG=1 a thousand).
class BatchAdaptersGlTest : public QObject, protected test::CommandFixture {
    Q_OBJECT

    /// What killed processes were at.
    struct Struck {
        QString study; ///< empty: none was killed
        qsizetype processes = 0;
    };
    /// Which processes of a worker are killed.
    enum class Victims { Run, Job, WorkerAndJob };

    int m_studies = 0;
    QString m_list;
    QString m_recipe;
    QMap<QString, QJsonObject> m_first; ///< what `burin batch` came to, by study

    /// As processes name it.
    [[nodiscard]] QString into(const char* way) const
    {
        return QDir(QFileInfo(path(".")).canonicalFilePath()).filePath(key(way));
    }
    [[nodiscard]] static QJsonObject record(const QString& into, const QString& name);
    [[nodiscard]] static bool isAt(const QString& into, const QString& name);
    [[nodiscard]] bool start(QProcess& whole, const QString& program, const QStringList& words);
    [[nodiscard]] static Struck kill(const QString& into, QProcess& whole, Victims victims);
    static Struck killJob(const std::vector<RunningProcess>& all, const RunningProcess& job,
        const QString& into, const QProcess& whole, Victims victims);
    static Struck killRun(const RunningProcess& run, const QString& into);
    void checkResults(const QString& into, const Struck& struck, bool begunAgain);

private Q_SLOTS:
    void initTestCase();
    void init() { test::failOnUnexpectedMessages(); }
    void burinBatch();
    void snakemake();
    void dask();
};

QJsonObject BatchAdaptersGlTest::record(const QString& into, const QString& name)
{
    QFile file(QDir(into).filePath(name + key("/record.json")));
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()
                                          : QJsonObject();
}

/// Whether that study was begun and is not finished.
bool BatchAdaptersGlTest::isAt(const QString& into, const QString& name)
{
    return record(into, name)[key("state")].toString() == key("begun");
}

void BatchAdaptersGlTest::initTestCase()
{
    QVERIFY(prepareStudy());
    makeFolder();
    m_studies = qEnvironmentVariableIsSet("BURIN_STUDIES")
        ? qEnvironmentVariableIntValue("BURIN_STUDIES")
        : test::longRun() ? 1000
                          : 6;
    QByteArray text = "study,name,segment,radius\n";
    core::LoadedVolume loaded = test::smallStudy();
    const std::uint16_t air = loaded.codes[0];
    for (int i = 0; i < m_studies; ++i) {
        loaded.codes[0] = std::uint16_t(air + i); // another study each
        const QByteArray number = QByteArray::number(i);
        const QString study = otherStudy(("small" + number + ".nii.gz").constData(), loaded);
        QVERIFY(!study.isEmpty());
        text += study.toUtf8() + ",s" + number + ",Part " + number + ','
            + QByteArray::number(2.0 + 10.0 * i / m_studies) + '\n';
    }
    QFile list(path("studies.csv"));
    QVERIFY(list.open(QIODevice::WriteOnly) && list.write(text) == text.size());
    m_list = list.fileName();

    QJsonObject paint =
        test::toJson({test::paintAt(1, {test::pointsInBrain().front()})})[0].toObject();
    QVERIFY(paint.contains(key("radiusMm")));
    paint[key("radiusMm")] = key("${radius}");
    QJsonArray edits = test::toJson({test::addSegment("${segment}")});
    edits.append(paint);
    m_recipe = recipe("recipe.json",
        {{key("edits"), edits},
            {key("export"),
                QJsonArray{
                    QJsonObject{{key("format"), key("nifti")}, {key("file"), key("mask.nii.gz")}},
                    QJsonObject{{key("format"), key("csv")}, {key("file"), key("${name}.csv")}}}}});
}

/// In a folder of its own, where programs leave what they like.
bool BatchAdaptersGlTest::start(QProcess& whole, const QString& program, const QStringList& words)
{
    const QString folder = path("scratch");
    if (!QDir().mkpath(folder))
        return false;
    whole.setWorkingDirectory(folder);
    whole.setStandardInputFile(QProcess::nullDevice());
    whole.setStandardOutputFile(QProcess::nullDevice());
    whole.start(program, words);
    return whole.waitForStarted();
}

/// `burin run` alone: the batch does its study again.
BatchAdaptersGlTest::Struck BatchAdaptersGlTest::killRun(
    const RunningProcess& run, const QString& into)
{
    const QString study = QDir(into).relativeFilePath(run.words[2]).section(QLatin1Char('/'), 0, 0);
    if (!test::holdProcess(run.pid))
        return {};
    ::kill(pid_t(run.pid), SIGKILL);
    return {.study = study, .processes = 1};
}

/// The job and what it has started, and the worker that has started it, as if a machine went off.
BatchAdaptersGlTest::Struck BatchAdaptersGlTest::killJob(const std::vector<RunningProcess>& all,
    const RunningProcess& job, const QString& into, const QProcess& whole, Victims victims)
{
    const QString study = job.words.value(job.words.indexOf(key("--only")) + 1);
    const bool withWorker = victims == Victims::WorkerAndJob;
    if (withWorker && (job.parent <= 1 || job.parent == whole.processId()))
        return {};
    std::vector<qint64> struck;
    if (withWorker)
        struck.push_back(job.parent);
    struck.push_back(job.pid);
    const std::size_t itself = struck.size();
    for (const RunningProcess& each : all) {
        if (each.parent == job.pid && each.words.value(1) == key("run"))
            struck.push_back(each.pid);
    }
    if (struck.size() == itself || !test::holdProcess(job.pid))
        return {};
    // It stands still, so this does not change any more.
    if (!isAt(into, study)) {
        ::kill(pid_t(job.pid), SIGCONT);
        return {};
    }
    for (const qint64 pid : struck)
        ::kill(pid_t(pid), SIGKILL);
    return {.study = study, .processes = qsizetype(struck.size())};
}

/// Waits until one is at work, and kills it.
BatchAdaptersGlTest::Struck BatchAdaptersGlTest::kill(
    const QString& into, QProcess& whole, Victims victims)
{
    const QString program = QFileInfo(QStringLiteral(BURIN_PROGRAM)).fileName();
    while (whole.state() != QProcess::NotRunning) {
        const std::vector<RunningProcess> all = test::runningProcesses();
        for (const RunningProcess& each : all) {
            if (QFileInfo(each.words.front()).fileName() != program)
                continue;
            Struck struck;
            if (victims == Victims::Run) {
                const bool isRun = each.words.value(1) == key("run")
                    && each.words.value(2).startsWith(into + QLatin1Char('/'));
                struck = isRun ? killRun(each, into) : Struck{};
            } else if (each.words.contains(key("--only")) && each.words.contains(into)) {
                struck = killJob(all, each, into, whole, victims);
            }
            if (!struck.study.isEmpty())
                return struck;
        }
        QTest::qWait(20);
    }
    return {};
}

/// @param begunAgain by another job; else it was the same job that tried again
void BatchAdaptersGlTest::checkResults(const QString& into, const Struck& struck, bool begunAgain)
{
    QMap<QString, QJsonObject> came;
    int starts = 0;
    int attempts = 0;
    for (int i = 0; i < m_studies; ++i) {
        const QString name = key("s") + QString::number(i);
        const QJsonObject made = record(into, name);
        QVERIFY2(made[key("state")].toString() == key("done"), qPrintable(name));
        starts += made[key("starts")].toInt();
        attempts += made[key("attempts")].toInt();
        if (name == struck.study)
            QCOMPARE(made[begunAgain ? key("starts") : key("attempts")].toInt(), 2);
        // Where it comes from.
        QVERIFY(made[key("source")].isObject());
        for (const char* fact : {"renderer", "program", "recipeSha256", "sessionSha256"})
            QVERIFY2(!made[key(fact)].toString().isEmpty(), fact);
        QVERIFY(!made.contains(key("made")) && !made.contains(key("attempt")));
        QJsonObject result;
        for (const char* each : {"study", "stateHash", "recipeSha256", "exports"})
            result[key(each)] = made[key(each)];
        QCOMPARE(made[key("exports")].toArray().size(), 2);
        came[name] = result;
        // Nothing is there besides, not even of what was killed.
        const QDir folder(QDir(into).filePath(name));
        QStringList there =
            folder.entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden);
        // A record whose writing was cut off.
        there.removeIf([](const QString& file) {
            return file.startsWith(key(".burin-")) && file.endsWith(key(".json"));
        });
        QStringList expected{key("lock"), key("mask.nii.gz"), key("recipe.json"),
            key("record.json"), name + key(".csv"), key("session.burin")};
        there.sort();
        expected.sort();
        QCOMPARE(there, expected);
    }
    QCOMPARE(starts, m_studies + (begunAgain ? 1 : 0));
    QCOMPARE(attempts, m_studies + (begunAgain ? 0 : 1));
    if (m_first.isEmpty())
        m_first = came;
    QVERIFY(came == m_first);
    QStringList different;
    for (const QJsonObject& each : came)
        different += each[key("exports")][0][key("sha256")].toString();
    different.removeDuplicates();
    QVERIFY(different.size() > 1);

    QFile table(QDir(into).filePath(key("results.csv")));
    QVERIFY(table.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = table.readAll().split('\n');
    QCOMPARE(lines.size(), m_studies + 2);
    for (int i = 0; i < m_studies; ++i) {
        const QByteArray& line = lines[i + 1];
        QVERIFY2(line.startsWith('s' + QByteArray::number(i) + ',') && line.contains(",done,"),
            line.constData());
    }
}

void BatchAdaptersGlTest::burinBatch()
{
    QElapsedTimer clock;
    clock.start();
    QProcess whole;
    QVERIFY(start(whole, QStringLiteral(BURIN_PROGRAM),
        {key("batch"), m_recipe, key("--studies"), m_list, key("--into"), into("batch"),
            key("--jobs"), key("2"), key("--retries"), key("1")}));
    const Struck struck = kill(into("batch"), whole, Victims::Run);
    QVERIFY(whole.state() == QProcess::NotRunning || whole.waitForFinished(-1));
    QVERIFY2(whole.exitStatus() == QProcess::NormalExit && whole.exitCode() == 0,
        whole.readAllStandardError().constData());
    QVERIFY(!struck.study.isEmpty());
    checkResults(into("batch"), struck, false);
    qInfo("%d studies in %.1f s, killed: burin run at %s", m_studies,
        double(clock.elapsed()) / 1000.0, qPrintable(struck.study));
}

void BatchAdaptersGlTest::snakemake()
{
    if (test::runProgram(key("snakemake"), {key("--version")}).exitCode != 0)
        QSKIP("snakemake is not installed (packaging/packages.txt, group long)");
    QElapsedTimer clock;
    clock.start();
    QProcess whole;
    QVERIFY(start(whole, key("snakemake"),
        {key("--snakefile"), QStringLiteral(BURIN_SOURCE_DIR "/packaging/adapters/Snakefile"),
            key("--cores"), key("2"), key("--keep-going"), key("--retries"), key("2"),
            key("--config"), key("burin=" BURIN_PROGRAM), key("recipe=") + m_recipe,
            key("studies=") + m_list, key("into=") + into("snakemake")}));
    const Struck struck = kill(into("snakemake"), whole, Victims::Job);
    QVERIFY(whole.state() == QProcess::NotRunning || whole.waitForFinished(-1));
    QVERIFY2(whole.exitStatus() == QProcess::NormalExit && whole.exitCode() == 0,
        whole.readAllStandardError().right(4000).constData());
    QVERIFY(!struck.study.isEmpty());
    checkResults(into("snakemake"), struck, true);
    qInfo("%d studies in %.1f s, killed: %d processes at %s", m_studies,
        double(clock.elapsed()) / 1000.0, int(struck.processes), qPrintable(struck.study));
}

void BatchAdaptersGlTest::dask()
{
    const QString python = key("/usr/bin/python3");
    if (test::runProgram(python, {key("-c"), key("import distributed")}).exitCode != 0)
        QSKIP("Dask is not installed (python3-distributed)");
    QElapsedTimer clock;
    clock.start();
    QProcess whole;
    QVERIFY(start(whole, python,
        {QStringLiteral(BURIN_SOURCE_DIR "/packaging/adapters/burin_dask.py"), m_recipe,
            key("--studies"), m_list, key("--into"), into("dask"), key("--burin"),
            key(BURIN_PROGRAM), key("--workers"), key("2")}));
    const Struck struck = kill(into("dask"), whole, Victims::WorkerAndJob);
    QVERIFY(whole.state() == QProcess::NotRunning || whole.waitForFinished(-1));
    QVERIFY2(whole.exitStatus() == QProcess::NormalExit && whole.exitCode() == 0,
        whole.readAllStandardError().right(4000).constData());
    QVERIFY(!struck.study.isEmpty());
    checkResults(into("dask"), struck, true);
    qInfo("%d studies in %.1f s, killed: %d processes at %s", m_studies,
        double(clock.elapsed()) / 1000.0, int(struck.processes), qPrintable(struck.study));
}

BURIN_TEST(BatchAdaptersGlTest)

} // namespace batchAdaptersGlTest

#include "BatchAdaptersGlTest.moc"
