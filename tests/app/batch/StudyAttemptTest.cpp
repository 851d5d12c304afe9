// SPDX-License-Identifier: Apache-2.0
#include "app/batch/StudyAttempt.h"
#include "app/batch/RecipeTemplate.h"
#include "core/base/files/SystemFile.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/database/SessionUse.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/faults/FileShim.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SessionFiles.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <cerrno>
#include <cstdio>

namespace studyAttemptTest {

using app::StudyAttempt;

namespace {

constexpr const char* attemptIn = "BURIN_ATTEMPT_IN";

void write(const QString& path, const QByteArray& content)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        qFatal("cannot write %s", qPrintable(path));
}

} // namespace

/// An attempt that has a series again, on a disk that fails. It tells on stdout why it could not
/// place it.
class AttemptOnFailingDisk : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void places()
    {
        const QString folder = qEnvironmentVariable(attemptIn);
        if (folder.isEmpty())
            QSKIP("StudyAttemptTest starts it");
        const QString image = QStringLiteral("series/1.dcm");
        const QJsonObject made{{QStringLiteral("file"), image},
            {QStringLiteral("sha256"),
                QString::fromLatin1(test::fingerprint(QDir(folder).filePath(image)))}};
        StudyAttempt attempt(folder, QStringLiteral("session.burin"),
            R"({"export": [{"format": "carved-volume", "file": "series"}]})",
            {{QStringLiteral("made"), QJsonArray{made}}});
        QVERIFY(attempt.begin());
        const QDir staged = QFileInfo(attempt.sessionPath()).dir();
        QVERIFY(staged.mkpath(QStringLiteral("series")));
        write(staged.filePath(image), "new");
        QVERIFY(attempt.survey());
        const auto placed = attempt.place();
        std::printf("TOLD %s\n",
            placed ? "nothing" : placed.error().arguments.join(u' ').toLocal8Bit().constData());
        std::fflush(stdout);
    }
};

/// What an attempt at a study has left of a session, and what gets its name.
class StudyAttemptTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void aSessionThatWasLeftOpenIsClosed();
    void theSegOfAReportIsLookedAtBefore();
    void aSeriesHasItsNameUntilAnotherHasIt_data();
    void aSeriesHasItsNameUntilAnotherHasIt();
};

/// Its run could write everything but that it is closed; nothing lies beside it.
void StudyAttemptTest::aSessionThatWasLeftOpenIsClosed()
{
    const auto name = QStringLiteral("session.burin");
    StudyAttempt attempt(m_folder.path(), name, "{}", {});
    QVERIFY(attempt.begin());
    const QString staged = attempt.sessionPath();
    QVERIFY(!test::makeSession(staged).isEmpty());
    const auto sound = core::checkSession(staged);
    QVERIFY(sound && !sound->rows.empty());
    QFile file(staged);
    QVERIFY(file.open(QIODevice::ReadWrite));
    QVERIFY(file.seek(18) && file.write("\2\2", 2) == 2); // it says that it is in WAL mode
    file.close();
    QVERIFY(!core::sessionLoss(staged).leftOpen.isEmpty());
    QCOMPARE(core::strayPartOf(staged), QString());

    QVERIFY(attempt.survey());
    QVERIFY(attempt.place());
    const QString placed = m_folder.filePath(name);
    QVERIFY(QFile::exists(placed));
    QVERIFY(core::sessionLoss(placed).leftOpen.isEmpty());
    const auto closed = core::checkSession(placed);
    QVERIFY(closed && closed->isWhole() && closed->leftOpen.isEmpty());
    QCOMPARE(closed->rows.size(), sound->rows.size());
    QCOMPARE(closed->rows.back().stateHash, sound->rows.back().stateHash);
    QJsonObject record;
    attempt.concludeIn(record);
    QCOMPARE(record.value(QStringLiteral("sessionSha256")).toString().toLatin1(),
        test::fingerprint(placed));
}

/// What a report brings along takes nobody's name either, and that is known before any work.
void StudyAttemptTest::theSegOfAReportIsLookedAtBefore()
{
    const QTemporaryDir folder;
    const QByteArray recipe = R"({"edits": [], "export": [{"format": "sr", "file": "a.dcm"}]})";
    const auto session = QStringLiteral("session.burin");
    QVERIFY(StudyAttempt(folder.path(), session, recipe, {}).check());
    QFile other(folder.filePath(QStringLiteral("a-seg.dcm")));
    QVERIFY(other.open(QIODevice::WriteOnly) && other.write("mine") == 4);
    other.close();
    const core::Result<void> checked = StudyAttempt(folder.path(), session, recipe, {}).check();
    QVERIFY(!checked);
    QVERIFY2(checked.error().arguments.value(0).endsWith(QStringLiteral("a-seg.dcm")),
        qPrintable(checked.error().arguments.value(0)));
    QCOMPARE(app::RecipeTemplate::exportsOf(recipe, QStringLiteral("/out")),
        (QStringList{QStringLiteral("/out/a.dcm"), QStringLiteral("/out/a-seg.dcm")}));
}

void StudyAttemptTest::aSeriesHasItsNameUntilAnotherHasIt_data()
{
    QTest::addColumn<QByteArray>("calls");
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("last");
    QTest::addColumn<int>("error");
    constexpr int always = 1 << 30;
    for (int call = 1; call <= 5; ++call) {
        QTest::addRow("call %d", call) << QByteArray("sync,rename") << call << call << EIO;
        QTest::addRow("from call %d on", call)
            << QByteArray("sync,rename") << call << always << EIO;
    }
    // File systems that cannot exchange two names.
    QTest::newRow("no exchange") << QByteArray("rename") << 1 << 1 << EINVAL;
    QTest::newRow("no exchange, and no name") << QByteArray("rename") << 1 << 2 << EINVAL;
}

/// The series that an earlier attempt made is there, or the new one: never none.
void StudyAttemptTest::aSeriesHasItsNameUntilAnotherHasIt()
{
    QFETCH(QByteArray, calls);
    QFETCH(int, first);
    QFETCH(int, last);
    QFETCH(int, error);
    const test::WatchedHome home;
    const QDir folder(home.path(QStringLiteral("out")));
    QVERIFY(folder.mkpath(QStringLiteral("series")));
    const QString image = folder.filePath(QStringLiteral("series/1.dcm"));
    write(image, "old");
    QProcess process;
    QProcessEnvironment environment = home.environment(
        {.under = folder.path(), .calls = calls, .first = first, .last = last, .error = error});
    environment.insert(QLatin1String(attemptIn), folder.path());
    process.setProcessEnvironment(environment);
    process.start(
        QCoreApplication::applicationFilePath(), {QStringLiteral("AttemptOnFailingDisk")});
    QVERIFY(process.waitForFinished(300'000));
    QString told;
    for (const QByteArray& line : process.readAllStandardOutput().split('\n')) {
        if (line.startsWith("TOLD "))
            told = QString::fromLocal8Bit(line.mid(5));
    }
    QVERIFY(!told.isEmpty());
    const bool placed = told == QLatin1String("nothing");
    QCOMPARE(test::bytesOf(image), placed ? QByteArray("new") : QByteArray("old"));
    QVERIFY2(placed || told.contains(core::systemReason(error)), qPrintable(told));
    QCOMPARE(folder.entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
        QStringList{QStringLiteral("series")});
}

BURIN_TEST(AttemptOnFailingDisk)
BURIN_TEST(StudyAttemptTest)

} // namespace studyAttemptTest

#include "StudyAttemptTest.moc"
