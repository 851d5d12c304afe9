// SPDX-License-Identifier: Apache-2.0
#include "core/nifti/NiftiWriter.h"
#include "core/session/EditSession.h"
#include "core/study/StudyLoader.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FileSizeLimit.h"
#include "tests/support/faults/SmallFileSystem.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/sessions/SessionScript.h"
#include "tests/support/servers/BurinProgram.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QJsonDocument>
#include <QProcess>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTemporaryDir>
#include <QtTest>

#include <sys/stat.h>

namespace crashRecoveryTest {

using namespace core;

namespace {

/// When the program is killed.
struct Moment {
    int afterLines = 0; ///< of its output
    bool thenCheckpoint = false; ///< wait until what the WAL holds begins to be folded back
    int thenMicroseconds = 0;
};

/// SQLite in WAL mode writes to the file itself only when it folds the WAL back.
struct FileStamp {
    qint64 size = 0;
    qint64 seconds = 0;
    qint64 nanoseconds = 0;
    static FileStamp of(const QByteArray& path)
    {
        struct stat status { };
        if (stat(path.constData(), &status) != 0)
            return {};
        return {status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
    }
    bool operator==(const FileStamp&) const = default;
};

const char* const companions[]{"", "-wal", "-journal"};

} // namespace

} // namespace crashRecoveryTest

Q_DECLARE_METATYPE(crashRecoveryTest::Moment)

namespace crashRecoveryTest {

/// kill -9 in the middle of `burin run`, and disks that fill up under it: what was printed is in
/// the file, nothing is torn, and the session goes on from there as if nothing had been.
///
/// BURIN_SEED draws another script and other moments.
class CrashRecoveryTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void killed_data();
    void killed();
    void diskFull_data();
    void diskFull();
    void filesThatCannotGrow_data();
    void filesThatCannotGrow();
    void cleanupTestCase();

private:
    [[nodiscard]] QStringList runArguments(const QString& session) const;
    /// Complete lines of the output, each compared with the oracle.
    [[nodiscard]] std::size_t acknowledged(const QByteArray& output) const;
    [[nodiscard]] QByteArray runUntil(const Moment& moment, const QString& session);
    void addMoments(int anywhere, int checkpoints, int closings);
    void recovers(const QString& file, std::size_t lines);
    void verifies(const QString& file) const;

    QTemporaryDir m_folder;
    QString m_study;
    QString m_recipe;
    std::uint32_t m_seed = 0;
    test::SessionScript m_script;
    int m_firstLineMs = 0; ///< until the first line of an undisturbed run
    int m_lineMicroseconds = 0; ///< from line to line
    int m_tornCheckpoints = 0; ///< kills that left a half-folded WAL
};

QStringList CrashRecoveryTest::runArguments(const QString& session) const
{
    return {QStringLiteral("run"), m_recipe, QStringLiteral("--study"), m_study,
        QStringLiteral("--session"), session};
}

std::size_t CrashRecoveryTest::acknowledged(const QByteArray& output) const
{
    // A line that was cut off by the end acknowledges nothing.
    const QList<QByteArray> lines = output.left(output.lastIndexOf('\n') + 1).split('\n');
    const std::size_t count = std::size_t(lines.size()) - 1;
    for (std::size_t i = 0; i < count; ++i) {
        const QJsonObject line = QJsonDocument::fromJson(lines[qsizetype(i)]).object();
        const RowId position = m_script.positionAfter(i + 1);
        if (line[QStringLiteral("row")].toInteger(-1) != position
            || line[QStringLiteral("hash")].toString().toLatin1()
                != m_script.hashes[std::size_t(position)])
            qFatal(
                "line %zu is not what the oracle has: %s", i + 1, lines[qsizetype(i)].constData());
    }
    return count;
}

void CrashRecoveryTest::initTestCase()
{
    QVERIFY(m_folder.isValid());
    const LoadedVolume small = test::smallStudy();
    std::vector<std::int16_t> values;
    for (const std::uint16_t code : small.codes)
        values.push_back(std::int16_t(small.volume.encoding.value(code)));
    m_study = m_folder.filePath(QStringLiteral("small.nii.gz"));
    QVERIFY(writeNifti(
        m_study, {.geometry = small.volume.geometry, .voxels = values, .description = {}}));

    m_seed = qEnvironmentVariableIsSet("BURIN_SEED")
        ? qEnvironmentVariable("BURIN_SEED").toUInt()
        : std::uint32_t(QDateTime::currentMSecsSinceEpoch());
    qInfo("BURIN_SEED=%u", m_seed);
    test::Random random(m_seed);
    const Result<LoadedVolume> volume = loadVolume(m_study);
    QVERIFY(volume);
    m_script = test::randomScript(*volume, random, test::longRun() ? 60 : 30);
    m_recipe = m_folder.filePath(QStringLiteral("recipe.json"));
    QFile recipe(m_recipe);
    QVERIFY(recipe.open(QIODevice::WriteOnly));
    recipe.write(m_script.recipe());
    recipe.close();

    QProcess burin;
    QElapsedTimer clock;
    clock.start();
    burin.start(QStringLiteral(BURIN_PROGRAM),
        runArguments(m_folder.filePath(QStringLiteral("whole.burin"))));
    QVERIFY(burin.waitForReadyRead(120000));
    m_firstLineMs = int(clock.elapsed());
    QVERIFY(burin.waitForFinished(300000));
    m_lineMicroseconds =
        int((clock.elapsed() - m_firstLineMs) * 1000 / qint64(m_script.steps.size())) + 1;
    QVERIFY2(burin.exitCode() == 0, burin.readAllStandardError().constData());
    QCOMPARE(acknowledged(burin.readAllStandardOutput()), m_script.steps.size());
}

void CrashRecoveryTest::addMoments(int anywhere, int checkpoints, int closings)
{
    QTest::addColumn<Moment>("moment");
    test::Random random(m_seed + 1);
    const int lines = int(m_script.steps.size());
    QTest::newRow("before anything") << Moment{};
    for (int i = 1; i < anywhere; ++i) {
        // From the start on, or from a line on: within about what two steps take.
        const int after = test::randomInt(random, 0, lines - 1);
        const int micro = after == 0 ? test::randomInt(random, 0, m_firstLineMs * 1000)
                                     : test::randomInt(random, 0, 2 * m_lineMicroseconds);
        QTest::addRow("%d: after %d lines, %d µs", i, after, micro) << Moment{after, false, micro};
    }
    for (int i = 0; i < checkpoints; ++i) {
        const int after = test::randomInt(random, 1, lines / 2);
        const int micro = test::randomInt(random, 0, 2000);
        QTest::addRow("checkpoint %d: after %d lines, %d µs", i, after, micro)
            << Moment{after, true, micro};
    }
    for (int i = 0; i < closings; ++i) {
        const bool checkpoint = i % 2 == 0;
        const int micro = test::randomInt(random, 0, checkpoint ? 800 : 20000);
        QTest::addRow("closing %d: %s%d µs", i, checkpoint ? "checkpoint, " : "", micro)
            << Moment{lines, checkpoint, micro};
    }
}

void CrashRecoveryTest::killed_data()
{
    if (test::longRun())
        addMoments(140, 30, 30);
    else
        addMoments(4, 1, 1);
}

QByteArray CrashRecoveryTest::runUntil(const Moment& moment, const QString& session)
{
    QProcess burin;
    burin.start(QStringLiteral(BURIN_PROGRAM), runArguments(session));
    if (!burin.waitForStarted())
        qFatal("burin does not start");
    QByteArray output;
    while (output.count('\n') < moment.afterLines && burin.waitForReadyRead(60000))
        output += burin.readAllStandardOutput();
    if (moment.thenCheckpoint) {
        const QByteArray path = session.toLocal8Bit();
        const FileStamp before = FileStamp::of(path);
        while (burin.state() == QProcess::Running && FileStamp::of(path) == before)
            burin.waitForFinished(0);
    }
    // Sleeping is too coarse here: it takes the scheduler's time.
    QElapsedTimer clock;
    clock.start();
    while (clock.nsecsElapsed() < qint64(moment.thenMicroseconds) * 1000) {
        if (moment.thenMicroseconds > 5000)
            QTest::qSleep(1);
    }
    burin.kill();
    burin.waitForFinished(60000);
    return output + burin.readAllStandardOutput();
}

void CrashRecoveryTest::killed()
{
    QFETCH(Moment, moment);
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("crashed.burin"));
    const std::size_t lines = acknowledged(runUntil(moment, file));
    const bool wal = QFileInfo(file + QStringLiteral("-wal")).size() > 0;
    m_tornCheckpoints += moment.thenCheckpoint && wal ? 1 : 0;
    recovers(file, lines);
    if (!QTest::currentTestFailed() && QFileInfo::exists(file))
        verifies(file);
}

/// Opens a session whose program is gone, compares it with the oracle, and does the rest of the
/// script.
void CrashRecoveryTest::recovers(const QString& file, std::size_t lines)
{
    // Nothing was promised before the first line: there may be no session yet.
    if (!QFileInfo::exists(file)) {
        QCOMPARE(lines, std::size_t(0));
        return;
    }
    {
        // As SQLite finds it, on a copy: opening may mend.
        const QTemporaryDir folder;
        const QString copy = folder.filePath(QStringLiteral("copy.burin"));
        for (const char* companion : companions)
            QFile::copy(file + QLatin1String(companion), copy + QLatin1String(companion));
        QSqlDatabase database =
            QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("integrity"));
        database.setDatabaseName(copy);
        QVERIFY(database.open());
        QSqlQuery query(QStringLiteral("PRAGMA integrity_check"), database);
        QVERIFY(query.next());
        QCOMPARE(query.value(0).toString(), QStringLiteral("ok"));
    }
    QSqlDatabase::removeDatabase(QStringLiteral("integrity"));

    Result<LoadedVolume> volume = loadVolume(m_study);
    QVERIFY(volume);
    reference::ReferenceEngine oracle;
    auto session = EditSession::open(oracle, *std::move(volume), file);
    if (!session && lines == 0) {
        // It was just being made.
        QVERIFY(session.error().code == ErrorCode::FileTruncated
            || session.error().code == ErrorCode::UnsupportedFormat);
        QVERIFY(QFile::remove(file));
        return;
    }
    QVERIFY2(
        session, session ? "" : qPrintable(session.error().arguments.join(QStringLiteral(": "))));
    QVERIFY((*session)->settle());
    const History& history = (*session)->history();
    const auto rows = RowId(history.rows().size());
    const bool whole = lines == m_script.steps.size();
    QVERIFY2(rows >= m_script.rowsAfter(lines),
        qPrintable(
            QStringLiteral("%1 of %2 rows are there").arg(rows).arg(m_script.rowsAfter(lines))));
    // Steps go one by one, so no more than one more had begun.
    QVERIFY(rows <= m_script.rowsAfter(whole ? lines : lines + 1));
    for (const HistoryRow& row : history.rows()) {
        QCOMPARE(row.stateHash, m_script.hashes[std::size_t(row.id)]);
        QCOMPARE(row.parent, m_script.parents[std::size_t(row.id)]);
    }
    QVERIFY(m_script.positionsFrom(lines).count(history.position()) == 1);
    QCOMPARE((*session)->stateHash(), m_script.hashes[std::size_t(history.position())]);

    std::size_t next = lines;
    if (rows > m_script.rowsAfter(lines))
        ++next;
    else
        QVERIFY((*session)->goTo(m_script.positionAfter(lines)));
    for (; next < m_script.steps.size(); ++next) {
        const RecipeStep& step = m_script.steps[next].step;
        if (const auto* edit = std::get_if<Edit>(&step)) {
            QVERIFY((*session)->apply(*edit));
        } else {
            QVERIFY((*session)->settle());
            QVERIFY((*session)->goTo(m_script.positionAfter(next + 1)));
        }
    }
    QVERIFY((*session)->settle());
    QCOMPARE(history.rows().size() + 1, m_script.hashes.size());
    QCOMPARE((*session)->stateHash(), m_script.hashes[std::size_t(history.position())]);
    QCOMPARE(history.line(), m_script.line);
}

void CrashRecoveryTest::verifies(const QString& file) const
{
    for (const char* companion : {"-wal", "-shm", "-journal"})
        QVERIFY(!QFileInfo::exists(file + QLatin1String(companion)));
    const test::Outcome verified =
        test::burin({QStringLiteral("replay"), file, QStringLiteral("--verify")});
    QVERIFY2(verified.status == 0, qPrintable(verified.complaint));
}

void CrashRecoveryTest::diskFull_data()
{
    QTest::addColumn<int>("kibibytes");
    QTest::addColumn<Moment>("moment");
    test::Random random(m_seed + 2);
    const auto whole =
        int(QFileInfo(m_folder.filePath(QStringLiteral("whole.burin"))).size() / 1024);
    for (int i = 0; i < (test::longRun() ? 30 : 2); ++i) {
        // WAL and file lie there side by side.
        const int kibibytes = test::randomInt(random, 60, 2 * whole);
        // Killed before it fills up, or in the end it gives up by itself.
        const int after = i % 3 == 0 ? int(m_script.steps.size())
                                     : test::randomInt(random, 0, int(m_script.steps.size()) / 2);
        const int micro = test::randomInt(random, 0, 2 * m_lineMicroseconds);
        QTest::addRow("%d KiB, %d: after %d lines, %d µs", kibibytes, i, after, micro)
            << kibibytes << Moment{after, i % 3 == 2, micro};
    }
}

/// On a file system of a few hundred kilobytes.
void CrashRecoveryTest::diskFull()
{
    QFETCH(int, kibibytes);
    QFETCH(Moment, moment);
    test::SmallFileSystem disk(kibibytes);
    if (!disk.problem().isEmpty())
        QSKIP(qPrintable(QStringLiteral("no file system can be mounted: ") + disk.problem()));
    const QString file = disk.filePath(QStringLiteral("full.burin"));
    const std::size_t lines = acknowledged(runUntil(moment, file));

    // What is there can be taken to another disk …
    const QTemporaryDir elsewhere;
    const QString taken = elsewhere.filePath(QStringLiteral("taken.burin"));
    for (const char* companion : companions)
        QFile::copy(file + QLatin1String(companion), taken + QLatin1String(companion));
    recovers(taken, lines);
    if (QTest::currentTestFailed())
        return;
    if (QFileInfo::exists(taken))
        verifies(taken);
    // … opens where it is, full as that is, …
    if (lines > 0) {
        Result<LoadedVolume> volume = loadVolume(m_study);
        QVERIFY(volume);
        reference::ReferenceEngine oracle;
        const auto session = EditSession::open(oracle, *std::move(volume), file);
        QVERIFY2(session,
            session ? "" : qPrintable(session.error().arguments.join(QStringLiteral(": "))));
        QVERIFY(RowId((*session)->history().rows().size()) >= m_script.rowsAfter(lines));
        QCOMPARE((*session)->stateHash(),
            m_script.hashes[std::size_t((*session)->history().position())]);
    }
    // … and goes on there once it has room.
    disk.resize(16 * 1024);
    recovers(file, lines);
    if (!QTest::currentTestFailed() && QFileInfo::exists(file))
        verifies(file);
}

void CrashRecoveryTest::filesThatCannotGrow_data()
{
    QTest::addColumn<int>("kibibytes");
    test::Random random(m_seed + 3);
    for (int i = 0; i < (test::longRun() ? 10 : 1); ++i) {
        const int kibibytes = test::randomInt(random, 60, 2000);
        QTest::addRow("%d KiB, %d", kibibytes, i) << kibibytes;
    }
}

/// The full disk that needs no rights; other error codes, the same promise.
void CrashRecoveryTest::filesThatCannotGrow()
{
    QFETCH(int, kibibytes);
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("full.burin"));
    std::size_t lines = 0;
    {
        const test::FileSizeLimit limit(rlim_t(kibibytes) * 1024);
        lines = acknowledged(runUntil({.afterLines = int(m_script.steps.size())}, file));
    }
    recovers(file, lines);
    if (!QTest::currentTestFailed() && QFileInfo::exists(file))
        verifies(file);
}

void CrashRecoveryTest::cleanupTestCase()
{
    qInfo("%d kills in the middle of a checkpoint", m_tornCheckpoints);
}

BURIN_TEST(CrashRecoveryTest)

} // namespace crashRecoveryTest

#include "CrashRecoveryTest.moc"
