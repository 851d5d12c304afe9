// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/sculpt/DrillOptions.h"

#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/panels/history/HistoryPanel.h"
#include "ui/tools/common/PenMenu.h"
#include "ui/tools/sculpt/DrillTool.h"
#include "ui/tools/sculpt/LaserTool.h"
#include "ui/tools/sculpt/ToolMaskPresetMenu.h"
#include "ui/tools/sculpt/ToolMaskPresets.h"
#include "ui/views/ViewGrid.h"
#include "ui/widgets/PressureCurve.h"
#include "ui/window/OptionBar.h"

#include <QCheckBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMenu>
#include <QSettings>
#include <QToolButton>
#include <QtTest>

namespace drillOptionsUiTest {

using ui::ToolMaskPreset;
using Kind = core::ToolMask::Kind;

/// What the option bar of the drill offers beside shape, size and depth.
class DrillOptionsUiTest : public QObject {
    Q_OBJECT

private:
    /// All options that there can be, in a window as small as they come.
    static void showEverything(test::WindowFixture& fixture, ui::Tool& tool, bool freehand)
    {
        ui::Workspace::DrillSettings settings = fixture.workspace.drillSettings();
        settings.mode = core::DrillMode::Rate;
        settings.shape = Kind::Rounded;
        settings.freehand = freehand;
        settings.outline = {{-1.0, -0.5}, {1.0, -0.25}, {0.5, 0.5}};
        settings.radiusMm = 12.5;
        settings.heightRatio = 1.0;
        settings.rotationDegrees = -135.0;
        settings.softnessMm = 12.5;
        settings.depthMm = 112.5;
        settings.floorMm = 112.5;
        fixture.workspace.setDrillSettings(settings);
        fixture.workspace.setActiveTool(&tool);
        fixture.window.resize(1280, 720);
    }

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        QSettings().remove(QStringLiteral("drill"));
    }

    void masksAreSavedAndChosen()
    {
        test::WindowFixture fixture(test::smallStudy());
        ui::DrillOptions options(fixture.workspace, ui::DrillOptions::Of::Drill);
        auto* masks = options.findChild<ui::ToolMaskPresetMenu*>();
        QVERIFY(masks);
        ui::Workspace::DrillSettings settings = fixture.workspace.drillSettings();
        settings.shape = Kind::Rectangle;
        settings.radiusMm = 11.5;
        settings.heightRatio = 0.25;
        settings.rotationDegrees = -30.0;
        settings.softnessMm = 2.5;
        fixture.workspace.setDrillSettings(settings);
        masks->save(QStringLiteral("  Saw   cut "));
        masks->save(QStringLiteral("   "));
        settings.shape = Kind::Circle;
        settings.radiusMm = 2.0;
        settings.softnessMm = 0.0;
        settings.depthMm = 21.0;
        fixture.workspace.setDrillSettings(settings);
        masks->save(QStringLiteral("Burr"));
        const std::vector<ToolMaskPreset> kept = ui::toolMaskPresets();
        QCOMPARE(kept.size(), std::size_t(2));
        QCOMPARE(kept[0].name, QStringLiteral("Burr"));
        QCOMPARE(kept[1].name, QStringLiteral("Saw cut"));

        Q_EMIT masks->menu()->aboutToShow();
        const QList<QAction*> actions = masks->menu()->actions();
        QCOMPARE(actions[0]->text(), QStringLiteral("Burr"));
        QVERIFY(actions[0]->isChecked() && !actions[1]->isChecked());
        actions[1]->trigger();
        const ui::Workspace::DrillSettings& now = fixture.workspace.drillSettings();
        QVERIFY(now.shape == Kind::Rectangle);
        QCOMPARE(now.radiusMm, 11.5);
        QCOMPARE(now.heightRatio, 0.25);
        QCOMPARE(now.rotationDegrees, -30.0);
        QCOMPARE(now.softnessMm, 2.5);
        QCOMPARE(now.depthMm, 21.0); // a mask says nothing of the depth

        masks->save(QStringLiteral("Burr")); // another mask under that name
        QCOMPARE(ui::toolMaskPresets().size(), std::size_t(2));
        QVERIFY(ui::toolMaskPresets()[0].shape == Kind::Rectangle);
        ui::removeToolMaskPreset(QStringLiteral("Saw cut"));
        QCOMPARE(ui::toolMaskPresets().size(), std::size_t(1));
    }

    void damagedSettingsAreNoMasks()
    {
        for (const char* text : {"", "{", "[1, {}]",
                 "[{\"name\":\"a\",\"shape\":9,\"radiusMm\":3,\"heightRatio\":1,"
                 "\"rotationDegrees\":0}]",
                 "[{\"name\":\"a\",\"shape\":0,\"radiusMm\":1e9,\"heightRatio\":1,"
                 "\"rotationDegrees\":0}]",
                 "[{\"name\":\"a\",\"shape\":0,\"radiusMm\":3,\"heightRatio\":1,"
                 "\"rotationDegrees\":0,\"softnessMm\":-1}]",
                 "[{\"name\":\"a\",\"shape\":0,\"radiusMm\":3}]"}) {
            QSettings().setValue(QStringLiteral("drill/masks"), QByteArray(text));
            QVERIFY2(ui::toolMaskPresets().empty(), text);
        }
        // Of a Burin that knew no soft edge.
        QSettings().setValue(QStringLiteral("drill/masks"),
            QByteArray("[{\"name\":\"a\",\"shape\":0,\"radiusMm\":3,\"heightRatio\":1,"
                       "\"rotationDegrees\":0}]"));
        QCOMPARE(ui::toolMaskPresets().size(), std::size_t(1));
        QCOMPARE(ui::toolMaskPresets()[0].softnessMm, 0.0);
    }

    void pressureAndFloorReachTheStroke()
    {
        test::WindowFixture fixture(test::smallStudy());
        ui::DrillOptions options(fixture.workspace, ui::DrillOptions::Of::Drill);
        auto* pressure = options.findChild<ui::PenMenu*>();
        auto* curve = pressure ? pressure->findChild<ui::PressureCurve*>() : nullptr;
        QVERIFY(curve);
        QCOMPARE(curve->exponent(), 2);
        QCOMPARE(pressure->text(), QStringLiteral("p²"));
        curve->resize(curve->sizeHint());
        // The straight line lies highest, the cube lowest.
        QTest::mouseClick(curve, Qt::LeftButton, {}, QPoint(curve->width() / 2, 30));
        QCOMPARE(fixture.workspace.drillSettings().pressureExponent, 1);
        QTest::mouseClick(
            curve, Qt::LeftButton, {}, QPoint(curve->width() / 2, curve->height() - 30));
        QCOMPARE(fixture.workspace.drillSettings().pressureExponent, 3);
        QTest::keyClick(curve, Qt::Key_Right);
        QCOMPARE(curve->exponent(), 3);
        QTest::keyClick(curve, Qt::Key_Left);
        QCOMPARE(fixture.workspace.drillSettings().pressureExponent, 2);
        QCOMPARE(pressure->toolTip(),
            QStringLiteral(
                "Pen: half the pressure cuts 25 % of the depth; how the mask follows it"));

        auto* floor = options.findChild<QDoubleSpinBox*>(QStringLiteral("drillFloor"));
        QVERIFY(floor && floor->isHidden());
        ui::Workspace::DrillSettings settings = fixture.workspace.drillSettings();
        settings.mode = core::DrillMode::Rate;
        fixture.workspace.setDrillSettings(settings);
        QVERIFY(!floor->isHidden());
        QCOMPARE(floor->value(), 30.0);
        floor->setValue(12.5);
        QCOMPARE(fixture.workspace.drillSettings().floorMm, 12.5);
    }

    void theSoftEdgeReachesTheStroke()
    {
        test::WindowFixture fixture(test::smallStudy());
        ui::LaserTool tool(fixture.workspace);
        ui::DrillOptions options(fixture.workspace, ui::DrillOptions::Of::Laser);
        auto* softness = options.findChild<QDoubleSpinBox*>(QStringLiteral("drillSoftness"));
        QVERIFY(softness);
        QCOMPARE(softness->text(), QStringLiteral("sharp"));
        softness->setValue(2.5);
        QCOMPARE(softness->text(), QStringLiteral("soft 2.5 mm"));
        const ui::ViewContext context = fixture.window.views().volume().context();
        QCOMPARE(tool.strokeIn(context).mask.softnessMm, 2.5);
        QVERIFY(!options.findChild<QCheckBox*>(QStringLiteral("drillForeshortened"))->isChecked());
        options.findChild<QCheckBox*>(QStringLiteral("drillForeshortened"))->setChecked(true);
        options.findChild<QCheckBox*>(QStringLiteral("drillTurnsWithPen"))->setChecked(false);
        const ui::Workspace::DrillSettings& settings = fixture.workspace.drillSettings();
        QVERIFY(settings.foreshortened && !settings.turnsWithPen);
        QCOMPARE(settings.softnessMm, 2.5);
    }

    /// However many options there are, a small window stays small and cuts no text off.
    void theBarFitsASmallWindow_data()
    {
        QTest::addColumn<bool>("freehand");
        QTest::newRow("a shape") << false;
        QTest::newRow("drawn by hand") << true;
    }
    void theBarFitsASmallWindow()
    {
        QFETCH(bool, freehand);
        test::WindowFixture fixture(test::smallStudy());
        fixture.window.addPanel(new ui::HistoryPanel(fixture.workspace));
        fixture.window.showPanels(true);
        core::EditSession& session = *fixture.workspace.session();
        for (const char* name : {"A segment with a name as long as names are", "Another one"})
            QVERIFY(session.apply(test::newSegment(QLatin1String(name), 1)));
        QVERIFY(session.undo());
        QVERIFY(session.settle());
        ui::DrillTool tool(fixture.workspace);
        showEverything(fixture, tool, freehand);
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        QCOMPARE(fixture.window.width(), 1280);
        QVERIFY(fixture.window.findChild<ui::HistoryPanel*>()->isVisible());
        const auto* bar = fixture.window.findChild<ui::OptionBar*>();
        for (const QDoubleSpinBox* box : bar->findChildren<QDoubleSpinBox*>()) {
            if (!box->isVisible())
                continue;
            const auto* edit = box->findChild<QLineEdit*>();
            QVERIFY2(box->fontMetrics().horizontalAdvance(box->text())
                    <= edit->contentsRect().width() + 2,
                qPrintable(QStringLiteral("%1: '%2' in %3 pixels")
                               .arg(box->objectName(), box->text())
                               .arg(edit->width())));
            QVERIFY(bar->rect().contains(QRect(box->mapTo(bar, QPoint(0, 0)), box->size())));
        }
        // What a step is called is told, or left out, but not cut to a letter or two.
        for (const QToolButton* button : bar->findChildren<QToolButton*>()) {
            const QAction* step = button->defaultAction();
            if (!step || button->toolButtonStyle() == Qt::ToolButtonIconOnly)
                continue;
            QVERIFY2(button->text() == step->text() || button->text().size() > 8,
                qPrintable(button->text()));
        }
        fixture.workspace.setActiveTool(nullptr);
    }

    void looks()
    {
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (folder.isEmpty())
            QSKIP("BURIN_SCREENSHOTS names no folder");
        test::WindowFixture fixture(test::smallStudy());
        ui::DrillTool tool(fixture.workspace);
        showEverything(fixture, tool, true);
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        QVERIFY(fixture.window.grab().save(QDir(folder).filePath(QStringLiteral("drill-bar.png"))));
        QMenu& menu = *fixture.window.findChild<ui::PenMenu*>()->menu();
        menu.popup(QPoint(0, 0));
        QVERIFY(menu.grab().save(QDir(folder).filePath(QStringLiteral("pen-menu.png"))));
        menu.close();
        fixture.workspace.setActiveTool(nullptr);
    }
};

BURIN_WINDOW_TEST(DrillOptionsUiTest)

} // namespace drillOptionsUiTest

#include "DrillOptionsUiTest.moc"
