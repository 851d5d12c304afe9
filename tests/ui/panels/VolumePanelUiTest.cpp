// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/VolumePanel.h"

#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/frame/PanelSection.h"
#include "ui/frame/TransferFunctionEditor.h"
#include "ui/settings/TransferPresets.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/InitialDisplay.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSlider>
#include <QtTest>

#include <cmath>

namespace volumePanelUiTest {

namespace {

/// The panel in the real window, with the small head.
class Fixture : public test::WindowFixture {
public:
    Fixture()
        : test::WindowFixture(test::smallHead::volume())
        , panel(new ui::VolumePanel(workspace))
    {
        window.addPanel(panel);
        window.showPanels(true);
        window.findChild<ui::PanelSection*>(QStringLiteral("VolumePanel"))->setFolded(false);
        QCoreApplication::sendPostedEvents(); // layouts are posted events
    }
    template <class Widget> [[nodiscard]] Widget& part(const QString& name = {}) const
    {
        auto* found = panel->findChild<Widget*>(name);
        if (!found)
            qFatal("no %s", qPrintable(name));
        return *found;
    }
    void choose(gpu::RenderMode mode)
    {
        auto& button = part<QPushButton>(QStringLiteral("renderMode%1").arg(int(mode)));
        QTest::mouseClick(&button, Qt::LeftButton);
    }
    /// As a user chooses a row of a list.
    static void pick(QComboBox& list, int row)
    {
        list.setCurrentIndex(row);
        Q_EMIT list.activated(row);
    }
    /// What the 3D view draws.
    [[nodiscard]] gpu::VolumeScene scene()
    {
        return std::get<gpu::VolumeScene>(window.views().volume().context().scene);
    }

    ui::VolumePanel* panel;
};

} // namespace

/// What the panel sets reaches the views, and what is set elsewhere reaches the panel.
class VolumePanelUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aModeShowsItsOwnControls()
    {
        Fixture fixture;
        auto& threshold = fixture.part<QDoubleSpinBox>(QStringLiteral("surfaceThreshold"));
        auto& function = fixture.part<ui::TransferFunctionEditor>();
        auto& preset = fixture.part<QComboBox>(QStringLiteral("transferPreset"));
        const QByteArray before = fixture.session().stateHash();
        for (const gpu::RenderMode mode : {gpu::RenderMode::Dvr, gpu::RenderMode::Mip,
                 gpu::RenderMode::Xray, gpu::RenderMode::Surface}) {
            fixture.choose(mode);
            QVERIFY(fixture.scene().mode == mode);
            QCOMPARE(threshold.isVisible(), mode == gpu::RenderMode::Surface);
            QCOMPARE(function.isVisible(), mode == gpu::RenderMode::Dvr);
            QCOMPARE(preset.isVisible(), mode == gpu::RenderMode::Dvr);
        }
        // A way of viewing.
        QCOMPARE(fixture.rows(), std::size_t(0));
        QCOMPARE(fixture.session().stateHash(), before);
    }

    void theThresholdIsThatOfTheSurface()
    {
        Fixture fixture;
        fixture.choose(gpu::RenderMode::Surface);
        auto& threshold = fixture.part<QDoubleSpinBox>(QStringLiteral("surfaceThreshold"));
        auto& slider = fixture.part<QSlider>();
        QCOMPARE(threshold.suffix(), QStringLiteral(" HU"));
        threshold.setValue(300.0);
        QCOMPARE(fixture.scene().surfaceThreshold, 300.0);
        const int there = slider.value();
        QTest::keyClick(&slider, Qt::Key_Right);
        QVERIFY(slider.value() > there);
        QVERIFY(fixture.scene().surfaceThreshold > 300.0);
        QCOMPARE(threshold.value(), fixture.scene().surfaceThreshold);
        ui::Workspace::VolumeDisplay display = fixture.workspace.volumeDisplay();
        display.surfaceThreshold = 120.0;
        fixture.workspace.setVolumeDisplay(display);
        QCOMPARE(threshold.value(), 120.0);
        QVERIFY(slider.value() < there);
    }

    /// What is not of the list is the user's own, which can be made and not chosen.
    void presetsAreThoseOfTheVolume()
    {
        Fixture fixture;
        fixture.choose(gpu::RenderMode::Dvr);
        auto& list = fixture.part<QComboBox>(QStringLiteral("transferPreset"));
        const auto presets = ui::transferPresets(*fixture.workspace.volume());
        QVERIFY(presets.size() > 1);
        QCOMPARE(list.count(), int(presets.size()) + 1);
        for (int row = 0; row < int(presets.size()); ++row) {
            Fixture::pick(list, row);
            QVERIFY(fixture.scene().transferFunction == presets[std::size_t(row)].function);
            QCOMPARE(list.currentIndex(), row);
        }
        Fixture::pick(list, int(presets.size()));
        QCOMPARE(list.currentIndex(), int(presets.size()) - 1);
        ui::Workspace::VolumeDisplay display = fixture.workspace.volumeDisplay();
        display.transferFunction.points.pop_back();
        fixture.workspace.setVolumeDisplay(display);
        QCOMPARE(list.currentText(), QStringLiteral("own"));
    }

    void windowsAreThoseOfTheSlices()
    {
        Fixture fixture;
        auto& list = fixture.part<QComboBox>(QStringLiteral("windowPreset"));
        const auto presets = ui::windowPresets(*fixture.workspace.volume());
        QVERIFY(presets.size() > 1);
        for (int row = 0; row < int(presets.size()); ++row) {
            Fixture::pick(list, row);
            QVERIFY(fixture.workspace.windowLevel() == presets[std::size_t(row)].window);
        }
        fixture.workspace.setWindowLevel({7.0, 777.0});
        QCOMPARE(list.currentText(), QStringLiteral("own"));
    }
};

BURIN_WINDOW_TEST(VolumePanelUiTest)

} // namespace volumePanelUiTest

#include "VolumePanelUiTest.moc"
