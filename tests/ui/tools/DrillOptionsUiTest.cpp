// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/DrillOptions.h"

#include "tests/support/FailingLog.h"
#include "tests/support/SmallStudy.h"
#include "tests/support/WindowFixture.h"
#include "ui/MaskPresets.h"
#include "ui/tools/DrillTool.h"
#include "ui/tools/MaskPresetMenu.h"
#include "ui/tools/PressureMenu.h"
#include "ui/widgets/PressureCurve.h"

#include <QDir>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QSettings>
#include <QtTest>

using ui::MaskPreset;
using Kind = core::MaskShape::Kind;

/// What the option bar of the drill offers beside shape, size and depth.
class DrillOptionsUiTest : public QObject {
    Q_OBJECT

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
        auto* masks = options.findChild<ui::MaskPresetMenu*>();
        QVERIFY(masks);
        ui::Workspace::DrillSettings settings = fixture.workspace.drillSettings();
        settings.shape = Kind::Rectangle;
        settings.radiusMm = 11.5;
        settings.heightRatio = 0.25;
        settings.rotationDegrees = -30.0;
        fixture.workspace.setDrillSettings(settings);
        masks->save(QStringLiteral("  Saw   cut "));
        masks->save(QStringLiteral("   "));
        settings.shape = Kind::Circle;
        settings.radiusMm = 2.0;
        settings.depthMm = 21.0;
        fixture.workspace.setDrillSettings(settings);
        masks->save(QStringLiteral("Burr"));
        const std::vector<MaskPreset> kept = ui::maskPresets();
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
        QCOMPARE(now.depthMm, 21.0); // a mask says nothing of the depth

        masks->save(QStringLiteral("Burr")); // another mask under that name
        QCOMPARE(ui::maskPresets().size(), std::size_t(2));
        QVERIFY(ui::maskPresets()[0].shape == Kind::Rectangle);
        ui::removeMaskPreset(QStringLiteral("Saw cut"));
        QCOMPARE(ui::maskPresets().size(), std::size_t(1));
    }

    void damagedSettingsAreNoMasks()
    {
        for (const char* text : {"", "{", "[1, {}]",
                 "[{\"name\":\"a\",\"shape\":9,\"radiusMm\":3,\"heightRatio\":1,"
                 "\"rotationDegrees\":0}]",
                 "[{\"name\":\"a\",\"shape\":0,\"radiusMm\":1e9,\"heightRatio\":1,"
                 "\"rotationDegrees\":0}]",
                 "[{\"name\":\"a\",\"shape\":0,\"radiusMm\":3}]"}) {
            QSettings().setValue(QStringLiteral("drill/masks"), QByteArray(text));
            QVERIFY2(ui::maskPresets().empty(), text);
        }
    }

    void pressureAndFloorReachTheStroke()
    {
        test::WindowFixture fixture(test::smallStudy());
        ui::DrillOptions options(fixture.workspace, ui::DrillOptions::Of::Drill);
        auto* pressure = options.findChild<ui::PressureMenu*>();
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
            QStringLiteral("Pressure curve: half the pressure cuts 25 % of the depth"));

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

    /// However many options there are, a small window stays small.
    void theBarFitsASmallWindow()
    {
        test::WindowFixture fixture(test::smallStudy());
        ui::DrillTool tool(fixture.workspace);
        ui::Workspace::DrillSettings settings = fixture.workspace.drillSettings();
        settings.mode = core::DrillMode::Rate;
        settings.shape = Kind::Rounded;
        fixture.workspace.setDrillSettings(settings);
        fixture.workspace.setActiveTool(&tool);
        fixture.window.resize(1280, 720);
        QTest::qWait(50);
        QCOMPARE(fixture.window.width(), 1280);
        fixture.workspace.setActiveTool(nullptr);
    }

    void looks()
    {
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (folder.isEmpty())
            QSKIP("BURIN_SCREENSHOTS names no folder");
        test::WindowFixture fixture(test::smallStudy());
        ui::DrillTool tool(fixture.workspace);
        ui::Workspace::DrillSettings settings = fixture.workspace.drillSettings();
        settings.mode = core::DrillMode::Rate;
        settings.shape = Kind::Rounded;
        fixture.workspace.setDrillSettings(settings);
        fixture.workspace.setActiveTool(&tool);
        fixture.window.resize(1280, 720);
        QTest::qWait(200);
        QVERIFY(fixture.window.grab().save(QDir(folder).filePath(QStringLiteral("drill-bar.png"))));
        ui::PressureCurve curve;
        curve.resize(curve.sizeHint());
        QVERIFY(curve.grab().save(QDir(folder).filePath(QStringLiteral("pressure-curve.png"))));
        fixture.workspace.setActiveTool(nullptr);
    }
};

QTEST_MAIN(DrillOptionsUiTest)
#include "DrillOptionsUiTest.moc"
