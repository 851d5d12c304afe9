// SPDX-License-Identifier: Apache-2.0
#include "ui/workspace/ViewSteps.h"

#include "core/edits/open/StrokeExtension.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/panels/history/HistoryPanel.h"

#include <QListView>
#include <QTest>

namespace viewStepsUiTest {

namespace {

/// The window with two segments, of which the first one is painted.
class Fixture : public test::WindowFixture {
public:
    Fixture()
        : WindowFixture(test::smallStudy())
    {
        apply(test::newSegment(QStringLiteral("S1")));
        apply(test::newSegment(QStringLiteral("S2")));
        apply(test::paintAt(1, {test::pointsInBone().front()}));
    }
    void trigger(const char* id) { window.actionTable()[QLatin1String(id)].trigger(); }
    void settle()
    {
        session().poll();
        if (!session().settle())
            qFatal("not settled");
    }
    [[nodiscard]] core::RowId position() { return session().history().position(); }
    [[nodiscard]] bool isShown(int label) { return session().document().segment(label)->visible; }
    /// A growth that runs and has come some way.
    void beginGrowth()
    {
        QVERIFY(session().begin(test::growBrain()));
        session().extend(core::GrowAdvance{.steps = 2});
        session().poll();
        QVERIFY(session().transactionOpen());
    }
    void show(int label, bool shown) { workspace.viewSteps().showSegment(label, shown); }
};

} // namespace

/// Eyes among steps that are still under way.
class ViewStepsUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Undo again, before what the first one takes back is there.
    void impatientUndosLeaveNoEyeOut()
    {
        Fixture fixture;
        const core::RowId row = fixture.position();
        fixture.show(2, false);
        fixture.apply(test::paintAt(1, {test::pointsInBrain().front()}));
        fixture.trigger("edit.undo");
        QVERIFY(!fixture.session().idle());
        fixture.trigger("edit.undo");
        fixture.settle();
        QCOMPARE(fixture.position(), row);
        QVERIFY(fixture.isShown(2));
        // And forth.
        fixture.trigger("edit.redo");
        fixture.trigger("edit.redo");
        fixture.settle();
        QCOMPARE(fixture.position(), row + 1);
        QVERIFY(!fixture.isShown(2));
    }

    /// Undo takes the growth back that began later, and then the eye.
    void aGrowthThatRunsCameAfterTheEye()
    {
        Fixture fixture;
        fixture.apply(test::seedInBrain(1));
        const core::RowId row = fixture.position();
        fixture.show(2, false);
        fixture.beginGrowth();
        fixture.trigger("edit.undo");
        fixture.settle();
        QVERIFY(!fixture.session().transactionOpen());
        QCOMPARE(fixture.position(), row);
        QVERIFY(!fixture.isShown(2));
        fixture.trigger("edit.undo");
        fixture.settle();
        QCOMPARE(fixture.position(), row);
        QVERIFY(fixture.isShown(2));
    }

    /// Whoever looks around while a growth runs does not end it, by undo or by the list.
    void aGrowthThatRunsGoesOn()
    {
        Fixture fixture;
        fixture.window.addPanel(new ui::HistoryPanel(fixture.workspace));
        fixture.window.showPanels(true);
        auto* list = fixture.window.findChild<QListView*>(QStringLiteral("historyList"));
        QVERIFY(list);
        fixture.apply(test::seedInBrain(1));
        fixture.show(2, false);
        fixture.beginGrowth();
        fixture.show(1, false);
        QCOMPARE(fixture.workspace.viewSteps().at(fixture.position()).all.size(), std::size_t(2));
        fixture.trigger("edit.undo");
        QVERIFY(fixture.isShown(1) && !fixture.isShown(2));
        QVERIFY(fixture.session().transactionOpen());
        // The opened study, four steps, the first eye, and the second one.
        const QModelIndex second = list->model()->index(6, 0);
        QCOMPARE(second.data().toString(), QStringLiteral("Hide 'S1'"));
        Q_EMIT list->activated(second);
        QVERIFY(!fixture.isShown(1));
        QVERIFY(fixture.session().transactionOpen());
        fixture.session().end(core::Ending::Rollback);
        fixture.settle();
    }
};

BURIN_WINDOW_TEST(ViewStepsUiTest)

} // namespace viewStepsUiTest

#include "ViewStepsUiTest.moc"
