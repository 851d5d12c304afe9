// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/GenerationSection.h"

#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/panels/growth/GenerationBar.h"
#include "ui/panels/growth/GrowthPanel.h"
#include "ui/workspace/SegmentActions.h"

#include <QAbstractButton>
#include <QSignalSpy>
#include <QtTest>

namespace generationSectionUiTest {

namespace {

/// The growth panel on screen, with one seed in the ventricle of the small head.
class GrownPanel : public test::WorkspaceFixture {
public:
    GrownPanel()
        : panel(workspace)
    {
        panel.show();
        if (!QTest::qWaitForWindowExposed(&panel) || !ui::addSegment(workspace))
            qFatal("no panel");
        apply(middleSeed(1));
        ui::GrowSettings settings;
        settings.lower = 0.0;
        settings.upper = 20.0;
        workspace.setGrowSettings(settings);
    }
    [[nodiscard]] QAbstractButton& button(const char* name) const
    {
        auto* found = panel.findChild<QAbstractButton*>(QLatin1String(name));
        if (!found)
            qFatal("no button %s", name);
        return *found;
    }

    ui::GrowthPanel panel;
};

} // namespace

class GenerationSectionUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// A growth that was begun during a drag is not ended with it.
    void theBarEndsOnlyItsOwn()
    {
        GrownPanel fixture;
        for (int step = 0; step < 3; ++step) {
            fixture.button("growStep").click();
            fixture.settle();
        }
        auto* bar = fixture.panel.findChild<ui::GenerationBar*>();
        QVERIFY(QTest::qWaitFor([&] {
            fixture.settle();
            return bar->sizes().size() == 4;
        }));
        const auto at = [bar](int generation) {
            return QPoint(6 + (bar->width() - 12) * (generation - 1) / 3, bar->height() / 2);
        };
        QTest::mousePress(bar, Qt::LeftButton, {}, at(2));
        QVERIFY(fixture.session().isOpen<core::ShrinkSteps>());
        fixture.button("growPlay").click();
        QVERIFY(fixture.session().isOpen<core::GrowSteps>());
        QTest::mouseRelease(bar, Qt::LeftButton, {}, at(2));
        QVERIFY(fixture.session().isOpen<core::GrowSteps>());
        QTRY_VERIFY((fixture.session().poll(), !fixture.panel.running()));
        fixture.settle();

        // Locked, it is not dragged.
        const auto isCounted = [&] {
            fixture.settle();
            return bar->sizes().size() > 4 && bar->cursor().shape() == Qt::SizeHorCursor;
        };
        QVERIFY(QTest::qWaitFor(isCounted));
        const int last = bar->shown();
        QCOMPARE(last, int(bar->sizes().size()));
        fixture.apply(test::lockSegment(1));
        QTest::mousePress(bar, Qt::LeftButton, {}, at(1));
        QVERIFY(!bar->scrubbing());
        QCOMPARE(bar->shown(), last);
        QTest::mouseRelease(bar, Qt::LeftButton, {}, at(1));
        fixture.apply(test::lockSegment(1, false));
        QVERIFY(QTest::qWaitFor(isCounted));
        QTest::mousePress(bar, Qt::LeftButton, {}, at(1));
        QVERIFY(bar->scrubbing());
        QTest::keyClick(bar, Qt::Key_Escape);
        fixture.settle();
    }

    /// A drag that is refused leaves the mark where the growth is.
    void whatIsAbandonedMovesNothing()
    {
        ui::GenerationBar refused;
        refused.resize(240, 40);
        refused.show();
        QVERIFY(QTest::qWaitForWindowExposed(&refused));
        refused.setSizes({5, 4, 3, 2});
        refused.setScrubbable(true);
        connect(&refused, &ui::GenerationBar::scrubBegan, &refused, &ui::GenerationBar::abandon);
        QSignalSpy moved(&refused, &ui::GenerationBar::scrubbed);
        QSignalSpy ended(&refused, &ui::GenerationBar::scrubEnded);
        QTest::mousePress(&refused, Qt::LeftButton, {}, {10, 20});
        QTest::mouseRelease(&refused, Qt::LeftButton, {}, {10, 20});
        QCOMPARE(refused.shown(), 4);
        QVERIFY(!refused.scrubbing() && moved.isEmpty() && ended.isEmpty());
    }
};

BURIN_WINDOW_TEST(GenerationSectionUiTest)

} // namespace generationSectionUiTest

#include "GenerationSectionUiTest.moc"
