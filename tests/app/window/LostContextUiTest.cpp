// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/Edit.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/records/SessionContents.h"
#include "tests/support/faults/LosingGl.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/frame/MessageBar.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/Workspace.h"

#include <QFile>
#include <QPushButton>
#include <QTest>

namespace lostContextUiTest {

using test::LosingGl;

/// The graphics driver loses its context while a study is open: the window closes it, whole on
/// disk, says so, and opens it again at the same row.
class LostContextUiTest : public QObject, test::WithApplication {
    Q_OBJECT

private:
    QPushButton& button() const { return *window().messages().findChild<QPushButton*>(); }
    bool isOffered() const
    {
        return !workspace().session() && !button().isHidden()
            && button().text() == QStringLiteral("Open it again")
            && m_fixture->bar().contains(
                QStringLiteral("The graphics driver broke off its work (the graphics processor was "
                               "reset), so the study was closed."));
    }
    /// Some steps, the last one undone.
    void work() const
    {
        m_fixture->open(m_fixture->path("case/ct"));
        for (const core::Edit& edit : {core::Edit(test::addSegment("Brain")),
                 core::Edit(test::seedInBrain(1)), core::Edit(test::growBrain(3)),
                 core::Edit(test::drillAt(-6)), core::Edit(test::drillAt(4))})
            m_fixture->edit(edit);
        QVERIFY(session().undo());
        QVERIFY(test::waitUntilDrawn(window(), workspace()));
    }

private Q_SLOTS:
    void init() { makeApplication(); }
    void cleanup() { dropApplication(); }

    void opensAgainAtTheSameRow_data()
    {
        QTest::addColumn<QString>("what");
        for (const char* what : {"a step", "a growth", "a picture"})
            QTest::newRow(what) << QString::fromLatin1(what);
    }
    void opensAgainAtTheSameRow()
    {
        QFETCH(QString, what);
        work();
        const QByteArray hash = session().stateHash();
        const core::RowId position = session().history().position();
        const QString name = session().history().row(position).name;
        const QString file = session().file();
        QCOMPARE(position, core::RowId(4));
        if (what == QStringLiteral("a growth")) {
            QVERIFY(session().begin(test::growBrain()));
            session().extend(core::GrowAdvance{.generationsPerSecond = 2.0});
        }
        const LosingGl losing(1);
        if (what == QStringLiteral("a step"))
            QVERIFY(session().apply(test::drillAt(1)));
        else if (what == QStringLiteral("a picture"))
            workspace().setWindowLevel({.centre = 100.0, .width = 200.0});
        QTRY_VERIFY_WITH_TIMEOUT(isOffered(), patience);
        QCOMPARE(losing.lost(), 1);
        QVERIFY2(m_fixture->bar().contains(QStringLiteral("stands at '%1'").arg(name)),
            qPrintable(m_fixture->bar()));
        QCoreApplication::sendPostedEvents();
        test::look(window().grab(), "lost-context.png");
        const auto kept = core::checkSession(file);
        QVERIFY(kept && kept->isWhole());
        QCOMPARE(kept->rows.size(), std::size_t(5));
        QCOMPARE(kept->position, position);

        button().click();
        QTRY_VERIFY_WITH_TIMEOUT(workspace().session(), patience);
        QCOMPARE(session().file(), file);
        QCOMPARE(session().history().position(), position);
        QVERIFY(session().settle());
        QCOMPARE(session().stateHash(), hash);
        QVERIFY(session().history().canRedo());
        // All is as ever on the new context, pictures too.
        m_fixture->edit(test::drillAt(1));
        QCOMPARE(session().history().position(), core::RowId(6));
        QVERIFY(test::waitUntilDrawn(window(), workspace()));
        QCOMPARE(losing.lost(), 1);
    }

    /// A session without a step leaves no file; its study opens again.
    void opensAStudyAgainWithoutSteps()
    {
        m_fixture->open(m_fixture->path("case/ct"));
        QVERIFY(test::waitUntilDrawn(window(), workspace()));
        const QString file = session().file();
        const LosingGl losing(1);
        workspace().setWindowLevel({.centre = 100.0, .width = 200.0});
        QTRY_VERIFY_WITH_TIMEOUT(isOffered(), patience);
        QVERIFY(m_fixture->bar().contains(QStringLiteral("No step had been done")));
        QVERIFY(!QFile::exists(file));
        button().click();
        QTRY_VERIFY_WITH_TIMEOUT(workspace().session(), patience);
        QCOMPARE(session().file(), file);
        QVERIFY(test::waitUntilDrawn(window(), workspace()));
    }

    /// Whoever dismisses the offer opens what he likes.
    void anythingElseOpensToo()
    {
        work();
        const QString file = session().file();
        const LosingGl losing(1);
        workspace().setWindowLevel({.centre = 100.0, .width = 200.0});
        QTRY_VERIFY_WITH_TIMEOUT(isOffered(), patience);
        window().messages().dismiss();
        m_fixture->open(m_fixture->path("case/ct"));
        QCOMPARE(session().file(), file);
        QCOMPARE(session().history().position(), core::RowId(4));
        QVERIFY(test::waitUntilDrawn(window(), workspace()));
    }
};

BURIN_WINDOW_TEST(LostContextUiTest)

} // namespace lostContextUiTest

#include "LostContextUiTest.moc"
