// SPDX-License-Identifier: Apache-2.0
#include "app/steps/SessionFiles.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/database/SessionUse.h"
#include "core/sessionfile/records/RowText.h"
#include "tests/support/faults/FileSizeLimit.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SessionFiles.h"
#include "ui/dialogs/session/SessionSaver.h"
#include "ui/frame/ReadOnlyMark.h"
#include "ui/frame/SessionOffers.h"
#include "ui/settings/RecentStudies.h"
#include "ui/views/ViewGrid.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QTest>

#include <optional>

namespace sessionLifeUiTest {

using test::Dialogs;
using test::look;
using test::press;
using test::writeSession;

/// What happens to a session file between windows, crashes and disks, in the real window.
class SessionLifeUiTest : public QObject, test::WithApplication {
    Q_OBJECT

private:
    QString mark() const
    {
        const auto* label = window().findChild<ui::ReadOnlyMark*>();
        return label->isVisible() ? label->text() : QString();
    }
    QStringList filesIn(const QString& folder, const char* filter = "*") const
    {
        return QDir(folder).entryList({QLatin1String(filter)}, QDir::Files | QDir::Hidden);
    }

private Q_SLOTS:
    void initTestCase() { QApplication::setAttribute(Qt::AA_DontUseNativeDialogs); }
    void init() { makeApplication(); }
    void cleanup() { dropApplication(); }

    /// A file manager renames the file that is open, and somebody empties the folder.
    void whereItGoesOnIsTold()
    {
        const QString file = path("case/s.burin");
        const QString renamed = path("case/mine.burin");
        const std::size_t rows = writeSession(file, path("case/ct"));
        open(file);
        QVERIFY(QFile::rename(file, renamed));
        edit(test::drillAt(3));
        QTRY_VERIFY2(bar().contains(
                         renamed + QStringLiteral(": another program renamed or moved 's.burin'")),
            qPrintable(bar()));
        look(window().grab(), "session-renamed.png");
        QCOMPARE(session().file(), renamed);
        QCOMPARE(ui::RecentStudies::paths().value(0), renamed);

        // Noticed without a step, too, and without the picture that is kept of the last one.
        QVERIFY(test::waitUntilDrawn(window(), workspace()));
        QVERIFY(session().settle());
        QVERIFY(QFile::rename(renamed, file));
        QTRY_VERIFY2_WITH_TIMEOUT(
            bar().contains(file + QStringLiteral(": another program renamed or moved")),
            qPrintable(bar()), patience);
        QVERIFY(QFile::remove(file));
        edit(test::drillAt(5));
        QTRY_VERIFY2(bar().contains(file + QStringLiteral(": another program deleted it")),
            qPrintable(bar()));
        QCOMPARE(session().file(), file);
        window().closeStudy();
        QCOMPARE(filesIn(path("case")), QStringList{QStringLiteral("s.burin")});
        open(file);
        QCOMPARE(session().history().rows().size(), rows + 2);
    }

    /// Renamed just before it is closed.
    void whereItWasClosedIsFoundAgain()
    {
        const QString file = path("case/s.burin");
        const QString renamed = path("case/mine.burin");
        writeSession(file, path("case/ct"));
        open(file);
        QVERIFY(QFile::rename(file, renamed));
        window().closeStudy();
        QVERIFY(!workspace().session());
        QCOMPARE(ui::RecentStudies::paths().value(0), renamed);
        QCOMPARE(filesIn(path("case")), QStringList{QStringLiteral("mine.burin")});
    }

    void aDamagedSessionGoesOnBesideIt()
    {
        const QString file = path("case/s.burin");
        const std::size_t rows = writeSession(file, path("case/ct"));
        QVERIFY(test::runSql(file, QStringLiteral("UPDATE row SET name='Torn' WHERE id=7")));
        const QByteArray before = test::fingerprint(file);
        open(file);
        QCOMPARE(session().history().rows().size(), std::size_t(6));
        QCOMPARE(session().history().position(), core::RowId(6));
        const QString beside = path("case/s (recovered).burin");
        QCOMPARE(session().file(), beside);
        QVERIFY2(bar().contains(QStringLiteral("s.burin: the session is damaged: row 7 'Torn' and "
                                               "the %1 after it cannot be read: it was changed")
                                    .arg(rows - 7)),
            qPrintable(bar()));
        QVERIFY2(bar().contains(QStringLiteral("The 6 rows before it are open in s (recovered)")),
            qPrintable(bar()));
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        look(window().grab(), "damaged.png");
        // Nothing was done: it leaves nothing.
        window().closeStudy();
        QCOMPARE(filesIn(path("case")), QStringList{QStringLiteral("s.burin")});
        open(file);
        edit(test::drillAt(0));
        window().closeStudy();
        QCOMPARE(test::fingerprint(file), before);
        const auto kept = core::SessionFile::open(beside, core::SessionFile::Access::ReadOnly);
        QVERIFY(kept);
        QCOMPARE((*kept)->contents().rows.size(), std::size_t(7));
        // And what was done then is not replaced by a later look.
        open(file);
        QCOMPARE(session().file(), path("case/s (recovered 2).burin"));
    }

    void aDamagedWorkingSessionMakesWay_data()
    {
        QTest::addColumn<QString>("sql");
        QTest::addColumn<int>("rows");
        QTest::addColumn<QString>("words");
        QTest::newRow("row") << QStringLiteral("UPDATE row SET name='X' WHERE id=3") << 2
                             << QStringLiteral("row 3 'X' and the one after it cannot be read");
        QTest::newRow("difference")
            << QStringLiteral("DELETE FROM delta WHERE row=3") << 4
            << QStringLiteral("it was carried out again and came to the same. Nothing is lost");
    }
    void aDamagedWorkingSessionMakesWay()
    {
        QFETCH(QString, sql);
        QFETCH(int, rows);
        QFETCH(QString, words);
        open(path("case/ct"));
        const QString file = session().file();
        for (int i = 0; i < 4; ++i)
            edit(test::drillAt(2.0 * i - 3.0));
        const QByteArray hash = session().stateHash();
        window().closeStudy();
        QVERIFY(test::runSql(file, sql));
        const QByteArray before = test::fingerprint(file);
        open(path("case/ct"));
        QCOMPARE(session().file(), file);
        QCOMPARE(int(session().history().rows().size()), rows);
        if (rows == 4)
            QCOMPARE(session().stateHash(), hash);
        QVERIFY2(bar().contains(words), qPrintable(bar()));
        window().closeStudy();
        const QStringList aside = filesIn(app::sessionFolder(), "*.damaged-*");
        QCOMPARE(aside.size(), 1);
        QCOMPARE(test::fingerprint(QDir(app::sessionFolder()).filePath(aside.first())), before);
        open(path("case/ct"));
        QCOMPARE(int(session().history().rows().size()), rows);
        QTRY_VERIFY_WITH_TIMEOUT(
            bar().startsWith(QStringLiteral("This study was worked on before")), patience);
    }

    /// A hash that its edit does not come to: what cannot be carried out again is lost after all.
    void whatDoesNotComeToItsHashIsLost()
    {
        const QString file = path("case/s.burin");
        writeSession(file, path("case/ct"));
        const QString chain = test::text(file, QStringLiteral("SELECT chain FROM row WHERE id=7"));
        const QString hash(64, u'7');
        const QString deltaHash =
            test::text(file, QStringLiteral("SELECT deltaSha256 FROM row WHERE id=7"));
        QVERIFY(test::runSql(file,
            QStringLiteral("UPDATE row SET stateHash='%1', seal='%2' WHERE id=7")
                .arg(hash, core::seal(chain, hash, deltaHash))));
        QVERIFY(test::runSql(file, QStringLiteral("DELETE FROM delta WHERE row=7")));
        const QByteArray before = test::fingerprint(file);
        open(file);
        QCOMPARE(session().history().rows().size(), std::size_t(6));
        QCOMPARE(session().file(), path("case/s (recovered).burin"));
        QVERIFY2(bar().contains(QStringLiteral("row 7 'Grow")), qPrintable(bar()));
        QCOMPARE(test::fingerprint(file), before);
        QCOMPARE(filesIn(path("case"), "*.burin").size(), 2);
    }

    void theSecondWindowOnlyLooks()
    {
        const QString file = path("case/s.burin");
        const std::size_t rows = writeSession(file, path("case/ct"));
        QProcess first;
        first.start(QStringLiteral(BURIN_PROGRAM), {QStringLiteral("open"), file});
        const auto end = qScopeGuard([&first] {
            first.kill();
            first.waitForFinished();
        });
        QTRY_VERIFY_WITH_TIMEOUT(core::isSessionInUse(file), patience);
        // The other program tells nobody when it has written what it writes on opening.
        QTest::qWait(500);
        const QByteArray before = test::fingerprint(file);
        open(file);
        QCOMPARE(mark(), QStringLiteral("Read-only: open in another window"));
        QVERIFY(window().windowTitle().contains(QStringLiteral("(read-only)")));
        QVERIFY2(
            bar().contains(QStringLiteral("s.burin is open in another window")), qPrintable(bar()));
        QTRY_VERIFY_WITH_TIMEOUT(window().views().refined(), patience);
        look(window().grab(), "second-window.png");
        QCOMPARE(session().history().rows().size(), rows);
        const auto refused = session().apply(test::drillAt(0));
        QCOMPARE(refused.error().code, core::ErrorCode::SessionReadOnly);
        QVERIFY(session().undo());
        QVERIFY(session().settle());
        QCOMPARE(session().history().position(), core::RowId(rows - 1));
        QCOMPARE(test::fingerprint(file), before);

        QSignalSpy saved(&workspace(), &ui::Workspace::sessionSaved);
        ui::SessionSaver(workspace(), window()).save({.target = path("mine.burin")});
        QVERIFY(saved.wait(patience));
        QCOMPARE(mark(), QString());
        QVERIFY(!window().windowTitle().contains(QStringLiteral("(read-only)")));
        edit(test::drillAt(0));
        QCOMPARE(session().history().rows().size(), rows + 1);
        QCOMPARE(test::fingerprint(file), before);
        QCOMPARE(first.state(), QProcess::Running);
    }

    void aFolderThatCannotBeWrittenIsLookedAt()
    {
        const QString file = path("case/s.burin");
        const std::size_t rows = writeSession(file, path("case/ct"));
        QVERIFY(QFile::setPermissions(m_fixture->folder(), QFileDevice::Permissions(0x7555)));
        QVERIFY(QFile::setPermissions(path("case"), QFileDevice::Permissions(0x5555)));
        QVERIFY(QFile::setPermissions(file, QFileDevice::Permissions(0x4444)));
        const auto reset = qScopeGuard(
            [this] { QFile::setPermissions(path("case"), QFileDevice::Permissions(0x7555)); });
        const QByteArray before = test::fingerprint(file);
        const test::Unprivileged nobody;
        open(file);
        QCOMPARE(mark(), QStringLiteral("Read-only: its folder cannot be written"));
        QCOMPARE(session().history().rows().size(), rows);
        QCOMPARE(session().apply(test::drillAt(0)).error().code, core::ErrorCode::SessionReadOnly);
        window().closeStudy();
        QCOMPARE(test::fingerprint(file), before);
        QCOMPARE(filesIn(path("case")), QStringList{QStringLiteral("s.burin")});
    }

    void saveAsMovesAWorkingSession()
    {
        open(path("case/ct"));
        const QString working = session().file();
        QVERIFY(app::isWorkingSession(working));
        edit(test::drillAt(0));
        const QString target = path("mine.burin");
        QFile other(target);
        QVERIFY(other.open(QIODevice::WriteOnly));
        other.write("something else");
        other.close();
        const QByteArray before = test::fingerprint(target);
        // The dialog asks before it replaces a file: no, then yes.
        bool replace = false;
        int asked = 0;
        QString suggested;
        const Dialogs dialogs([&](QWidget& dialog) {
            if (auto* question = qobject_cast<QMessageBox*>(&dialog)) {
                ++asked;
                question->button(replace ? QMessageBox::Yes : QMessageBox::No)->click();
            } else if (auto* choice = qobject_cast<QFileDialog*>(&dialog)) {
                auto* name = choice->findChild<QLineEdit*>();
                suggested = suggested.isEmpty() ? name->text() : suggested;
                if (!replace && asked > 0)
                    return choice->reject();
                name->setText(target);
                QMetaObject::invokeMethod(choice, "accept", Qt::QueuedConnection);
            }
        });
        window().actionTable()[QStringLiteral("file.saveAs")].trigger();
        QCOMPARE(asked, 1);
        QCOMPARE(suggested, QStringLiteral("Head, bone 1.0.burin"));
        QCOMPARE(test::fingerprint(target), before);
        QCOMPARE(session().file(), working);
        // What is no session stays, whatever was answered.
        replace = true;
        QSignalSpy saved(&workspace(), &ui::Workspace::sessionSaved);
        window().actionTable()[QStringLiteral("file.saveAs")].trigger();
        QCOMPARE(asked, 2);
        QTRY_VERIFY2_WITH_TIMEOUT(
            bar().contains(target + QStringLiteral(": cannot be written: it is no session")),
            qPrintable(bar()), patience);
        QCOMPARE(saved.count(), 0);
        QCOMPARE(test::fingerprint(target), before);
        QCOMPARE(session().file(), working);
        QVERIFY(QFile::remove(target));
        writeSession(target, path("case/ct"));
        window().actionTable()[QStringLiteral("file.saveAs")].trigger();
        QCOMPARE(asked, 3);
        QVERIFY(saved.count() == 1 || saved.wait(patience));
        QCOMPARE(session().file(), target);
        QVERIFY(!QFileInfo::exists(working));
        QVERIFY(filesIn(app::sessionFolder()).isEmpty());
        QCOMPARE(ui::RecentStudies::paths().value(0), target);
        // Saved elsewhere, it is suggested the name that it has.
        suggested.clear();
        replace = false;
        window().actionTable()[QStringLiteral("file.saveAs")].trigger();
        QCOMPARE(suggested, QStringLiteral("mine.burin"));
        edit(test::drillAt(3));
        window().closeStudy();
        open(target);
        QCOMPARE(session().history().rows().size(), std::size_t(2));
        window().closeStudy();
        open(path("case/ct"));
        QCOMPARE(session().history().rows().size(), std::size_t(0));
    }

    void theOpenStudyOpensAgain()
    {
        open(path("case/ct"));
        edit(test::drillAt(0));
        QSignalSpy changed(&workspace(), &ui::Workspace::sessionChanged);
        window().opener().open(path("case/ct"));
        QTRY_COMPARE_WITH_TIMEOUT(changed.count(), 2, patience); // closed, opened
        QCOMPARE(session().history().rows().size(), std::size_t(1));
        QTRY_VERIFY_WITH_TIMEOUT(bar().contains(QStringLiteral("goes on with 1 step.")), patience);
    }

    /// A study that was open before goes on, and says so; whoever wants none of that begins anew,
    /// and loses nothing.
    void aStudyThatWasOpenBeforeSaysSo()
    {
        open(path("case/ct"));
        QVERIFY(bar().isEmpty());
        edit(test::drillAt(0));
        edit(test::drillAt(6));
        const QString working = session().file();
        const QByteArray hash = session().stateHash();
        window().closeStudy();
        open(path("case/ct"));
        QCOMPARE(session().history().rows().size(), std::size_t(2));
        QTRY_VERIFY_WITH_TIMEOUT(
            bar().contains(QStringLiteral("its session goes on with 2 steps")), patience);
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        look(window().grab(), "goes-on.png");
        // Who goes on has chosen: the offer goes.
        edit(test::drillAt(-6));
        QTRY_VERIFY_WITH_TIMEOUT(bar().isEmpty(), patience);
        window().actionTable()[QStringLiteral("edit.undo")].trigger();
        QVERIFY(session().settle());
        window().closeStudy();
        open(path("case/ct"));
        QTRY_VERIFY_WITH_TIMEOUT(
            bar().contains(QStringLiteral("its session goes on with 3 steps")), patience);
        QSignalSpy changed(&workspace(), &ui::Workspace::sessionChanged);
        press(window(), QStringLiteral("Begin anew"));
        QTRY_COMPARE_WITH_TIMEOUT(changed.count(), 2, patience); // closed, opened
        QCOMPARE(session().history().rows().size(), std::size_t(0));
        QCOMPARE(session().file(), working);
        edit(test::drillAt(0));
        window().closeStudy();
        // The one before lies beside it, as it was.
        QStringList files = filesIn(QFileInfo(working).path(), "*.burin");
        QCOMPARE(files.size(), 2);
        files.removeAll(QFileInfo(working).fileName());
        open(QFileInfo(working).dir().filePath(files.front()));
        QCOMPARE(session().history().rows().size(), std::size_t(3));
        QCOMPARE(session().stateHash(), hash);
    }

    void aPlaceThatCannotBeWrittenChangesNothing()
    {
        open(path("case/ct"));
        edit(test::drillAt(0));
        const QString working = session().file();
        QSignalSpy failed(&workspace(), &ui::Workspace::failed);
        QSignalSpy said(&workspace(), &ui::Workspace::said);
        ui::SessionSaver(workspace(), window()).save({.target = path("no/such/mine.burin")});
        QCOMPARE(said.back()[0].toString(), QStringLiteral("Saving the session …"));
        QVERIFY(failed.wait(patience));
        QVERIFY2(said.back()[0].toString().startsWith(QStringLiteral("The session was not saved")),
            qPrintable(said.back()[0].toString()));
        QVERIFY2(
            bar().contains(QStringLiteral("mine.burin: cannot be written")), qPrintable(bar()));
        QCOMPARE(session().file(), working);
        edit(test::drillAt(3));
        QCOMPARE(session().history().rows().size(), std::size_t(2));
    }

    void aCrashedSessionIsOfferedAndGoesOn()
    {
        open(path("case/ct"));
        for (int i = 0; i < 3; ++i)
            edit(test::drillAt(2.0 * i - 2.0));
        const QString working = session().file();
        // What a crash would leave now.
        const QString left = path("left.burin");
        for (const char* suffix : {"", "-wal"})
            QVERIFY(QProcess::execute(QStringLiteral("cp"),
                        {working + QLatin1String(suffix), left + QLatin1String(suffix)})
                == 0);
        const QByteArray hash = session().stateHash();
        m_fixture->close();
        for (const char* suffix : {"", "-wal"}) {
            QFile::remove(working + QLatin1String(suffix));
            QVERIFY(QFile::rename(left + QLatin1String(suffix), working + QLatin1String(suffix)));
        }
        const QByteArray before =
            test::fingerprint(working) + test::fingerprint(working + QStringLiteral("-wal"));
        m_fixture->start();
        auto* offers = window().findChild<ui::SessionOffers*>();
        QTRY_COMPARE_WITH_TIMEOUT(offers->count(), 1, patience);
        QCOMPARE(test::fingerprint(working) + test::fingerprint(working + QStringLiteral("-wal")),
            before);
        const auto words = [offers] {
            QStringList list;
            for (const QLabel* label : offers->findChildren<QLabel*>())
                list += label->text();
            return list.join(u'\n');
        };
        const QString all = words();
        QVERIFY2(all.contains(QStringLiteral("Head, bone 1.0 · CT")), qPrintable(all));
        QVERIFY2(all.contains(QStringLiteral("recovered: 3 steps, last at ")), qPrintable(all));
        look(window().grab(), "offer-one.png");
        press(*offers, QStringLiteral("Open"));
        QTRY_VERIFY_WITH_TIMEOUT(workspace().session(), patience);
        QCOMPARE(session().history().rows().size(), std::size_t(3));
        QVERIFY(session().settle());
        QCOMPARE(session().stateHash(), hash);
        window().closeStudy();
        // Closed in order it is no longer something that had to be recovered.
        QTRY_VERIFY_WITH_TIMEOUT(
            words().contains(QStringLiteral("continue: 3 steps, last at ")), patience);
    }

    void stepsThatAreOnNoDiskAreAskedAbout()
    {
        test::writeSmallSeries(path("case/other"), "2.25.2", 1);
        open(path("case/ct"));
        edit(test::drillAt(0));
        QString answer = QStringLiteral("Stay");
        int asked = 0;
        QString words;
        QPixmap picture;
        const Dialogs dialogs([&](QWidget& dialog) {
            auto* question = qobject_cast<QMessageBox*>(&dialog);
            if (!question)
                return;
            ++asked;
            words = question->text() + question->informativeText();
            picture = dialog.grab();
            press(dialog, answer);
        });
        {
            const test::FileSizeLimit limit(1);
            QVERIFY(session().apply(test::drillAt(3)));
            QVERIFY(!session().settle());
            window().closeStudy();
            QCOMPARE(asked, 1);
            QVERIFY2(
                words.contains(QStringLiteral("They are lost if you go on")), qPrintable(words));
            QVERIFY(workspace().session());
            // Nor does another study take its place.
            QSignalSpy finished(&window().opener(), &ui::StudyOpener::finished);
            window().opener().open(path("case/other"));
            QVERIFY(finished.wait(patience));
            QCOMPARE(asked, 2);
            QCOMPARE(session().history().rows().size(), std::size_t(2));
            QCOMPARE(workspace().volume()->identity.seriesUid, QStringLiteral("2.25.1"));
            window().close();
            QCOMPARE(asked, 3);
            QVERIFY(window().isVisible());
            answer = QStringLiteral("Go on and lose them");
            window().closeStudy();
            QCOMPARE(asked, 4);
            QVERIFY(!workspace().session());
        }
        look(picture, "unwritten.png");
        open(path("case/ct"));
        QCOMPARE(session().history().rows().size(), std::size_t(1));
    }

    /// By a signal, say, when nobody can be asked.
    void aProgramThatIsToldToEndSaysWhatIsLost()
    {
        open(path("case/ct"));
        edit(test::drillAt(0));
        std::optional<core::Error> lost;
        int heard = 0;
        {
            const test::FileSizeLimit limit(1);
            QVERIFY(session().apply(test::drillAt(3)));
            session().questions().afterAll([&heard] { ++heard; });
            lost = workspace().dropSession();
        }
        QCOMPARE(heard, 0); // whoever asked may be gone
        QVERIFY(lost);
        QCOMPARE(lost->code, core::ErrorCode::FileUnwritable);
        m_fixture->close();
        m_fixture->start();
        open(path("case/ct"));
        QCOMPARE(session().history().rows().size(), std::size_t(1));
        // With room for it, nothing is.
        QVERIFY(session().apply(test::drillAt(3)));
        QVERIFY(!workspace().dropSession());
    }

    void aStepUnderWayIsAskedAbout_data()
    {
        QTest::addColumn<bool>("closesWindow");
        QTest::newRow("the study is closed") << false;
        QTest::newRow("the window is closed") << true;
    }

    /// Its row is made only after the closing has begun, on a disk that has no room by then.
    void aStepUnderWayIsAskedAbout()
    {
        QFETCH(bool, closesWindow);
        open(path("case/ct"));
        edit(test::drillAt(0));
        int asked = 0;
        const Dialogs dialogs([&asked](QWidget& dialog) {
            if (!qobject_cast<QMessageBox*>(&dialog))
                return;
            ++asked;
            press(dialog, QStringLiteral("Stay"));
        });
        {
            const test::FileSizeLimit limit(1);
            QVERIFY(session().apply(test::drillAt(3)));
            if (closesWindow)
                window().close();
            else
                window().closeStudy();
            QCOMPARE(asked, 1);
            QVERIFY(workspace().session());
            QVERIFY(window().isVisible());
            QCOMPARE(session().history().rows().size(), std::size_t(2));
        }
        window().closeStudy();
        QCOMPARE(asked, 1);
        QVERIFY(!workspace().session());
        open(path("case/ct"));
        QCOMPARE(session().history().rows().size(), std::size_t(2));
    }
};

BURIN_WINDOW_TEST(SessionLifeUiTest)

} // namespace sessionLifeUiTest

#include "SessionLifeUiTest.moc"
