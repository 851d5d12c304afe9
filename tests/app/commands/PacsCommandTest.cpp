// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/servers/BurinProgram.h"
#include "tests/support/servers/PacsServers.h"
#include "ui/settings/PacsSources.h"

#include <QDir>
#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

namespace pacsCommandTest {

/// `burin echo`, `find`, `get` and `send`: JSON that others build on, text, statuses, one line
/// where they fail.
class PacsCommandTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void fromSendToGet();
    void theSameOverTheWeb();
    void failuresAreOneLine();
    void wrongArguments_data();
    void wrongArguments();
};

namespace {

QString word(const char* text)
{
    return QLatin1String(text);
}

} // namespace

void PacsCommandTest::fromSendToGet()
{
    const test::PacsServer server(test::PacsServer::Program::Dcmqrscp);
    if (!server.absent().isEmpty())
        QSKIP(qPrintable(server.absent()));
    QVERIFY2(server.problem().isEmpty(), qPrintable(server.problem()));
    const QString node = server.node().name();
    const QTemporaryDir folder;
    const test::SyntheticSeries series;
    const QStringList files = test::writeSeries(series, folder.filePath(word("sent")));

    const test::Outcome echo = test::burin({word("echo"), node});
    QCOMPARE(echo.status, 0);
    QCOMPARE(echo.output, node.toUtf8() + " answers\n");

    QFile notes(folder.filePath(word("sent/notes.txt")));
    QVERIFY(notes.open(QIODevice::WriteOnly));
    notes.write("not a DICOM file, however long it may be");
    notes.close();
    const test::Outcome sent =
        test::burin({word("send"), node, folder.filePath(word("sent")), word("--json")});
    QVERIFY2(sent.status == 0, qPrintable(sent.complaint));
    QCOMPARE(sent.complaint, word("burin: files that are no DICOM stayed here: 1\n"));
    QCOMPARE(sent.lines.size(), 1);
    QCOMPARE(sent.lines[0][word("sent")].toInt(), int(files.size()));

    const test::Outcome found = test::burin({word("find"), node, word("--json")});
    QCOMPARE(found.status, 0);
    QCOMPARE(found.lines.size(), 1);
    QCOMPARE(found.lines[0][word("studyUid")].toString(), series.studyUid);
    QCOMPARE(found.lines[0][word("patientName")].toString(), word("Synthetic^Subject"));
    const test::Outcome list =
        test::burin({word("find"), node, word("--study"), series.studyUid, word("--json")});
    QCOMPARE(list.status, 0);
    QCOMPARE(list.lines.size(), 1);
    QCOMPARE(list.lines[0][word("seriesUid")].toString(), series.seriesUid);
    QVERIFY(test::burin({word("find"), node}).output.contains("Synthetic^Subject"));

    const test::Outcome none = test::burin({word("find"), node, word("--patient-id"), word("X")});
    QCOMPARE(none.status, 0);
    QVERIFY(none.output.isEmpty());
    QCOMPARE(none.complaint, word("burin: no study there matches\n"));

    const QString target = folder.filePath(word("got"));
    const test::Outcome got = test::burin({word("get"), node, word("--study"), series.studyUid,
        word("--to"), target, word("--json")});
    QVERIFY2(got.status == 0, qPrintable(got.complaint));
    QCOMPARE(got.lines.size(), 1);
    QCOMPARE(got.lines[0][word("received")].toInt(), int(files.size()));
    QCOMPARE(QDir(target).entryList(QDir::Files).size(), files.size());
}

void PacsCommandTest::theSameOverTheWeb()
{
    const test::PacsServer server(test::PacsServer::Program::OrthancWeb);
    if (!server.absent().isEmpty())
        QSKIP(qPrintable(server.absent()));
    QVERIFY2(server.problem().isEmpty(), qPrintable(server.problem()));
    const QString address = server.webNode().name();
    const QTemporaryDir folder;
    const test::SyntheticSeries series;
    const QStringList files = test::writeSeries(series, folder.filePath(word("sent")));
    const test::Outcome stranger = test::burin({word("echo"), address});
    QCOMPARE(stranger.status, 1);
    QVERIFY2(stranger.complaint.contains(word("login is missing, wrong or not allowed")),
        qPrintable(stranger.complaint));

    QFile login(folder.filePath(word("login")));
    QVERIFY(login.open(QIODevice::WriteOnly));
    login.write("tester:secret\n");
    login.close();
    QVERIFY(login.setPermissions(QFile::ReadOwner | QFile::WriteOwner));
    const QStringList known{word("--login-file"), login.fileName()};
    const test::Outcome echo = test::burin(QStringList{word("echo"), address} + known);
    QCOMPARE(echo.output, address.toUtf8() + " answers\n");
    const test::Outcome sent = test::burin(
        QStringList{word("send"), address, folder.filePath(word("sent")), word("--json")} + known);
    QVERIFY2(sent.status == 0, qPrintable(sent.complaint));
    QCOMPARE(sent.lines[0][word("sent")].toInt(), int(files.size()));

    // Under its name in the settings, and with the login from the environment.
    qputenv("XDG_CONFIG_HOME", folder.path().toUtf8());
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder.path());
    QCoreApplication::setOrganizationName(word("burin"));
    QCoreApplication::setApplicationName(word("burin"));
    ui::setPacsSources({{.name = word("Cloud"), .node = server.webNode(), .movePort = {}}});
    QSettings().sync();
    qputenv("BURIN_LOGIN", "tester:secret");
    const test::Outcome found = test::burin({word("find"), word("cloud"), word("--json")});
    QVERIFY2(found.status == 0, qPrintable(found.complaint));
    QCOMPARE(found.lines.size(), 1);
    QCOMPARE(found.lines[0][word("studyUid")].toString(), series.studyUid);
    QCOMPARE(found.lines[0][word("instanceCount")].toInt(), int(files.size()));
    const QString target = folder.filePath(word("got"));
    const test::Outcome got = test::burin({word("get"), word("Cloud"), word("--study"),
        series.studyUid, word("--to"), target, word("--json")});
    QVERIFY2(got.status == 0, qPrintable(got.complaint));
    QCOMPARE(QDir(target).entryList(QDir::Files).size(), files.size());
    const test::Outcome other = test::burin({word("find"), word("attic")});
    QCOMPARE(other.status, 2);
    QVERIFY2(other.complaint.contains(word("(there are: Cloud)")), qPrintable(other.complaint));
    qunsetenv("BURIN_LOGIN");
}

void PacsCommandTest::failuresAreOneLine()
{
    const QString nobody = QStringLiteral("NOBODY@127.0.0.1:%1").arg(test::freePort());
    const QTemporaryDir folder;
    const QStringList file = test::writeSeries({.size = {8, 8, 1}}, folder.filePath(word("sent")));
    const QString target = folder.filePath(word("got"));
    for (const QStringList& arguments : {QStringList{word("echo"), nobody},
             QStringList{word("find"), nobody}, QStringList{word("send"), nobody, file.front()},
             QStringList{
                 word("get"), nobody, word("--study"), word("2.25.1"), word("--to"), target}}) {
        const test::Outcome outcome = test::burin(arguments);
        QCOMPARE(outcome.status, 1);
        QVERIFY(outcome.output.isEmpty());
        QCOMPARE(outcome.complaint,
            QStringLiteral("burin: %1 cannot be reached: Connection refused\n").arg(nobody));
    }
    QVERIFY(!QDir(target).exists());
    // Nothing to send is no matter of the words.
    const QString empty = folder.filePath(word("empty"));
    QVERIFY(QDir().mkpath(empty));
    const test::Outcome nothing = test::burin({word("send"), nobody, empty});
    QCOMPARE(nothing.status, 1);
    QVERIFY2(nothing.complaint.startsWith(QStringLiteral("burin: %1: ").arg(empty)),
        qPrintable(nothing.complaint));
}

void PacsCommandTest::wrongArguments_data()
{
    QTest::addColumn<QString>("arguments");
    QTest::newRow("no node") << word("echo");
    QTest::newRow("no title") << word("echo localhost:104");
    QTest::newRow("two nodes") << word("find A@b:104 C@d:104");
    QTest::newRow("no limit") << word("find A@b:104 --most 0");
    QTest::newRow("no date") << word("find A@b:104 --date 2024");
    QTest::newRow("half a range") << word("find A@b:104 --date 20240101-2024");
    QTest::newRow("a filter for series") << word("find A@b:104 --study 1.2 --modality CT");
    QTest::newRow("no study") << word("get A@b:104 --to /tmp/x");
    QTest::newRow("no folder") << word("get A@b:104 --study 1.2");
    QTest::newRow("no port") << word("get A@b:104 --study 1.2 --to /tmp/x --move x");
    QTest::newRow("nothing to send") << word("send A@b:104");
    QTest::newRow("no time") << word("echo A@b:104 --timeout 0");
    QTest::newRow("no such name") << word("echo somewhere");
    QTest::newRow("a password in the address") << word("echo https://a:secret@b/dicom-web");
    QTest::newRow("a title for the web") << word("echo https://b/dicom-web --own-title A");
    QTest::newRow("a login for a node") << word("echo A@b:104 --login-file x");
    QTest::newRow("C-MOVE from the web")
        << word("get https://b/dicom-web --study 1.2 --to /tmp/x --move 104");
    QTest::newRow("half a certificate")
        << word("echo A@b:104 --tls-authority a.pem --tls-certificate b.pem");
}

void PacsCommandTest::wrongArguments()
{
    QFETCH(QString, arguments);
    const test::Outcome outcome = test::burin(arguments.split(u' '));
    QCOMPARE(outcome.status, 2);
    QCOMPARE(outcome.complaint.count(u'\n'), 1);
    QVERIFY(!outcome.complaint.contains(word("secret")));
    // Of the command line it names words that stand there.
    QVERIFY2(!outcome.complaint.contains(word("field '")), qPrintable(outcome.complaint));
}

BURIN_TEST(PacsCommandTest)

} // namespace pacsCommandTest

#include "PacsCommandTest.moc"
