// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/SessionSalvage.h"
#include "tests/support/faults/FileShim.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SessionFiles.h"
#include "ui/dialogs/session/SessionSaver.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QSignalSpy>
#include <QTest>

#include <cerrno>
#include <cstring>
#include <optional>

namespace failingSaveUiTest {

namespace {

constexpr const char* savedTo = "BURIN_SAVED_TO";
constexpr const char* toldReason = "BURIN_TOLD_REASON";

} // namespace

/// What the disk fails: a window whose session is saved under another name, twice. It checks what a
/// user reads.
class WindowOnFailingDisk : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void savesTwice()
    {
        const QString target = qEnvironmentVariable(savedTo);
        const QString reason = qEnvironmentVariable(toldReason);
        if (target.isEmpty())
            QSKIP("FailingSaveUiTest starts it");
        const QByteArray old = test::bytesOf(target);
        test::ApplicationFixture fixture;
        fixture.open(fixture.path("case/ct"));
        fixture.edit(test::drillAt(0));
        const QString working = fixture.session().file();
        auto* saver = new ui::SessionSaver(fixture.workspace(), fixture.window());
        QSignalSpy said(&fixture.workspace(), &ui::Workspace::said);
        const auto save = [&](bool images) {
            std::optional<bool> done;
            saver->save(
                {.target = target, .images = images}, [&done](bool saved) { done = saved; });
            if (!QTest::qWaitFor(
                    [&done] { return done.has_value(); }, test::ApplicationFixture::patience))
                return false;
            return *done;
        };
        const bool images = target.endsWith(QLatin1String("images.burin"));
        if (!reason.isEmpty()) {
            QVERIFY(!save(images));
            const QString bar = fixture.bar();
            QVERIFY2(bar.contains(QFileInfo(target).fileName()), qPrintable(bar));
            // SQLite has words of its own for a full disk.
            QVERIFY2(bar.contains(reason) || bar.contains(QStringLiteral("disk is full")),
                qPrintable(bar));
            const QString words = said.isEmpty() ? QString() : said.back()[0].toString();
            QVERIFY2(images || words.startsWith(QStringLiteral("The session was not saved there")),
                qPrintable(words));
            QCOMPARE(fixture.session().file(), working);
            QCOMPARE(test::bytesOf(target), old);
            QCOMPARE(QFile::exists(target), !old.isEmpty());
            QCOMPARE(QDir(QFileInfo(target).path())
                         .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot)
                         .size(),
                old.isEmpty() ? 0 : 1);
            // The disk is in order again.
            fixture.edit(test::drillAt(3));
        }
        QVERIFY2(save(images), qPrintable(fixture.bar()));
        QCOMPARE(fixture.session().file(), target);
        fixture.edit(test::drillAt(6));
        const core::HistoryRow last = fixture.session().history().rows().back();
        fixture.close();
        const auto contents = core::checkSession(target);
        QVERIFY(contents && contents->isWhole() && contents->leftOpen.isEmpty());
        QCOMPARE(contents->holdsImages, images);
        QCOMPARE(core::RowId(contents->rows.size()), last.id);
        QCOMPARE(contents->rows.back().stateHash, last.stateHash);
        QCOMPARE(QDir(QFileInfo(target).path())
                     .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
            QStringList{QFileInfo(target).fileName()});
    }
};

/// "Save session as …" in the window, on a disk that fails once: the window says which file and
/// why, goes on where it was, and saves there when the disk is in order again. All calls that can
/// fail: FailingSaveTest.
class FailingSaveUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theWindowSaysWhyAndGoesOn_data()
    {
        QTest::addColumn<QString>("target");
        QTest::addColumn<QByteArray>("call");
        QTest::addColumn<int>("number");
        QTest::addColumn<int>("error");
        const auto row = [](const char* target, const char* call, int number, int error) {
            QTest::addRow(
                "%s, %s %d: %s", target, call, number, error == 0 ? "short" : std::strerror(error))
                << QString::fromLatin1(target) << QByteArray(call) << number << error;
        };
        row("new.burin", "open", 1, EIO);
        row("new.burin", "write", 2, ENOSPC);
        row("new.burin", "sync", 1, EDQUOT);
        row("new.burin", "rename", 1, EIO);
        row("new.burin", "write", 2, 0);
        row("old.burin", "rename", 1, EDQUOT);
        row("images.burin", "write", 2, ENOSPC);
        row("images.burin", "rename", 1, EDQUOT);
    }
    void theWindowSaysWhyAndGoesOn()
    {
        QFETCH(QString, target);
        QFETCH(QByteArray, call);
        QFETCH(int, number);
        QFETCH(int, error);
        const test::WatchedHome home;
        const QString folder = home.path(QStringLiteral("as"));
        QVERIFY(QDir().mkpath(folder));
        const QString file = QDir(folder).filePath(target);
        if (target == QLatin1String("old.burin"))
            QVERIFY(!test::makeSession(file).isEmpty());
        QProcessEnvironment environment = home.environment(
            {.under = folder, .calls = call, .first = number, .last = number, .error = error});
        environment.insert(QLatin1String(savedTo), file);
        if (error != 0)
            environment.insert(
                QLatin1String(toldReason), QString::fromLocal8Bit(std::strerror(error)));
        environment.insert(QStringLiteral("BURIN_TEST_DISPLAY"), QStringLiteral("inherit"));
        QProcess process;
        process.setProcessEnvironment(environment);
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(
            QCoreApplication::applicationFilePath(), {QStringLiteral("WindowOnFailingDisk")});
        QVERIFY(process.waitForFinished(test::ApplicationFixture::patience));
        QVERIFY2(process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0,
            process.readAll().constData());
        int failed = 0;
        for (const test::FileEvent& event : home.events())
            failed += event.what == "fails" ? 1 : 0;
        QCOMPARE(failed, 1);
    }
};

BURIN_WINDOW_TEST(WindowOnFailingDisk)
BURIN_WINDOW_TEST(FailingSaveUiTest)

} // namespace failingSaveUiTest

#include "FailingSaveUiTest.moc"
