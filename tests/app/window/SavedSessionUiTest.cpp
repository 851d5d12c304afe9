// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "core/session/SessionDisplay.h"
#include "core/session/SessionStorage.h"
#include "tests/support/faults/FileSizeLimit.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SessionFiles.h"
#include "ui/dialogs/session/SessionSaver.h"
#include "ui/views/ViewGrid.h"

#include <QApplication>
#include <QCheckBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>

#include <optional>

namespace savedSessionUiTest {

using test::Dialogs;
using test::look;
using test::press;

/// "Save session as …": with the study's images, for steps that are on no disk, and for sessions
/// that could not get a file, in the real window.
class SavedSessionUiTest : public QObject, test::WithApplication {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QApplication::setAttribute(Qt::AA_DontUseNativeDialogs); }
    void init() { makeApplication(); }
    void cleanup() { dropApplication(); }

    void imagesTravelWithTheSession()
    {
        open(path("case/ct"));
        edit(test::drillAt(0));
        const QByteArray hash = session().stateHash();
        const QByteArray voxels = workspace().volume()->voxelsSha256;
        bool include = true;
        bool ticked = false;
        QString hint;
        QPixmap picture;
        const Dialogs dialogs([&](QWidget& dialog) {
            auto* choice = qobject_cast<QFileDialog*>(&dialog);
            if (!choice)
                return;
            auto* images = choice->findChild<QCheckBox*>(QStringLiteral("includeImages"));
            ticked = images->isChecked();
            images->setChecked(include);
            choice->findChild<QLineEdit*>()->setText(
                include ? path("with.burin") : path("without.burin"));
            hint.clear();
            for (const QLabel* label : choice->findChildren<QLabel*>())
                hint += label->text() + u'\n';
            QApplication::processEvents();
            picture = choice->grab();
            QMetaObject::invokeMethod(choice, "accept", Qt::QueuedConnection);
        });
        QPixmap saving;
        const QObject whileSaving;
        connect(window().findChild<ui::SessionSaver*>(), &ui::SessionSaver::imagesProgressed,
            &whileSaving, [&] { saving = window().grab(); });
        QSignalSpy saved(&workspace(), &ui::Workspace::sessionSaved);
        window().saveSessionAs();
        QVERIFY(saved.count() == 1 || saved.wait(patience));
        QVERIFY(!ticked);
        QVERIFY(!saving.isNull());
        look(saving, "saving-images.png");
        QVERIFY2(hint.contains(QStringLiteral("identifies the patient, travel with the file")),
            qPrintable(hint));
        look(picture, "save-with-images.png");
        QCOMPARE(session().file(), path("with.burin"));
        QVERIFY(session().storage().holdsImages());
        window().closeStudy();

        QVERIFY(QDir().rename(path("case/ct"), path("case/gone")));
        QFile left(path("with.burin-wal.left"));
        QVERIFY(left.open(QIODevice::WriteOnly) && left.write("steps") == 5);
        left.close();
        open(path("with.burin"));
        QVERIFY(left.remove());
        QVERIFY(session().settle());
        QCOMPARE(session().stateHash(), hash);
        QCOMPARE(workspace().volume()->voxelsSha256, voxels);
        QVERIFY2(bar().contains(QStringLiteral("The study is no longer at ")), qPrintable(bar()));
        QVERIFY2(bar().contains(QStringLiteral("Its images are taken from with.burin")),
            qPrintable(bar()));
        // Neither hides the other.
        QVERIFY2(bar().contains(QStringLiteral("with.burin-wal.left' holds the last steps")),
            qPrintable(bar()));
        QTRY_VERIFY_WITH_TIMEOUT(window().views().refined(), patience);
        look(window().grab(), "images-from-session.png");
        edit(test::drillAt(3));

        // Without them again, as the user likes.
        include = false;
        window().saveSessionAs();
        QVERIFY(saved.count() == 2 || saved.wait(patience));
        QVERIFY(ticked);
        QVERIFY2(hint.contains(QStringLiteral("The study is not at hand")), qPrintable(hint));
        look(picture, "save-without-images.png");
        QVERIFY(!session().storage().holdsImages());
        window().closeStudy();
        QSignalSpy needed(&window().opener(), &ui::StudyOpener::sessionStudyNeeded);
        window().opener().open(path("without.burin"));
        QVERIFY(needed.wait(patience));

        // Where the images are damaged too, both are said, and the study can be named.
        QVERIFY(test::runSql(path("with.burin"), QStringLiteral("UPDATE pixels SET bytes=X'00'")));
        window().opener().open(path("with.burin"));
        QVERIFY(needed.wait(patience));
        QVERIFY2(bar().contains(QStringLiteral("piece 1 of 1 of its images was changed")),
            qPrintable(bar()));
        look(window().grab(), "images-damaged.png");
        window().opener().openSession(path("with.burin"), path("case/gone"));
        QTRY_VERIFY_WITH_TIMEOUT(workspace().session(), patience);
        QCOMPARE(session().history().rows().size(), std::size_t(2));
    }

    void imagesOfAStudyThatIsGoneAreNotSaved()
    {
        open(path("case/ct"));
        edit(test::drillAt(0));
        const QString working = session().file();
        QVERIFY(QDir().rename(path("case/ct"), path("case/gone")));
        QSignalSpy failed(&workspace(), &ui::Workspace::failed);
        ui::SessionSaver saver(workspace(), window());
        saver.save({.target = path("mine.burin"), .images = true});
        QVERIFY(failed.wait(patience));
        QVERIFY2(bar().contains(QStringLiteral("can be saved without them")), qPrintable(bar()));
        QCOMPARE(session().file(), working);
        QVERIFY(!QFile::exists(path("mine.burin")));

        // Cancelled, it leaves nothing either.
        QVERIFY(QDir().rename(path("case/gone"), path("case/ct")));
        std::optional<bool> saved;
        saver.save(
            {.target = path("mine.burin"), .images = true}, [&saved](bool done) { saved = done; });
        saver.cancel();
        QTRY_VERIFY_WITH_TIMEOUT(saved.has_value(), patience);
        QVERIFY(!*saved);
        QCOMPARE(session().file(), working);
        QCOMPARE(QDir(m_fixture->folder())
                     .entryList({QStringLiteral("*.burin"), QStringLiteral(".burin*")},
                         QDir::Files | QDir::Hidden),
            QStringList());
    }

    /// While images are still read for one place, the session may be saved at another one, and
    /// stays there.
    void aLaterPlaceCounts()
    {
        open(path("case/ct"));
        edit(test::drillAt(0));
        ui::SessionSaver saver(workspace(), window());
        QSignalSpy ended(&saver, &ui::SessionSaver::imagesEnded);
        std::optional<bool> first;
        std::optional<bool> second;
        saver.save(
            {.target = path("first.burin"), .images = true}, [&first](bool done) { first = done; });
        saver.save({.target = path("second.burin")}, [&second](bool done) { second = done; });
        QTRY_VERIFY_WITH_TIMEOUT(first && second, patience);
        QVERIFY(!*first);
        QVERIFY(*second);
        QCOMPARE(ended.size(), 1);
        QVERIFY(session().settle());
        QCOMPARE(session().file(), path("second.burin"));
        QVERIFY(!session().storage().holdsImages());
        QVERIFY(!QFile::exists(path("first.burin")));
    }

    void closingAsksWhileImagesAreSaved_data()
    {
        QTest::addColumn<QString>("answer");
        QTest::newRow("wait") << QStringLiteral("Wait");
        QTest::newRow("cancel") << QStringLiteral("Cancel saving");
        QTest::newRow("stay") << QStringLiteral("Stay");
    }
    void closingAsksWhileImagesAreSaved()
    {
        QFETCH(QString, answer);
        open(path("case/ct"));
        edit(test::drillAt(0));
        const QString target = path("mine.burin");
        QSignalSpy saved(&workspace(), &ui::Workspace::sessionSaved);
        int pressed = 0;
        QString words;
        // At once: the study is small.
        QTimer answers;
        connect(&answers, &QTimer::timeout, this, [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (!box)
                return;
            for (QPushButton* button : box->findChildren<QPushButton*>()) {
                if (button->text().remove(u'&') != answer)
                    continue;
                words = box->text();
                ++pressed;
                return button->click();
            }
        });
        answers.start(0);
        ui::SessionSaver& saver = window().saver();
        saver.save({.target = target, .images = true});
        QVERIFY(saver.saving());
        window().closeStudy();
        answers.stop();
        QCOMPARE(pressed, 1);
        QVERIFY2(words.contains(target), qPrintable(words));
        QCOMPARE(workspace().session() != nullptr, answer == QLatin1String("Stay"));
        if (answer == QLatin1String("Cancel saving")) {
            QVERIFY(!saver.saving());
            QTest::qWait(500);
            QCOMPARE(saved.size(), 0);
            QVERIFY(!QFile::exists(target));
            return;
        }
        QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, patience);
        QVERIFY(!saver.saving());
        if (answer == QLatin1String("Stay"))
            window().closeStudy();
        QVERIFY(!workspace().session());
        open(target);
        QVERIFY(session().storage().holdsImages());
        QCOMPARE(session().history().rows().size(), std::size_t(1));
    }

    void whatIsLeftOfAnotherSessionIsTold()
    {
        const QString file = path("case/s.burin");
        test::writeSession(file, path("case/ct"));
        QFile left(file + QStringLiteral("-wal.left"));
        QVERIFY(left.open(QIODevice::WriteOnly) && left.write("steps") == 5);
        left.close();
        open(file);
        QVERIFY2(bar().startsWith(QStringLiteral("s.burin is whole. '"))
                && bar().contains(QStringLiteral("/case/s.burin-wal.left' holds the last steps"))
                && bar().contains(QStringLiteral("nothing is lost by keeping it")),
            qPrintable(bar()));
        look(window().grab(), "left-beside.png");
        window().closeStudy();
        QVERIFY(left.exists());
        QVERIFY(left.remove());
        open(file);
        QVERIFY2(!bar().contains(QStringLiteral("wal.left")), qPrintable(bar()));
    }

    /// The question's way out: the steps go to another place, and what was asked goes on.
    void unwrittenStepsAreSavedElsewhere()
    {
        const QString file = path("case/s.burin");
        test::writeSession(file, path("case/ct"));
        open(file);
        const std::size_t rows = session().history().rows().size();
        int asked = 0;
        const Dialogs dialogs([&](QWidget& dialog) {
            if (auto* choice = qobject_cast<QFileDialog*>(&dialog)) {
                choice->findChild<QLineEdit*>()->setText(path("elsewhere.burin"));
                QMetaObject::invokeMethod(choice, "accept", Qt::QueuedConnection);
            } else if (qobject_cast<QMessageBox*>(&dialog)) {
                ++asked;
                press(dialog, QStringLiteral("Save session as …"));
            }
        });
        // The file is larger than a copy of it has to be: what is not written fits there.
        const QString beside = file + QStringLiteral("-wal");
        for (int i = 0; QFileInfo(beside).size() < 2 * QFileInfo(file).size(); ++i) {
            session().display().setSegmentVisible(1, i % 2 == 1);
            QVERIFY(session().settle());
        }
        {
            const test::FileSizeLimit limit(rlim_t(QFileInfo(beside).size()));
            QVERIFY(session().apply(test::drillAt(3)));
            QVERIFY(!session().settle());
            window().closeStudy();
        }
        QCOMPARE(asked, 1);
        QVERIFY(!workspace().session());
        open(path("elsewhere.burin"));
        QCOMPARE(session().history().rows().size(), rows + 1);
        window().closeStudy();
        open(file);
        QCOMPARE(session().history().rows().size(), rows);
    }

    void aStudyOpensWhereNothingCanBeWritten_data()
    {
        QTest::addColumn<bool>("readOnly");
        QTest::newRow("a file in the folder's place") << false;
        QTest::newRow("a folder that nobody may write") << true;
    }
    void aStudyOpensWhereNothingCanBeWritten()
    {
        QFETCH(bool, readOnly);
        const QString state = path("state");
        qputenv("XDG_STATE_HOME", state.toUtf8());
        if (readOnly) {
            QVERIFY(QDir().mkpath(state + QStringLiteral("/burin/sessions")));
            QVERIFY(QFile::setPermissions(
                state + QStringLiteral("/burin/sessions"), QFileDevice::Permissions(0x5555)));
            for (const QString& each : {m_fixture->folder(), path("case"), path("case/ct")})
                QVERIFY(QFile::setPermissions(each, QFileDevice::Permissions(0x7777)));
        } else {
            QFile file(state);
            QVERIFY(file.open(QIODevice::WriteOnly));
        }
        std::optional<test::Unprivileged> nobody;
        if (readOnly)
            nobody.emplace();
        open(path("case/ct"));
        QVERIFY2(bar().contains(QStringLiteral("Steps stay in memory only")), qPrintable(bar()));
        QTRY_VERIFY_WITH_TIMEOUT(window().views().refined(), patience);
        if (!readOnly) // nobody may not write pictures either
            look(window().grab(), "no-state-folder.png");
        // Nothing done, nothing to ask.
        window().closeStudy();
        QVERIFY(!workspace().session());

        open(path("case/ct"));
        QVERIFY(session().apply(test::drillAt(0)));
        QVERIFY(!session().settle());
        QVERIFY2(bar().contains(QStringLiteral("Steps stay in memory only")), qPrintable(bar()));
        QVERIFY(session().undo());
        static_cast<void>(session().settle());
        QCOMPARE(session().history().position(), core::RowId(0));
        QVERIFY(session().redo());
        static_cast<void>(session().settle());
        const QByteArray hash = session().stateHash();
        QString words;
        QPixmap picture;
        QString answer = QStringLiteral("Stay");
        const Dialogs dialogs([&](QWidget& dialog) {
            if (auto* choice = qobject_cast<QFileDialog*>(&dialog)) {
                choice->findChild<QLineEdit*>()->setText(path("mine.burin"));
                QMetaObject::invokeMethod(choice, "accept", Qt::QueuedConnection);
            } else if (auto* question = qobject_cast<QMessageBox*>(&dialog)) {
                words = question->text() + question->informativeText();
                picture = dialog.grab();
                press(dialog, answer);
            }
        });
        window().closeStudy();
        QVERIFY(workspace().session());
        QVERIFY2(words.contains(QStringLiteral("in memory only")), qPrintable(words));
        QVERIFY2(!words.contains(QStringLiteral("within seconds")), qPrintable(words));
        if (!readOnly)
            look(picture, "in-memory.png");

        QSignalSpy saved(&workspace(), &ui::Workspace::sessionSaved);
        window().saveSessionAs();
        QVERIFY(saved.count() == 1 || saved.wait(patience));
        QCOMPARE(session().file(), path("mine.burin"));
        QVERIFY(bar().isEmpty());
        edit(test::drillAt(3));
        words.clear();
        window().closeStudy();
        QCOMPARE(words, QString());
        open(path("mine.burin"));
        QCOMPARE(session().history().rows().size(), std::size_t(2));
        QVERIFY(session().undo());
        QVERIFY(session().settle());
        QCOMPARE(session().stateHash(), hash);
    }
};

BURIN_WINDOW_TEST(SavedSessionUiTest)

} // namespace savedSessionUiTest

#include "SavedSessionUiTest.moc"
