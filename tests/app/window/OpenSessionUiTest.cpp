// SPDX-License-Identifier: Apache-2.0
#include "app/window/Application.h"
#include "core/session/EditSession.h"
#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/SessionStudy.h"
#include "core/study/StudyLoader.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SessionFiles.h"
#include "ui/frame/MessageBar.h"
#include "ui/window/MainWindow.h"

#include <QDir>
#include <QDropEvent>
#include <QFile>
#include <QImage>
#include <QMimeData>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>

namespace openSessionUiTest {

namespace {

constexpr int patience = 120000; ///< ms; only a hang takes that long

void write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qPrintable(path));
}

struct Outcome {
    int status = -1;
    QString complaint;
};

} // namespace

/// A session file that somebody names: found with its study, or refused in words and left as it is.
class OpenSessionUiTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QByteArray m_hash; ///< at the session's position
    core::RowId m_position = 0;

    QString path(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    QString session() const { return path("case/s.burin"); }

    Outcome open(const QStringList& arguments) const
    {
        QProcess process;
        process.start(QStringLiteral(BURIN_PROGRAM),
            QStringList{QStringLiteral("open")} + arguments
                + QStringList{QStringLiteral("--screenshot"), path("shot.png"),
                    QStringLiteral("--size"), QStringLiteral("900x600")});
        process.waitForFinished(patience);
        return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            QString::fromUtf8(process.readAllStandardError())};
    }
    /// The lines that Burin itself wrote.
    static QStringList complaints(const Outcome& outcome)
    {
        return outcome.complaint.split(u'\n').filter(QStringLiteral("burin open:"));
    }

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        for (const char* name : {"XDG_STATE_HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME"})
            qputenv(name, path(name).toUtf8());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, path("settings"));
        test::writeSmallSeries(path("case/ct"), "2.25.1");
        reference::ReferenceEngine oracle;
        const auto made = *core::EditSession::create(
            oracle, *core::loadVolume(path("case/ct")), {.file = session()});
        for (const core::Edit& edit : test::manyEdits())
            QVERIFY(made->apply(edit));
        QVERIFY(made->settle());
        QVERIFY(made->undo());
        QVERIFY(made->settle());
        m_hash = made->stateHash();
        m_position = made->history().position();
    }

    void continuesInTheWindow()
    {
        auto application = *app::Application::create();
        ui::MainWindow& window = application->window();
        window.resize(900, 600);
        window.show();
        // As if it were dropped from a file manager.
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(session())});
        QDragEnterEvent enter(
            QPoint(200, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(200, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window, &drop);
        QTRY_VERIFY_WITH_TIMEOUT(application->workspace().session(), patience);
        core::EditSession& opened = *application->workspace().session();
        QCOMPARE(opened.history().position(), m_position);
        QVERIFY(opened.history().canRedo());
        QVERIFY(opened.settle());
        QCOMPARE(opened.stateHash(), m_hash);
        // It goes on in that file, not in the study's own session.
        QVERIFY(opened.undo());
        QVERIFY(opened.settle());
        const core::RowId position = opened.history().position();
        window.closeStudy();
        reference::ReferenceEngine oracle;
        const auto again =
            *core::EditSession::open(oracle, *core::loadVolume(path("case/ct")), session());
        QCOMPARE(again->history().position(), position);
        QVERIFY(position != m_position);
    }

    void asksForAStudyThatIsGone()
    {
        QVERIFY(QDir().rename(path("case/ct"), path("moved")));
        test::writeSmallSeries(path("other"), "2.25.2");
        test::writeSmallSeries(path("tampered"), "2.25.1", 1);
        auto application = *app::Application::create();
        ui::MainWindow& window = application->window();
        ui::StudyOpener& opener = window.opener();
        window.show();
        QSignalSpy asked(&opener, &ui::StudyOpener::sessionStudyNeeded);
        const auto bar = [&window] { return window.messages().sentence(); };
        opener.open(session());
        QVERIFY(asked.wait(patience));
        QVERIFY2(bar().contains(QStringLiteral("s.burin: its study is no longer at")),
            qPrintable(bar()));
        QVERIFY(bar().contains(path("case/ct")));
        QCOMPARE(window.messages().findChild<QPushButton*>()->text(),
            QStringLiteral("Choose its study …"));
        // Another series, other voxels under the same name, nothing at all: refused, and asked on.
        const QByteArray untouched = test::bytesOf(session());
        const auto refused = [&](const QString& place, const char* why) {
            asked.clear();
            opener.openSession(session(), place);
            return asked.wait(patience) && bar().contains(QLatin1String(why))
                && !application->workspace().session() && test::bytesOf(session()) == untouched;
        };
        QVERIFY2(refused(path("other"), "no volume has its series and size"), qPrintable(bar()));
        QVERIFY2(refused(path("tampered"), "its voxels are others"), qPrintable(bar()));
        QVERIFY2(refused(path("none"), "no such file or folder"), qPrintable(bar()));
        opener.openSession(session(), path("moved"));
        QTRY_VERIFY_WITH_TIMEOUT(application->workspace().session(), patience);
        QCOMPARE(application->workspace().session()->history().position(), m_position);
    }

    void findsAStudyThatMovedWithIt()
    {
        QVERIFY(QDir().rename(path("case"), path("elsewhere")));
        QCOMPARE(open({path("elsewhere/s.burin")}).status, 0);
        QVERIFY(QImage(path("shot.png")).width() >= 900);
        // Session and study in folders beside each other.
        QVERIFY(QDir().mkpath(path("elsewhere/sessions")));
        const QString deeper = path("elsewhere/sessions/s.burin");
        QVERIFY(QFile::rename(path("elsewhere/s.burin"), deeper));
        const auto file = core::SessionFile::open(deeper, core::SessionFile::Access::ReadOnly);
        QCOMPARE(core::studyPlaces(deeper, (*file)->contents().source),
            QStringList{path("elsewhere/ct")});
    }

    void saysThatTheStudyIsGone()
    {
        QVERIFY(QDir().rename(path("case/ct"), path("moved")));
        const Outcome gone = open({session()});
        QCOMPARE(gone.status, 1);
        QCOMPARE(complaints(gone).size(), 1);
        QVERIFY2(gone.complaint.contains(
                     session() + QStringLiteral(": its study is no longer at ") + path("case/ct")),
            qPrintable(gone.complaint));
        QVERIFY(!QFile::exists(path("shot.png")));
        test::writeSmallSeries(path("other"), "2.25.2");
        const Outcome other = open({session(), QStringLiteral("--study"), path("other")});
        QCOMPARE(other.status, 1);
        QVERIFY2(other.complaint.contains(QStringLiteral("no volume has its series and size")),
            qPrintable(other.complaint));
        const Outcome told = open({session(), QStringLiteral("--study"), path("moved")});
        QVERIFY2(told.status == 0, qPrintable(told.complaint));
        QVERIFY(QFile::exists(path("shot.png")));
    }

    void refusesWhatIsNoSoundSession_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("words");
        const auto row = [](const char* kind, const char* words) {
            QTest::newRow(kind) << QString::fromLatin1(kind) << QString::fromLatin1(words);
        };
        row("empty", "cut short: it is empty");
        row("text", "it is no session of Burin");
        row("foreign database", "it is no session of Burin");
        row("newer", "a newer Burin wrote it (session format 99;");
        row("row changed",
            "row 2 'Something else' and the 9 after it cannot be read: it was changed");
    }

    void refusesWhatIsNoSoundSession()
    {
        QFETCH(QString, kind);
        QFETCH(QString, words);
        const QString file = path("case/bad.burin");
        QVERIFY(QFile::copy(session(), file));
        if (kind == QStringLiteral("empty"))
            write(file, {});
        else if (kind == QStringLiteral("text"))
            write(file, QByteArray(5000, 'x'));
        else if (kind == QStringLiteral("foreign database"))
            test::runSql(file, "PRAGMA application_id=1");
        else if (kind == QStringLiteral("newer"))
            test::runSql(file, "PRAGMA user_version=99");
        else
            test::runSql(file, "UPDATE row SET name='Something else' WHERE id=2");
        const QByteArray before = test::bytesOf(file);
        const Outcome outcome = open({file});
        QCOMPARE(outcome.status, 1);
        QCOMPARE(complaints(outcome).size(), 1);
        QVERIFY2(outcome.complaint.contains(file + QStringLiteral(":"))
                && outcome.complaint.contains(words),
            qPrintable(outcome.complaint));
        QVERIFY(!QFile::exists(path("shot.png")));
        QCOMPARE(test::bytesOf(file), before);
        // What was salvaged goes again, as nothing was done with it.
        QCOMPARE(QDir(path("case")).entryList({QStringLiteral("bad*")}, QDir::Files).size(), 1);
    }

    void refusesOptionsThatDoNotFit()
    {
        QCOMPARE(open({session(), QStringLiteral("--series"), QStringLiteral("1.2")}).status, 2);
        QCOMPARE(open({path("case/ct"), QStringLiteral("--study"), path("case")}).status, 2);
    }
};

BURIN_WINDOW_TEST(OpenSessionUiTest)

} // namespace openSessionUiTest

#include "OpenSessionUiTest.moc"
