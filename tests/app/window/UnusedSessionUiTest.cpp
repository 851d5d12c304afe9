// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "core/sessionfile/SessionSalvage.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/window/MainWindow.h"
#include "ui/workspace/Workspace.h"

#include <QFile>
#include <QTest>

namespace unusedSessionUiTest {

/// A session in which nothing was done leaves no file; one in which something was done does,
/// however soon it is closed.
class UnusedSessionUiTest : public QObject, test::WithApplication {
    Q_OBJECT

    enum class End { StudyCloses, WindowCloses, ToldToEnd };

    /// @return the working session of a study that nobody has worked on
    [[nodiscard]] QString opened() const
    {
        open(path("case/ct"));
        return session().file();
    }
    void end(End how) const
    {
        if (how == End::StudyCloses)
            return window().closeStudy();
        // As OrderlyEnd does.
        if (how == End::ToldToEnd)
            workspace().dropSession();
        m_fixture->close();
    }
    static void everyEnd()
    {
        QTest::addColumn<int>("how");
        QTest::newRow("the study is closed") << int(End::StudyCloses);
        QTest::newRow("the window is closed") << int(End::WindowCloses);
        QTest::newRow("the program is told to end") << int(End::ToldToEnd);
    }

private Q_SLOTS:
    void init() { makeApplication(); }
    void cleanup() { dropApplication(); }

    void nothingLeavesNothing_data() { everyEnd(); }
    void nothingLeavesNothing()
    {
        QFETCH(int, how);
        const QString file = opened();
        QVERIFY(QFile::exists(file));
        end(End(how));
        QVERIFY(!QFile::exists(file));
    }

    void aStepUnderWayIsKept_data() { everyEnd(); }
    /// The first one, of which the window has not heard when the session closes.
    void aStepUnderWayIsKept()
    {
        QFETCH(int, how);
        const QString file = opened();
        QVERIFY(session().apply(test::drillAt(0)));
        end(End(how));
        QVERIFY(QFile::exists(file));
        const auto kept = core::checkSession(file);
        QVERIFY(kept && kept->isWhole());
        QCOMPARE(kept->rows.size(), std::size_t(1));
        QVERIFY(!kept->rows.front().stateHash.isEmpty());
    }
};

BURIN_WINDOW_TEST(UnusedSessionUiTest)

} // namespace unusedSessionUiTest

#include "UnusedSessionUiTest.moc"
