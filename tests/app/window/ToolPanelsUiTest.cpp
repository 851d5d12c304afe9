// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/Actions.h"
#include "ui/frame/ToolColumn.h"
#include "ui/input/Tool.h"
#include "ui/workspace/Workspace.h"

#include <QAction>
#include <QTest>
#include <QToolButton>

namespace toolPanelsUiTest {

/// The panel of a tool opens when the user takes the tool, and only then; tools and panels go into
/// a small window.
class ToolPanelsUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aToolThatIsTakenOpensItsPanel_data()
    {
        QTest::addColumn<QString>("tool");
        QTest::addColumn<QString>("panel");
        QTest::newRow("clip") << "tool.clip"
                              << "panel.ClippingPanel";
        QTest::newRow("seed") << "tool.seed"
                              << "panel.GrowthPanel";
        QTest::newRow("contour") << "tool.contour"
                                 << "panel.ContourPanel";
        QTest::newRow("refine") << "tool.refine"
                                << "panel.RefinePanel";
        QTest::newRow("chunks") << "tool.chunks"
                                << "panel.ChunksPanel";
        QTest::newRow("measure") << "tool.ruler"
                                 << "panel.MeasurementsPanel";
    }
    void aToolThatIsTakenOpensItsPanel()
    {
        QFETCH(QString, tool);
        QFETCH(QString, panel);
        test::ApplicationFixture fixture;
        fixture.open(fixture.path("case/ct"));
        ui::Actions& actions = fixture.window().actionTable();
        if (actions[panel].isChecked())
            actions[panel].trigger();
        QVERIFY(!actions[panel].isChecked());

        actions[tool].trigger();
        QVERIFY(fixture.workspace().activeTool());
        QVERIFY(actions[panel].isChecked());

        // As a study that is opened again brings its tool back: a closed panel stays closed.
        ui::Tool* taken = fixture.workspace().activeTool();
        fixture.workspace().setActiveTool(nullptr);
        actions[panel].trigger();
        fixture.workspace().setActiveTool(taken);
        QVERIFY(!actions[panel].isChecked());
        fixture.workspace().setActiveTool(nullptr);
    }

    /// With all tools there are, each is within reach in a small window.
    void allToolsFitASmallWindow()
    {
        test::ApplicationFixture fixture;
        fixture.open(fixture.path("case/ct"));
        ui::MainWindow& window = fixture.window();
        window.resize(1280, 720);
        QTRY_COMPARE(window.size(), QSize(1280, 720));
        const auto* column = window.findChild<ui::ToolColumn*>();
        QVERIFY(column);
        const QList<QToolButton*> buttons = column->findChildren<QToolButton*>();
        QVERIFY(buttons.size() > 20);
        for (const QToolButton* button : buttons) {
            QTRY_VERIFY2(
                column->rect().contains(button->geometry()), qPrintable(button->toolTip()));
            QVERIFY2(
                button->height() >= button->iconSize().height(), qPrintable(button->toolTip()));
        }
        for (const char* tool : {"tool.nudge", "tool.contour"}) {
            window.actionTable()[QLatin1String(tool)].trigger();
            QVERIFY2(fixture.workspace().activeTool(), tool);
            QTRY_COMPARE(window.size(), QSize(1280, 720));
            QVERIFY2(window.minimumSizeHint().width() <= 1280, tool);
            QVERIFY2(window.minimumSizeHint().height() <= 720, tool);
        }
    }
};

BURIN_WINDOW_TEST(ToolPanelsUiTest)

} // namespace toolPanelsUiTest

#include "ToolPanelsUiTest.moc"
