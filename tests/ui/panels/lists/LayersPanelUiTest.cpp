// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/lists/LayersPanel.h"

#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/layers/ChangeLayer.h"
#include "core/edits/kinds/layers/MoveLayer.h"
#include "core/edits/kinds/pieces/CutPiece.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/frame/PanelColumn.h"
#include "ui/frame/PanelSection.h"
#include "ui/models/LayerListModel.h"
#include "ui/panels/lists/LayerDelegate.h"
#include "ui/tools/sculpt/DrillTool.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/LayerActions.h"
#include "ui/workspace/LayerLooks.h"

#include <QAbstractItemModelTester>
#include <QDir>
#include <QListView>
#include <QSlider>
#include <QToolButton>
#include <QtTest>

#include <array>
#include <optional>
#include <utility>

namespace layersPanelUiTest {

namespace {

struct Fixture : test::WindowFixture {
    Fixture()
        : WindowFixture(test::smallStudy())
        , panel(new ui::LayersPanel(workspace))
    {
        window.addPanel(panel);
        window.showPanels(true);
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        list = panel->findChild<QListView*>(QStringLiteral("layerList"));
        section = window.findChild<ui::PanelSection*>(QStringLiteral("LayersPanel"));
    }
    void clickEye(int row, Qt::KeyboardModifiers keys = {})
    {
        const QRect place = list->visualRect(list->model()->index(row, 0));
        QTest::mouseClick(
            list->viewport(), Qt::LeftButton, keys, ui::LayerDelegate::eyeRect(place).center());
        QVERIFY(session().settle());
    }

    ui::LayersPanel* panel;
    QListView* list = nullptr;
    ui::PanelSection* section = nullptr;
};

} // namespace

class LayersPanelUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// How much a layer hides is display alone: no step, and no tool sees a difference.
    void aLayerHidesInPart()
    {
        Fixture fixture;
        ui::LayerLooks& looks = fixture.workspace.layerLooks();
        auto* hides = fixture.panel->findChild<QSlider*>(QStringLiteral("layerHides"));
        auto* softness = fixture.panel->findChild<QSlider*>(QStringLiteral("layerSoftness"));
        QVERIFY(hides && softness && hides->value() == 100 && softness->value() == 0);
        QVERIFY(looks.scene().empty());
        hides->setValue(40);
        QCOMPARE(looks.look(1).hides, 0.4);
        const std::vector<gpu::ScenePiece> drawn = looks.scene();
        QCOMPARE(drawn.size(), std::size_t(1));
        QCOMPARE(drawn[0].layer, 1);
        QCOMPARE(drawn[0].id, 0);
        QVERIFY(std::abs(drawn[0].opacity - 0.6f) < 1e-6f);
        QCOMPARE(fixture.list->model()->index(0, 0).data(ui::LayerListModel::HidesRole), 0.4);
        QVERIFY(fixture.session().history().rows().empty());
        // A muted layer hides nothing, and a lifted one is drawn as the piece it is.
        fixture.clickEye(0);
        QVERIFY(looks.scene().empty());
        fixture.clickEye(0);
        QCOMPARE(looks.scene().size(), std::size_t(1));
        fixture.apply(core::CutPiece{.layer = 1, .name = QStringLiteral("Lid")});
        QVERIFY(looks.scene().empty() && !hides->isEnabled());
        // Each layer has its own.
        fixture.apply(core::AddLayer{.name = QStringLiteral("Way in")});
        fixture.workspace.setActiveLayer(2);
        QCOMPARE(hides->value(), 100);
        QVERIFY(hides->isEnabled());
        softness->setValue(50);
        QCOMPARE(looks.scene().front().softness, 0.5f);
    }

    void isFoldedUntilThereIsSomethingToChoose()
    {
        Fixture fixture;
        QVERIFY(fixture.section && fixture.section->isFolded());
        QCOMPARE(fixture.panel->summary(), QStringLiteral("1 layer"));
        QToolButton* add = nullptr;
        for (auto* button : fixture.section->findChildren<QToolButton*>()) {
            if (button->defaultAction() == fixture.panel->actions().front())
                add = button;
        }
        QVERIFY(add && add->isVisible());
        QTest::mouseClick(add, Qt::LeftButton);
        QVERIFY(!fixture.section->isFolded());
        QCOMPARE(fixture.list->model()->rowCount(), 2);
        QCOMPARE(fixture.workspace.activeLayer(), 2);
        QCOMPARE(fixture.session().document().layers.back().name, QStringLiteral("Sculpt 2"));
        // All back as at the first start.
        fixture.window.resetPanels();
        QVERIFY(fixture.section->isFolded());
    }

    void theEyeMutesAndTheNameChooses()
    {
        Fixture fixture;
        fixture.section->setFolded(false);
        fixture.apply(core::AddLayer{.name = QStringLiteral("Approach")});
        const auto rows = [&fixture] { return fixture.session().history().rows().size(); };
        QCOMPARE(fixture.workspace.activeLayer(), 1);
        fixture.clickEye(1);
        QVERIFY(fixture.session().document().layer(2)->muted);
        QCOMPARE(fixture.panel->summary(), QStringLiteral("1 of 2 muted"));
        QCOMPARE(fixture.workspace.activeLayer(), 1); // muting is not choosing
        QCOMPARE(rows(), std::size_t(2));
        fixture.clickEye(1);
        QVERIFY(!fixture.session().document().layer(2)->muted);
        fixture.clickEye(1, Qt::ControlModifier);
        QVERIFY(fixture.session().document().layer(2)->solo);
        QCOMPARE(fixture.panel->summary(), QStringLiteral("1 of 2 solo"));
        fixture.clickEye(1, Qt::ControlModifier);
        QVERIFY(!fixture.session().document().layer(2)->solo);

        QTest::mouseClick(fixture.list->viewport(), Qt::LeftButton, {},
            fixture.list->visualRect(fixture.list->model()->index(1, 0)).center());
        QCOMPARE(fixture.workspace.activeLayer(), 2);
        QCOMPARE(rows(), std::size_t(5)); // choosing is no step

        QVERIFY(fixture.list->model()->setData(
            fixture.list->model()->index(1, 0), QStringLiteral(" Way in "), Qt::EditRole));
        QCOMPARE(fixture.session().document().layer(2)->name, QStringLiteral("Way in"));
        QVERIFY(!fixture.list->model()->setData(
            fixture.list->model()->index(1, 0), QStringLiteral("Way in"), Qt::EditRole));
        QCOMPARE(rows(), std::size_t(6));
    }

    void layersBecomeSegmentsAndBack()
    {
        Fixture fixture;
        fixture.apply(test::drillAt(0));
        ui::layerToSegment(fixture.workspace, 1, std::nullopt);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().document().segments.size(), std::size_t(1));
        QCOMPARE(fixture.session().document().segments[0].name, QStringLiteral("Sculpt 1"));
        QVERIFY(fixture.session().document().segments[0].voxels > 0);
        QCOMPARE(fixture.workspace.activeSegment(), 1);
        fixture.apply(core::AddLayer{.name = QStringLiteral("Approach")});
        ui::segmentToLayer(fixture.workspace, 1, 2);
        ui::mergeLayers(fixture.workspace, 1, 2);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().document().layers.size(), std::size_t(1));
        QCOMPARE(fixture.workspace.activeLayer(), 2);

        ui::segmentWhatIsSeen(fixture.workspace, std::nullopt);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().document().segments.size(), std::size_t(2));
        QCOMPARE(fixture.workspace.activeSegment(), 2);
        const std::size_t rows = fixture.session().history().rows().size();
        ui::Workspace::VolumeDisplay display = fixture.workspace.volumeDisplay();
        display.mode = gpu::RenderMode::Mip;
        fixture.workspace.setVolumeDisplay(display);
        const QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        ui::segmentWhatIsSeen(fixture.workspace, std::nullopt);
        QCOMPARE(said.size(), 1); // why not
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().history().rows().size(), rows);

        fixture.apply(core::AddLayer{.name = QStringLiteral("Third")});
        fixture.workspace.setActiveLayer(3);
        ui::removeLayer(fixture.workspace, 3);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.workspace.activeLayer(), 2);
    }

    /// What the cutting plane hides in the 3D view is not seen, and gets no segment.
    void whatThePlaneHidesIsNotSeen()
    {
        test::WindowFixture fixture(test::smallHead::volume());
        ui::Workspace::VolumeDisplay display = fixture.workspace.volumeDisplay();
        display.mode = gpu::RenderMode::Surface;
        display.surfaceThreshold = 300.0; // the bone
        fixture.workspace.setVolumeDisplay(display);
        ui::CuttingPlane& plane = fixture.workspace.plane();
        const ui::CuttingPlane::Pose pose = plane.pose(); // axial, between the middle slices
        const auto sides = [&](int label) {
            std::pair<int, int> count; // of voxels above and below the plane
            for (const std::array<int, 3>& voxel : fixture.voxels(label)) {
                const glm::dvec3 place = fixture.place({voxel[0], voxel[1], voxel[2]});
                const bool above = glm::dot(place - pose.centreLps, pose.normalLps()) < 0.0;
                ++(above ? count.first : count.second);
            }
            return count;
        };
        const auto isSeen = [&] {
            ui::segmentWhatIsSeen(fixture.workspace, std::nullopt);
            return fixture.session().settle().has_value();
        };
        plane.setLook({.shown = true, .clipsAbove = true});
        QVERIFY(isSeen());
        const std::pair<int, int> half = sides(fixture.workspace.activeSegment());
        QCOMPARE(half.first, 0);
        QVERIFY(half.second > 1000);
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());
        plane.setLook({.shown = true, .clipsAbove = false});
        QVERIFY(isSeen());
        const std::pair<int, int> whole = sides(fixture.workspace.activeSegment());
        QVERIFY(whole.first > 1000);
        QCOMPARE(whole.second, half.second);
    }

    void followsUndo()
    {
        Fixture fixture;
        fixture.section->setFolded(false);
        const QAbstractItemModelTester tester(
            fixture.list->model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
        fixture.panel->actions().front()->trigger();
        fixture.apply(core::MoveLayer{.layer = 2, .place = 1});
        QCOMPARE(fixture.list->model()->index(0, 0).data().toString(), QStringLiteral("Sculpt 2"));
        QCOMPARE(fixture.list->currentIndex().row(), 0);
        QVERIFY(fixture.session().goTo(0));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.list->model()->rowCount(), 1);
        QCOMPARE(fixture.workspace.activeLayer(), 1);
    }

    void strokesGoIntoTheActiveLayer()
    {
        Fixture fixture;
        ui::DrillTool tool(fixture.workspace);
        ui::VolumeView& view = fixture.window.views().volume();
        view.lookFrom({0.0, -1.0, 0.0});
        fixture.apply(core::AddLayer{.name = QStringLiteral("Approach")});
        QCOMPARE(tool.target(), QStringLiteral("carves layer Sculpt 1"));
        fixture.workspace.setActiveLayer(2);
        QCOMPARE(tool.target(), QStringLiteral("carves layer Approach"));
        fixture.apply(core::ChangeLayer{.layer = 2, .muted = true});
        QCOMPARE(tool.target(), QStringLiteral("layer Approach is muted"));
    }

    void aPictureForTheEye()
    {
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (folder.isEmpty())
            QSKIP("BURIN_SCREENSHOTS names no folder");
        Fixture fixture;
        fixture.section->setFolded(false);
        fixture.apply(core::AddLayer{.name = QStringLiteral("Approach from the left, very long")});
        fixture.apply(core::AddLayer{.name = QStringLiteral("Orbit")});
        fixture.apply(core::ChangeLayer{.layer = 1, .muted = true});
        fixture.apply(core::ChangeLayer{.layer = 2, .solo = true});
        fixture.workspace.setActiveLayer(2);
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        QVERIFY(fixture.section->grab().save(QDir(folder).filePath(QStringLiteral("layers.png"))));
        fixture.apply(core::ChangeLayer{.layer = 2, .muted = true});
        QCoreApplication::sendPostedEvents();
        QVERIFY(fixture.section->grab().save(
            QDir(folder).filePath(QStringLiteral("layers-muted.png"))));
    }
};

BURIN_WINDOW_TEST(LayersPanelUiTest)

} // namespace layersPanelUiTest

#include "LayersPanelUiTest.moc"
