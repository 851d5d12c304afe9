// SPDX-License-Identifier: Apache-2.0
#include "core/session/SessionStorage.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SessionFiles.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSignalSpy>
#include <QTest>

namespace sessionAsideUiTest {

/// A session makes room for a new one of its study: with everything that lies beside it, which
/// would be in the way of that.
class SessionAsideUiTest : public QObject, private test::WithApplication {
    Q_OBJECT

    static void write(const QString& file, const QByteArray& bytes)
    {
        QFile written(file);
        QVERIFY(written.open(QIODevice::WriteOnly) && written.write(bytes) == bytes.size());
    }
    /// The session of the study with a step, closed.
    [[nodiscard]] QString workedOn() const
    {
        open(path("case/ct"));
        edit(test::drillAt(0));
        const QString working = session().file();
        window().closeStudy();
        return working;
    }

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        makeApplication();
    }
    void cleanup() { dropApplication(); }

    /// A newer Burin wrote it, and was killed.
    void whatIsPutAsideTakesItsLastWritesAlong()
    {
        const QString working = workedOn();
        test::runSql(working, QStringLiteral("PRAGMA user_version=99"));
        const QByteArray wal(5000, 'w');
        write(working + QStringLiteral("-wal"), wal);
        const QByteArray before = test::bytesOf(working);

        window().opener().open(path("case/ct"));
        QTRY_VERIFY2_WITH_TIMEOUT(
            bar().contains(QStringLiteral("a newer Burin wrote it")), qPrintable(bar()), patience);
        test::press(window(), QStringLiteral("Put it aside and start a new session"));
        QTRY_VERIFY2_WITH_TIMEOUT(workspace().session(), qPrintable(bar()), patience);
        QCOMPARE(session().file(), working);
        QVERIFY(!session().storage().whyNoFile());
        QCOMPARE(session().history().rows().size(), std::size_t(0));

        const QDir folder(QFileInfo(working).path());
        const QStringList aside =
            folder.entryList({QStringLiteral("*.aside-*")}, QDir::Files, QDir::Name);
        QCOMPARE(aside.size(), 2);
        QCOMPARE(aside[1], aside[0] + QStringLiteral("-wal"));
        QCOMPARE(test::bytesOf(folder.filePath(aside[0])), before);
        QCOMPARE(test::bytesOf(folder.filePath(aside[1])), wal);
    }

    void whoBeginsAnewLeavesNothingInTheWay()
    {
        const QString working = workedOn();
        open(path("case/ct"));
        QTRY_VERIFY_WITH_TIMEOUT(bar().contains(QStringLiteral("goes on with 1 step")), patience);
        write(working + QStringLiteral("-shm"), QByteArray(32768, '\0'));
        QSignalSpy changed(&workspace(), &ui::Workspace::sessionChanged);
        test::press(window(), QStringLiteral("Begin anew"));
        QTRY_COMPARE_WITH_TIMEOUT(changed.count(), 2, patience); // closed, opened
        QCOMPARE(session().file(), working);
        QVERIFY(!session().storage().whyNoFile());
        QCOMPARE(session().history().rows().size(), std::size_t(0));
    }
};

BURIN_WINDOW_TEST(SessionAsideUiTest)

} // namespace sessionAsideUiTest

#include "SessionAsideUiTest.moc"
