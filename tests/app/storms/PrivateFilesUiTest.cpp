// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/ExportFormats.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/faults/FileShim.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/MarkedSeries.h"
#include "tests/support/servers/WebArchive.h"

#include <QDir>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QProcess>
#include <QTest>

#include <csignal>

#include <sys/resource.h>
#include <sys/stat.h>

namespace privateFilesUiTest {

using test::key;
using test::Outcome;

namespace {

int modeOf(const QString& path)
{
    struct stat status { };
    return ::stat(QFile::encodeName(path).constData(), &status) == 0 ? int(status.st_mode & 07777)
                                                                     : -1;
}

QJsonObject drill()
{
    return {{key("edit"), key("drill")},
        {key("view"),
            QJsonObject{{key("eyeLps"), QJsonArray{0, -300, 45}},
                {key("targetLps"), QJsonArray{0, 0, 45}}, {key("up"), QJsonArray{0, 0, 1}},
                {key("heightMm"), 60}, {key("orthographic"), true}}},
        {key("mask"), QJsonObject{{key("shape"), key("circle")}, {key("radiusMm"), 4}}},
        {key("depthMm"), 6}, {key("surface"), QJsonObject{{key("threshold"), -2000}}},
        {key("samples"), QJsonArray{QJsonValue(QJsonArray{0, 0, 1.0, 0.0})}}};
}

} // namespace

/// From a series that tells who the patient is in every attribute to everything that was ever
/// written of it, over the command line and the window: who the patient is stands where it is named
/// here, where its owner alone can read it, and nowhere else.
class PrivateFilesUiTest : public QObject {
    Q_OBJECT

    test::WatchedHome m_home;
    QString m_study;
    QList<test::FileEvent> m_events;
    QString m_said; ///< on both outputs, by all commands

    QString at(const QString& name) const { return m_home.path(QStringLiteral("out/") + name); }
    void carryOut(const QStringList& words);
    /// What may tell who the patient is, and why; null: nothing of the kind.
    const char* allowed(const QString& path) const;

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void initTestCase();
    void everythingIsWritten();
    void aStudyComesFromAServer();
    void aWindowIsOpened();
    void aWindowIsKilled_data();
    void aWindowIsKilled();
    void nothingIsSaid();
    void noFileTellsWhoThePatientIs();
    void whatTellsIsItsOwnersAlone();
};

void PrivateFilesUiTest::initTestCase()
{
    m_study = m_home.path(QStringLiteral("MARKERPATH/ct"));
    test::writeSeries(test::markedSeries(), m_study);
    QVERIFY(QDir().mkpath(at({})));
}

void PrivateFilesUiTest::carryOut(const QStringList& words)
{
    const Outcome outcome = m_home.burin(words);
    QVERIFY2(outcome.status == 0, qPrintable(words.join(u' ') + u' ' + outcome.complaint));
    m_said += outcome.complaint + QString::fromUtf8(outcome.output);
    for (const test::FileEvent& event : m_home.events())
        m_events += event;
}

#define CARRY_OUT(...)                                                                             \
    carryOut(QStringList __VA_ARGS__);                                                             \
    if (QTest::currentTestFailed())                                                                \
    return

void PrivateFilesUiTest::everythingIsWritten()
{
    QJsonArray exports;
    for (const core::ExportFormatFacts& format : core::exportFormats())
        exports.append(QJsonObject{{key("format"), QLatin1String(format.name)},
            {key("file"), at(QLatin1String(format.name) + QLatin1String(format.ending))},
            {key("deidentify"), true}});
    exports.append(QJsonObject{{key("format"), key("carved-volume")},
        {key("file"), at(QStringLiteral("series"))}, {key("deidentify"), true}});
    exports.append(QJsonObject{
        {key("format"), key("carved-volume")}, {key("file"), at(QStringLiteral("carved.nii.gz"))}});
    exports.append(QJsonObject{{key("format"), key("coverage")}, {key("layer"), 1},
        {key("file"), at(QStringLiteral("coverage.nii.gz"))}});
    const QJsonArray code{key("SCT"), key("10200004"), key("Liver")};
    const QJsonArray edits{
        QJsonObject{{key("edit"), key("addSegment")}, {key("name"), key("Leber")},
            {key("color"), key("#336699")}, {key("code"), code}},
        drill(),
        QJsonObject{{key("edit"), key("layerToSegment")}, {key("layer"), 1}, {key("segment"), 1}}};
    const QJsonObject content{{key("edits"), edits}, {key("export"), exports}};
    QFile recipe(m_home.path(QStringLiteral("r.json")));
    QVERIFY(recipe.open(QIODevice::WriteOnly));
    recipe.write(QJsonDocument(content).toJson());
    recipe.close();
    const QString session = at(QStringLiteral("a.burin"));
    CARRY_OUT({key("run"), recipe.fileName(), key("--study"), m_study, key("--session"), session,
        key("--author"), key("MARKERUSER")});
    CARRY_OUT({key("replay"), session, key("--verify")});
    CARRY_OUT({key("replay"), session, key("--export"), at(QStringLiteral("deflated.dcm")),
        key("--deidentify"), key("--deflated")});
    CARRY_OUT({key("history"), session, key("--deidentified"), at(QStringLiteral("b.burin"))});
    CARRY_OUT({key("history"), at(QStringLiteral("b.burin")), key("--report"),
        at(QStringLiteral("shared.html"))});
    CARRY_OUT({key("mesh"), at(QStringLiteral("nifti.nii.gz")), key("--study"), m_study,
        key("--out"), at(QStringLiteral("m.ply")), key("--vertices"), key("200")});
    const QJsonObject once{{key("edits"), edits},
        {key("export"),
            QJsonArray{QJsonObject{{key("format"), key("nifti")}, {key("file"), key("mask.nii.gz")},
                {key("deidentify"), true}}}}};
    QFile batch(m_home.path(QStringLiteral("batch.json")));
    QVERIFY(batch.open(QIODevice::WriteOnly));
    batch.write(QJsonDocument(once).toJson());
    batch.close();
    CARRY_OUT({key("batch"), batch.fileName(), key("--studies"),
        m_home.path(QStringLiteral("MARKERPATH")), key("--into"), at(QStringLiteral("batch"))});
}

void PrivateFilesUiTest::aStudyComesFromAServer()
{
    QStringList files;
    for (const QFileInfo& file : QDir(m_study).entryInfoList(QDir::Files))
        files += file.filePath();
    const test::WebArchive archive(files);
    const test::WebServer server(
        [&archive](const QByteArray& line, const QByteArray&) { return archive.answer(line); });
    const QString address = server.url().toString();
    const QString study = QString::fromLatin1(archive.studyUid());
    CARRY_OUT({key("get"), address, key("--study"), study, key("--to"), m_home.path(key("got"))});
    CARRY_OUT({key("send"), address, m_study});
    QCOMPARE(
        QDir(m_home.path(key("got"))).entryList(QDir::Files | QDir::Hidden).size(), files.size());
}

/// With a working session and settings of its own.
void PrivateFilesUiTest::aWindowIsOpened()
{
    QProcess process;
    process.setProcessEnvironment(m_home.environment());
    process.start(QStringLiteral(BURIN_PROGRAM), {key("open"), m_study});
    const QString sessions = m_home.path(QStringLiteral("state/burin"));
    QElapsedTimer waited;
    waited.start();
    bool open = false;
    while (!open && waited.elapsed() < 60'000 && !process.waitForFinished(100)) {
        QDirIterator walk(sessions, {QStringLiteral("*.burin-wal")}, QDir::Files | QDir::Hidden,
            QDirIterator::Subdirectories);
        open = walk.hasNext();
    }
    QVERIFY2(open, process.readAllStandardError().constData());
    ::kill(pid_t(process.processId()), SIGTERM);
    QVERIFY(process.waitForFinished(60'000));
    m_said += QString::fromUtf8(process.readAllStandardError() + process.readAllStandardOutput());
    for (const test::FileEvent& event : m_home.events())
        m_events += event;
}

void PrivateFilesUiTest::aWindowIsKilled_data()
{
    QTest::addColumn<int>("signal");
    QTest::newRow("from outside") << SIGKILL;
    QTest::newRow("as if it had crashed") << SIGSEGV;
    QTest::newRow("as if a library had given up") << SIGABRT;
}

/// What it left and said, and what the next window makes of that.
void PrivateFilesUiTest::aWindowIsKilled()
{
    QFETCH(int, signal);
    const QDir notes(m_home.path(QStringLiteral("state/burin/windows")));
    QProcess process;
    process.setProcessEnvironment(m_home.environment());
    // A core would hold everything.
    process.setChildProcessModifier([] {
        const rlimit none{0, 0};
        ::setrlimit(RLIMIT_CORE, &none);
    });
    // That of the row before.
    QVERIFY(QDir(m_home.path(QStringLiteral("state/burin/sessions"))).removeRecursively());
    process.start(QStringLiteral(BURIN_PROGRAM), {key("open"), m_study});
    QElapsedTimer waited;
    waited.start();
    bool open = false;
    while (!open && waited.elapsed() < 60'000 && !process.waitForFinished(100)) {
        QDirIterator walk(m_home.path(QStringLiteral("state/burin")),
            {QStringLiteral("*.burin-wal")}, QDir::Files | QDir::Hidden,
            QDirIterator::Subdirectories);
        open = walk.hasNext();
    }
    QVERIFY2(open, process.readAllStandardError().constData());
    ::kill(pid_t(process.processId()), signal);
    QVERIFY(process.waitForFinished(60'000));
    const QString said =
        QString::fromUtf8(process.readAllStandardError() + process.readAllStandardOutput());
    QCOMPARE(said.isEmpty(), signal == SIGKILL);
    m_said += said;
    const QStringList left = notes.entryList(QDir::Files);
    QCOMPARE(left.size(), 1);
    QVERIFY(test::markersIn(notes.filePath(left.front())).isEmpty());
    QCOMPARE(modeOf(notes.filePath(left.front())), 0600);

    process.start(QStringLiteral(BURIN_PROGRAM), {key("open")});
    waited.restart();
    while (QFile::exists(notes.filePath(left.front())) && waited.elapsed() < 60'000
        && !process.waitForFinished(100)) { }
    QVERIFY2(
        !QFile::exists(notes.filePath(left.front())), process.readAllStandardError().constData());
    ::kill(pid_t(process.processId()), SIGTERM);
    QVERIFY(process.waitForFinished(60'000));
    m_said += QString::fromUtf8(process.readAllStandardError() + process.readAllStandardOutput());
    for (const test::FileEvent& event : m_home.events())
        m_events += event;
}

void PrivateFilesUiTest::nothingIsSaid()
{
    for (const QByteArray& marker : test::markers()) {
        // Where its study lies is what a session is asked about.
        if (marker != "MARKERPATH")
            QVERIFY2(!m_said.contains(QString::fromLatin1(marker)), marker.constData());
    }
}

const char* PrivateFilesUiTest::allowed(const QString& path) const
{
    if (path.startsWith(m_home.path(QStringLiteral("MARKERPATH"))))
        return "the study itself";
    if (path == at(QStringLiteral("a.burin")))
        return "a session says where its study lies and how its series is called";
    if (path.startsWith(at(QStringLiteral("batch/"))) && path.endsWith(QLatin1String(".burin")))
        return "a session of a batch, likewise";
    if (path == at(QStringLiteral("batch/ct/record.json")))
        return "a record says where the study lies that it is of";
    if (path == at(QStringLiteral("batch/results.csv")))
        return "the table of a batch has the paths of its list";
    if (path.startsWith(m_home.path(QStringLiteral("state/burin/"))))
        return "a working session, likewise";
    if (path.startsWith(m_home.path(QStringLiteral("config/burin/"))))
        return "settings list the studies that were open last";
    if (path.startsWith(m_home.path(QStringLiteral("got/"))))
        return "the study, as a server sent it";
    if (path == m_home.path(QStringLiteral("shim.log")))
        return "the test's own";
    return nullptr;
}

void PrivateFilesUiTest::noFileTellsWhoThePatientIs()
{
    int searched = 0;
    QDirIterator walk(m_home.path({}), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        const QString path = walk.next();
        if (allowed(path))
            continue;
        ++searched;
        const QByteArrayList found = test::markersIn(path);
        QVERIFY2(found.isEmpty(), (path.toUtf8() + ": " + found.join(' ')).constData());
        for (const QByteArray& marker : test::markers())
            QVERIFY2(!path.contains(QString::fromLatin1(marker)), qPrintable(path));
    }
    QVERIFY2(
        searched > int(core::exportFormats().size()) + 6, qPrintable(QString::number(searched)));
    // Names that were there for a while only, too. The files of a download are called by their
    // UIDs.
    for (const test::FileEvent& event : m_events) {
        const bool isDownload = event.path.startsWith(m_home.path(QStringLiteral(".got.")));
        for (const QByteArray& marker : test::markers())
            QVERIFY2((isDownload && marker.startsWith("2.25."))
                    || !event.path.contains(QString::fromLatin1(marker)),
                qPrintable(event.path));
    }
    // The session itself does not say more than it may.
    for (const QByteArray& found : test::markersIn(at(QStringLiteral("a.burin"))))
        QVERIFY2(found != "MARKERID" && found != "MARKERDEV", found.constData());
}

void PrivateFilesUiTest::whatTellsIsItsOwnersAlone()
{
    QVERIFY(QFile::exists(m_home.path(QStringLiteral("config/burin/burin.conf"))));
    QCOMPARE(modeOf(m_home.path(QStringLiteral("config/burin/burin.conf"))), 0600);
    QCOMPARE(modeOf(m_home.path(QStringLiteral("config/QtProject.conf"))), 0600);
    QCOMPARE(modeOf(m_home.path(QStringLiteral("got"))), 0700);
    QCOMPARE(modeOf(at(QStringLiteral("a.burin"))), 0600);
    QCOMPARE(modeOf(at(QStringLiteral("b.burin"))), 0600);
    QCOMPARE(modeOf(at(QStringLiteral("batch/ct/record.json"))), 0600);
    QCOMPARE(modeOf(at(QStringLiteral("batch/ct/recipe.json"))), 0600);
    QDirIterator batched(
        at(QStringLiteral("batch")), {key("*.burin")}, QDir::Files, QDirIterator::Subdirectories);
    QVERIFY(batched.hasNext());
    QCOMPARE(modeOf(batched.next()), 0600);
    int sessions = 0;
    QDirIterator walk(m_home.path(QStringLiteral("state/burin")),
        QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        const QFileInfo info(walk.next());
        ++sessions;
        QVERIFY2((modeOf(info.filePath()) & 077) == 0 || (modeOf(info.path()) & 077) == 0,
            qPrintable(info.filePath()));
    }
    QVERIFY(sessions > 0);
    // What there was for a while lay in folders that nobody else could look into, or was such.
    const QString temporary = m_home.path(QStringLiteral("tmp"));
    for (const test::FileEvent& event : m_events) {
        if (event.path.startsWith(temporary + u'/') && event.what == "make"
            && QFileInfo(event.path).path() == temporary)
            QCOMPARE(event.more, QStringLiteral("700"));
        if (event.path.startsWith(temporary + u'/') && event.what == "open"
            && QFileInfo(event.path).path() == temporary)
            QVERIFY2(event.more == u"600", qPrintable(event.path));
        const bool isSession = event.path.contains(QLatin1String(".burin"))
            && (event.what == "open" || event.what == "unnamed")
            && !event.path.endsWith(QLatin1String(".conf"))
            && !event.path.contains(QLatin1String(".burin-download")); // in a private folder
        const bool isExport = event.path.contains(QLatin1String("/out/"))
            && event.path.contains(QLatin1String("/.burin-"));
        if (isSession && !isExport)
            QVERIFY2(event.more == u"600",
                qPrintable(event.path + QStringLiteral(" is made with ") + event.more));
    }
}

BURIN_WINDOW_TEST(PrivateFilesUiTest)

} // namespace privateFilesUiTest

#include "PrivateFilesUiTest.moc"
