// SPDX-License-Identifier: Apache-2.0
#include "app/Application.h"
#include "app/SessionFiles.h"
#include "core/session/EditSession.h"
#include "core/session/RowText.h"
#include "core/session/SessionFile.h"
#include "core/session/SessionUse.h"
#include "core/study/StudyLoader.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/FileSizeLimit.h"
#include "tests/support/SessionFiles.h"
#include "tests/support/SmallStudy.h"
#include "ui/MainWindow.h"
#include "ui/MessageBar.h"
#include "ui/ReadOnlyMark.h"
#include "ui/RecentStudies.h"
#include "ui/SessionOffers.h"
#include "ui/SessionSaver.h"

#include <QApplication>
#include <QCheckBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QScopeGuard>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <optional>

namespace {

constexpr int patience = 120000; ///< ms; only a hang takes that long

/// Calls @p answer with every modal dialog that shows while it lives.
class Dialogs {
public:
    explicit Dialogs(std::function<void(QWidget&)> answer)
    {
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [answer = std::move(answer)] {
            if (QWidget* dialog = QApplication::activeModalWidget())
                answer(*dialog);
        });
        m_timer.start(50);
    }

private:
    QTimer m_timer;
};

void press(QWidget& dialog, const QString& text)
{
    for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
        if (button->text().remove(u'&') == text)
            return button->click();
    }
    qFatal("no button %s", qPrintable(text));
}

/// For people who want to look: the folder is named by BURIN_SCREENSHOTS.
void look(const QPixmap& picture, const char* name)
{
    const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
    if (!folder.isEmpty())
        QVERIFY(picture.save(QDir(folder).filePath(QLatin1String(name))));
}

} // namespace

/// What happens to a session file between windows, crashes and disks, in the real window.
class SessionLifeUiTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<app::Application> m_application;

    QString path(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    ui::MainWindow& window() { return m_application->window(); }
    ui::Workspace& workspace() { return m_application->workspace(); }
    core::EditSession& session() { return *workspace().session(); }
    QString bar() { return window().messages().sentence(); }
    QString mark() const
    {
        const auto* label = m_application->window().findChild<ui::ReadOnlyMark*>();
        return label->isVisible() ? label->text() : QString();
    }
    QStringList filesIn(const QString& folder, const char* filter = "*") const
    {
        return QDir(folder).entryList({QLatin1String(filter)}, QDir::Files | QDir::Hidden);
    }

    void start()
    {
        m_application.reset();
        m_application = *app::Application::create();
        window().resize(1280, 800);
        window().show();
        QVERIFY(QTest::qWaitForWindowExposed(&window()));
    }
    void open(const QString& what)
    {
        window().opener().open(what);
        QTRY_VERIFY_WITH_TIMEOUT(workspace().session(), patience);
    }
    void edit(const core::Edit& edit)
    {
        QVERIFY(session().apply(edit));
        QVERIFY(session().settle());
    }
    /// Ten steps, closed. @return how many
    static std::size_t writeSession(const QString& file, const QString& study)
    {
        reference::ReferenceEngine oracle;
        const auto made =
            *core::EditSession::create(oracle, *core::loadVolume(study), {.file = file});
        for (const core::Edit& each : test::manyEdits()) {
            static_cast<void>(made->apply(each));
            static_cast<void>(made->settle());
        }
        return made->history().rows().size();
    }

private Q_SLOTS:
    void initTestCase() { QApplication::setAttribute(Qt::AA_DontUseNativeDialogs); }
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        for (const char* name : {"XDG_STATE_HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME"})
            qputenv(name, path(name).toUtf8());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, path("settings"));
        test::writeSmallSeries(path("case/ct"), "2.25.1", 0, "Head, bone 1.0");
        start();
    }
    void cleanup() { m_application.reset(); }

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
        QTest::qWait(200); // for the layout
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
        QVERIFY(bar().isEmpty());
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
        QTest::qWait(500);
        const QByteArray before = test::fingerprint(file);
        open(file);
        QCOMPARE(mark(), QStringLiteral("Read-only: open in another window"));
        QVERIFY(window().windowTitle().contains(QStringLiteral("(read-only)")));
        QVERIFY2(
            bar().contains(QStringLiteral("s.burin is open in another window")), qPrintable(bar()));
        QTest::qWait(1500);
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
        QVERIFY(QFile::setPermissions(m_folder->path(), QFileDevice::Permissions(0x7555)));
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
                if (!replace && asked > 0)
                    return choice->reject();
                auto* name = choice->findChild<QLineEdit*>();
                suggested = suggested.isEmpty() ? name->text() : suggested;
                name->setText(target);
                QMetaObject::invokeMethod(choice, "accept", Qt::QueuedConnection);
            }
        });
        window().actionTable()[QStringLiteral("file.saveAs")].trigger();
        QCOMPARE(asked, 1);
        QCOMPARE(suggested, QStringLiteral("Head, bone 1.0.burin"));
        QCOMPARE(test::fingerprint(target), before);
        QCOMPARE(session().file(), working);
        replace = true;
        QSignalSpy saved(&workspace(), &ui::Workspace::sessionSaved);
        window().actionTable()[QStringLiteral("file.saveAs")].trigger();
        QCOMPARE(asked, 2);
        QVERIFY(saved.count() == 1 || saved.wait(patience));
        QCOMPARE(session().file(), target);
        QVERIFY(!QFileInfo::exists(working));
        QVERIFY(filesIn(app::sessionFolder()).isEmpty());
        QCOMPARE(ui::RecentStudies::paths().value(0), target);
        edit(test::drillAt(3));
        window().closeStudy();
        open(target);
        QCOMPARE(session().history().rows().size(), std::size_t(2));
        window().closeStudy();
        open(path("case/ct"));
        QCOMPARE(session().history().rows().size(), std::size_t(0));
    }

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
        QSignalSpy saved(&workspace(), &ui::Workspace::sessionSaved);
        window().saveSessionAs();
        QVERIFY(saved.count() == 1 || saved.wait(patience));
        QVERIFY(!ticked);
        QVERIFY2(hint.contains(QStringLiteral("identifies the patient, travel with the file")),
            qPrintable(hint));
        look(picture, "save-with-images.png");
        QCOMPARE(session().file(), path("with.burin"));
        QVERIFY(session().holdsImages());
        window().closeStudy();

        QVERIFY(QDir().rename(path("case/ct"), path("case/gone")));
        open(path("with.burin"));
        QVERIFY(session().settle());
        QCOMPARE(session().stateHash(), hash);
        QCOMPARE(workspace().volume()->voxelsSha256, voxels);
        QVERIFY2(bar().contains(QStringLiteral("The study is no longer at ")), qPrintable(bar()));
        QVERIFY2(bar().contains(QStringLiteral("Its images are taken from with.burin")),
            qPrintable(bar()));
        QTest::qWait(2000);
        look(window().grab(), "images-from-session.png");
        edit(test::drillAt(3));

        // Without them again, as the user likes.
        include = false;
        window().saveSessionAs();
        QVERIFY(saved.count() == 2 || saved.wait(patience));
        QVERIFY(ticked);
        QVERIFY2(hint.contains(QStringLiteral("The study is not at hand")), qPrintable(hint));
        look(picture, "save-without-images.png");
        QVERIFY(!session().holdsImages());
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
        QCOMPARE(QDir(m_folder->path())
                     .entryList({QStringLiteral("*.burin"), QStringLiteral(".burin*")},
                         QDir::Files | QDir::Hidden),
            QStringList());
    }

    void theOpenStudyOpensAgain()
    {
        open(path("case/ct"));
        edit(test::drillAt(0));
        QSignalSpy changed(&workspace(), &ui::Workspace::sessionChanged);
        window().opener().open(path("case/ct"));
        QTRY_COMPARE_WITH_TIMEOUT(changed.count(), 2, patience); // closed, opened
        QCOMPARE(session().history().rows().size(), std::size_t(1));
        QVERIFY(bar().isEmpty());
    }

    void aPlaceThatCannotBeWrittenChangesNothing()
    {
        open(path("case/ct"));
        edit(test::drillAt(0));
        const QString working = session().file();
        QSignalSpy failed(&workspace(), &ui::Workspace::failed);
        ui::SessionSaver(workspace(), window()).save({.target = path("no/such/mine.burin")});
        QVERIFY(failed.wait(patience));
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
        m_application.reset();
        for (const char* suffix : {"", "-wal"}) {
            QFile::remove(working + QLatin1String(suffix));
            QVERIFY(QFile::rename(left + QLatin1String(suffix), working + QLatin1String(suffix)));
        }
        const QByteArray before =
            test::fingerprint(working) + test::fingerprint(working + QStringLiteral("-wal"));
        start();
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

    /// The question's way out: the steps go to another place, and what was asked goes on.
    void unwrittenStepsAreSavedElsewhere()
    {
        const QString file = path("case/s.burin");
        writeSession(file, path("case/ct"));
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
            session().setSegmentVisible(1, i % 2 == 1);
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
            for (const QString& each : {m_folder->path(), path("case"), path("case/ct")})
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
        QTest::qWait(1500);
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

QTEST_MAIN(SessionLifeUiTest)
#include "SessionLifeUiTest.moc"
