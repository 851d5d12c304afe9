// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/program/TraceEvents.h"

#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <QDir>
#include <QFile>

#include <set>
#include <vector>

namespace openCommandUiTest {

class OpenCommandUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void saysWhatIsWrong_data();
    void saysWhatIsWrong();
    void saysWhyAFolderDoesNotOpen();
    void saysThatThereIsNoDisplay_data();
    void saysThatThereIsNoDisplay();
    void saysWhatThereIsInsteadOfOpenGl();
    void screenshotOfTheStartPage();
    void screenshotOfTheDemonstration();
    void aScreenshotReplacesNothingButPictures();

private:
    static void tellsWhatTookHowLong(const QString& trace);

    struct Outcome {
        int status = -1;
        QString output;
    };
    using Variables = QMap<QString, QString>;
    [[nodiscard]] QProcessEnvironment environment(const Variables& variables) const;
    Outcome burin(const QStringList& arguments, const Variables& variables = {});

    QTemporaryDir m_folder;
};

/// Nothing of the test stays in the user's folders.
QProcessEnvironment OpenCommandUiTest::environment(const Variables& variables) const
{
    QProcessEnvironment made = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"XDG_STATE_HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME"})
        made.insert(QLatin1String(name), m_folder.filePath(QLatin1String(name)));
    for (auto each = variables.begin(); each != variables.end(); ++each)
        made.insert(each.key(), each.value());
    return made;
}

OpenCommandUiTest::Outcome OpenCommandUiTest::burin(
    const QStringList& arguments, const Variables& variables)
{
    QProcess process;
    process.setProcessEnvironment(environment(variables));
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(QStringLiteral(BURIN_PROGRAM), QStringList{QStringLiteral("open")} + arguments);
    if (!process.waitForFinished(300000)) {
        process.kill();
        process.waitForFinished();
        return {};
    }
    const bool crashed = process.exitStatus() != QProcess::NormalExit;
    return {crashed ? -1 : process.exitCode(), QString::fromUtf8(process.readAll())};
}

void OpenCommandUiTest::saysWhatIsWrong_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("status");
    QTest::addColumn<QString>("words");
    const auto row = [](const char* name, const QStringList& arguments, int status,
                         const char* words) {
        QTest::newRow(name) << arguments << status << QString::fromUtf8(words);
    };
    row("no such path", {QStringLiteral("/no/such/study")}, 1,
        "/no/such/study: no such file or folder");
    row("size without height", {QStringLiteral("--size"), QStringLiteral("800")}, 2, "--size 800");
    row("size missing", {QStringLiteral("--size")}, 2, "--size needs a value");
    row("picture of another kind", {QStringLiteral("--screenshot"), QStringLiteral("a.jpg")}, 2,
        "--screenshot: the name of a picture of the window ends in .png");
    row("series of nothing", {QStringLiteral("--series"), QStringLiteral("1.2.3")}, 2,
        "--series, --repair and --spacing are for a study");
    row("repair of the demonstration",
        {QStringLiteral("--demo"), QStringLiteral("--repair"), QStringLiteral("tilt")}, 2,
        "--series, --repair and --spacing are for a study");
    row("unknown option", {QStringLiteral("--shiny")}, 2, "unknown option --shiny");
    row("two paths", {QStringLiteral("a"), QStringLiteral("b")}, 2, "one path at a time: b");
}

void OpenCommandUiTest::saysWhatIsWrong()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, words);
    const Outcome outcome = burin(arguments);
    QFETCH(int, status);
    QVERIFY2(outcome.status == status,
        qPrintable(QStringLiteral("%1: %2").arg(outcome.status).arg(outcome.output)));
    QVERIFY2(outcome.output.contains(words), qPrintable(outcome.output));
    if (status == 2)
        QVERIFY2(outcome.output.contains(QStringLiteral("(burin open --help)")),
            qPrintable(outcome.output));
}

void OpenCommandUiTest::saysWhyAFolderDoesNotOpen()
{
    const QString empty = m_folder.filePath(QStringLiteral("empty"));
    QVERIFY(QDir().mkpath(empty));
    const QString picture = m_folder.filePath(QStringLiteral("none.png"));
    const Outcome outcome = burin({empty, QStringLiteral("--screenshot"), picture});
    QVERIFY2(outcome.status == 1,
        qPrintable(QStringLiteral("%1: %2").arg(outcome.status).arg(outcome.output)));
    QVERIFY2(outcome.output.contains(empty), qPrintable(outcome.output));
    QVERIFY(!QFile::exists(picture));
}

void OpenCommandUiTest::saysThatThereIsNoDisplay_data()
{
    QTest::addColumn<QString>("display");
    QTest::addColumn<QString>("platform");
    QTest::newRow("none") << QString() << QString();
    QTest::newRow("one that is not there") << QStringLiteral(":4711") << QString();
    QTest::newRow("a platform that is not there") << QString() << QStringLiteral("nonsense");
}

void OpenCommandUiTest::saysThatThereIsNoDisplay()
{
    QFETCH(QString, display);
    QFETCH(QString, platform);
    const Outcome outcome = burin({},
        {{QStringLiteral("DISPLAY"), display}, {QStringLiteral("WAYLAND_DISPLAY"), QString()},
            {QStringLiteral("QT_QPA_PLATFORM"), platform}});
    QVERIFY2(outcome.status == 1,
        qPrintable(QStringLiteral("%1: %2").arg(outcome.status).arg(outcome.output)));
    QVERIFY2(
        outcome.output.contains(QLatin1String("there is no display")), qPrintable(outcome.output));
    QCOMPARE(outcome.output.count(u'\n'), 1);
}

/// On stderr, and in a dialog that waits for somebody to read it.
void OpenCommandUiTest::saysWhatThereIsInsteadOfOpenGl()
{
    const Variables old{{QStringLiteral("MESA_GL_VERSION_OVERRIDE"), QStringLiteral("4.1")}};
    const QString picture = m_folder.filePath(QStringLiteral("none.png"));
    const Outcome outcome = burin({QStringLiteral("--screenshot"), picture}, old);
    if (outcome.status == 0)
        QSKIP("this driver is not Mesa's");
    QVERIFY2(outcome.status == 1,
        qPrintable(QStringLiteral("%1: %2").arg(outcome.status).arg(outcome.output)));
    QVERIFY2(outcome.output.contains(QLatin1String("no OpenGL 4.5 available"))
            && outcome.output.contains(QLatin1String("has OpenGL 4.1")),
        qPrintable(outcome.output));

    QProcess process;
    process.setProcessEnvironment(environment(old));
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(QStringLiteral(BURIN_PROGRAM), {QStringLiteral("open")});
    QVERIFY(process.waitForReadyRead(60000));
    QVERIFY(process.readAll().contains("has OpenGL 4.1"));
    // Without a dialog it would have ended by now.
    QVERIFY(!process.waitForFinished(1500));
    process.kill();
    QVERIFY(process.waitForFinished());
}

void OpenCommandUiTest::screenshotOfTheStartPage()
{
    const QString file = m_folder.filePath(QStringLiteral("start.png"));
    const Outcome outcome = burin({QStringLiteral("--screenshot"), file, QStringLiteral("--size"),
        QStringLiteral("1024x640")});
    QVERIFY2(outcome.status == 0, qPrintable(outcome.output));
    QCOMPARE(QImage(file).size(), QSize(1024, 640));
}

void OpenCommandUiTest::aScreenshotReplacesNothingButPictures()
{
    const QString picture = m_folder.filePath(QStringLiteral("again.png"));
    for (int time = 0; time < 2; ++time) {
        const Outcome outcome = burin({QStringLiteral("--screenshot"), picture});
        QVERIFY2(outcome.status == 0, qPrintable(outcome.output));
    }
    const QString session = m_folder.filePath(QStringLiteral("mine.burin"));
    const QByteArray content = "somebody's work";
    QFile file(session);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
    file.close();
    const Outcome refused = burin({QStringLiteral("--screenshot"), session});
    QCOMPARE(refused.status, 1);
    QVERIFY2(refused.output.contains(session)
            && refused.output.contains(QLatin1String("it is no PNG picture")),
        qPrintable(refused.output));
    QCOMPARE(test::bytesOf(session), content);
}

void OpenCommandUiTest::screenshotOfTheDemonstration()
{
    const QString file = m_folder.filePath(QStringLiteral("demonstration.png"));
    const QString trace = m_folder.filePath(QStringLiteral("trace.json"));
    const Outcome outcome = burin({QStringLiteral("--demo"), QStringLiteral("--screenshot"), file,
        QStringLiteral("--size"), QStringLiteral("1100x700"), QStringLiteral("--trace"), trace});
    QVERIFY2(outcome.status == 0, qPrintable(outcome.output));
    const QImage picture(file);
    QCOMPARE(picture.size(), QSize(1100, 700));
    // Nothing was edited: no session stays behind.
    const QDir sessions(m_folder.filePath(QStringLiteral("XDG_STATE_HOME/burin/sessions")));
    QVERIFY(sessions.exists());
    QCOMPARE(sessions.entryList(QDir::Files), QStringList());
    // The middle of each quarter of the views is inside the head.
    const int right = picture.width() - 340;
    for (const double x : {0.28, 0.76}) {
        for (const double y : {0.30, 0.74}) {
            int lit = 0;
            const int left = int(x * right) - 20;
            const int top = int(y * picture.height()) - 20;
            for (int row = 0; row < 40; ++row) {
                for (int column = 0; column < 40; ++column)
                    lit += qGray(picture.pixel(left + column, top + row)) > 40;
            }
            QVERIFY2(lit > 200, qPrintable(QStringLiteral("quarter %1, %2").arg(x).arg(y)));
        }
    }
    tellsWhatTookHowLong(trace);
}

/// Opening was a task, and each of four views was drawn until it was refined.
void OpenCommandUiTest::tellsWhatTookHowLong(const QString& trace)
{
    const std::vector<test::TraceEvent> events = test::traceEvents(test::bytesOf(trace));
    QVERIFY(!events.empty());
    QVERIFY2(test::overlapIn(events).isEmpty(), qPrintable(test::overlapIn(events)));
    std::set<QString> views;
    for (const test::TraceEvent& event : events) {
        if (event.category == QLatin1String("frame")
            && event.name == QLatin1String("refined picture"))
            views.insert(event.lane);
        // An event of the window is told if it took long.
        QVERIFY(event.category != QLatin1String("window") || event.end - event.begin >= 1'000'000);
    }
    QVERIFY(views.size() >= 4);
    QVERIFY(test::timeIn(events, "frame") > 0);
    QVERIFY(test::timeIn(events, "window") > 0);
    QVERIFY(test::timeIn(events, "task") > 0);
    QVERIFY(test::timeIn(events, "engine", "open volume") > 0);
}

// A client of the display itself: a server that loses its last client begins anew, and turns away
// who comes meanwhile (Qt aborts then).
BURIN_WINDOW_TEST(OpenCommandUiTest)

} // namespace openCommandUiTest

#include "OpenCommandUiTest.moc"
