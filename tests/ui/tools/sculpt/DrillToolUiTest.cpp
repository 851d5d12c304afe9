// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/sculpt/DrillTool.h"

#include "core/edits/EditJson.h"
#include "core/edits/EditQuantise.h"
#include "core/edits/kinds/parts/PenSample.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/tools/aim/DrillSurface.h"
#include "ui/tools/sculpt/DrillOptions.h"
#include "ui/views/ViewGrid.h"

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QJsonDocument>
#include <QLabel>
#include <QtTest>

namespace drillToolUiTest {

namespace {

/// The real window with the small head and the drill in hand.
class DrillFixture : public test::WindowFixture {
public:
    DrillFixture()
        : test::WindowFixture(test::smallHead::volume())
        , tool(workspace)
        , view(window.views().volume())
    {
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.surfaceThreshold = 300.0;
        workspace.setVolumeDisplay(display);
        workspace.setDrillSettings({3.0, 6.0, false});
        workspace.setActiveTool(&tool);
        view.lookFrom({0.0, -1.0, 0.0});
    }
    [[nodiscard]] QPointF middle() const { return QPointF(view.width(), view.height()) / 2.0; }

    ui::DrillTool tool;
    ui::VolumeView& view;
};

struct Reading {
    QPointF offset; ///< logical pixels from the view's middle
    double pressure = 1.0;
    quint64 milliseconds = 0;
};

const std::vector<Reading> stroke{{{0.0, 0.0}, 0.25, 70000}, {{6.5, 2.0}, 0.5, 70008},
    {{14.25, 3.5}, 0.875, 70017}, {{22.0, 1.0}, 1.0, 70025}, {{30.0, -4.0}, 0.6, 70033}};

void draw(DrillFixture& fixture, test::Pen& pen)
{
    for (std::size_t i = 0; i < stroke.size(); ++i) {
        const QPointF at = fixture.middle() + stroke[i].offset;
        if (i == 0)
            pen.press(at, stroke[i].pressure, stroke[i].milliseconds);
        else
            pen.move(at, stroke[i].pressure, stroke[i].milliseconds);
    }
}

QByteArray canonical(const core::Edit& edit)
{
    return QJsonDocument(core::editToJson(core::quantised(edit))).toJson(QJsonDocument::Compact);
}

} // namespace

class DrillToolUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// Where a stroke starts is what its view shows, and the option bar says so.
    void startsAtWhatIsSeen()
    {
        DrillFixture fixture;
        const core::Volume& volume = *fixture.workspace.volume();
        ui::DrillOptions options(fixture.workspace, ui::DrillOptions::Of::Drill);
        const auto* start = options.findChild<QLabel*>(QStringLiteral("drillStart"));
        QCOMPARE(start->text(), QStringLiteral("from 300 HU on"));
        ui::Workspace::VolumeDisplay display = fixture.workspace.volumeDisplay();
        display.mode = gpu::RenderMode::Mip;
        fixture.workspace.setVolumeDisplay(display);
        QCOMPARE(start->text(), QStringLiteral("from 300 HU on"));
        QVERIFY(start->toolTip().contains(QStringLiteral("no surface")));
        // Half of what is behind 3 mm shows at an opacity of 1 - 0.5^(1/3) = 0.2063 per mm.
        display.mode = gpu::RenderMode::Dvr;
        display.transferFunction.points = {{-100.0, 0, 0.0}, {100.0, 0, 0.0}, {200.0, 0, 1.0}};
        fixture.workspace.setVolumeDisplay(display);
        QVERIFY(std::abs(ui::drillThreshold(display, volume) - 120.63) < 0.01);
        QCOMPARE(start->text(), QStringLiteral("from 121 HU on"));
        test::Pen pen(fixture.view);
        draw(fixture, pen);
        pen.release(fixture.middle() + stroke.back().offset, 70041);
        QVERIFY(fixture.session().settle());
        const auto& edit = fixture.session().history().rows().back().edit.get<core::DrillStroke>();
        QVERIFY(std::abs(edit.surfaceThreshold - 120.63) < 0.01);

        const auto at = [&](std::vector<gpu::TransferFunction::Point> points) {
            display.transferFunction.points = std::move(points);
            return ui::drillThreshold(display, volume);
        };
        // A thin veil counts by half of what it has; what is opaque from below on starts there.
        QCOMPARE(at({{0.0, 0, 0.0}, {100.0, 0, 0.1}}), 50.0);
        QCOMPARE(at({{0.0, 0, 0.9}, {100.0, 0, 0.9}}), volume.minimum);
        QCOMPARE(at({{0.0, 0, 0.0}, {100.0, 0, 0.0}}), display.surfaceThreshold);
        QCOMPARE(at({}), display.surfaceThreshold);
    }

    void aPenStrokeIsTheEditOfARecipe()
    {
        DrillFixture fixture;
        const ui::ViewContext context = fixture.view.context();
        test::Pen pen(fixture.view);
        pen.hover(fixture.middle(), 69990);
        draw(fixture, pen);
        pen.release(fixture.middle() + stroke.back().offset, 70041);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().history().position(), core::RowId(1));

        // The same stroke as a recipe would say it, from the view's numbers alone.
        const auto& scene = std::get<gpu::VolumeScene>(context.scene);
        core::DrillStroke expected;
        expected.view = {scene.eyeLps, scene.targetLps, scene.up, scene.heightMm};
        expected.mask.radiusMm = 3.0;
        expected.depthMm = 6.0;
        expected.surfaceThreshold = 300.0;
        expected.guardMm = 5.0;
        expected.byTime = true;
        const double mmPerPixel = scene.heightMm / fixture.view.height();
        for (const Reading& reading : stroke)
            expected.samples.push_back({reading.offset.x() * mmPerPixel,
                -reading.offset.y() * mmPerPixel, reading.pressure,
                double(reading.milliseconds - stroke.front().milliseconds) / 1000.0});
        QCOMPARE(canonical(fixture.session().history().row(1).edit), canonical(expected));
        QVERIFY(fixture.carvedVoxels() > 50);

        // And the voxels are those of the recipe, hash for hash.
        const QByteArray hash = fixture.session().stateHash();
        test::WorkspaceFixture recipe;
        recipe.apply(expected);
        QCOMPARE(recipe.session().stateHash(), hash);
    }

    void theCutShowsWhileThePenIsDown()
    {
        DrillFixture fixture;
        test::Pen pen(fixture.view);
        draw(fixture, pen);
        fixture.session().poll();
        QVERIFY(fixture.session().transactionOpen());
        QVERIFY(fixture.carvedVoxels() > 50);
        QCOMPARE(fixture.session().history().position(), core::RowId(0));
    }

    void theEraserEndRestores()
    {
        DrillFixture fixture;
        test::Pen pen(fixture.view);
        draw(fixture, pen);
        pen.release(fixture.middle() + stroke.back().offset, 70041);
        QVERIFY(fixture.session().settle());
        const std::int64_t carved = fixture.carvedVoxels();
        test::Pen eraser(fixture.view, test::Pen::End::Eraser);
        draw(fixture, eraser);
        eraser.release(fixture.middle() + stroke.back().offset, 70041);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.session().history().rows().back().edit.get<core::DrillStroke>().restore);
        QVERIFY(fixture.carvedVoxels() < carved);
    }

    void shapesAndModesAreChosen()
    {
        DrillFixture fixture;
        ui::DrillOptions options(fixture.workspace, ui::DrillOptions::Of::Drill);
        options.show();
        auto* shape = options.findChild<QComboBox*>(QStringLiteral("drillShape"));
        auto* turn = options.findChild<QDoubleSpinBox*>(QStringLiteral("drillTurn"));
        QVERIFY(turn->isHidden());
        shape->setCurrentIndex(int(core::ToolMask::Kind::Rectangle));
        QVERIFY(!turn->isHidden());
        turn->setValue(30.0);
        options.findChild<QDoubleSpinBox*>(QStringLiteral("drillHeight"))->setValue(40.0);
        options.findChild<QComboBox*>(QStringLiteral("drillMode"))->setCurrentIndex(1);
        const core::DrillStroke made = fixture.tool.strokeIn(fixture.view.context());
        QCOMPARE(made.mask.widthMm, 6.0);
        QCOMPARE(made.mask.heightMm, 0.4 * 6.0);
        QCOMPARE(made.mask.rotationDegrees, 30.0);
        QCOMPARE(made.mode, core::DrillMode::Rate);
    }

    /// The mask is the stroke's as the pen was held when it went down; replay needs no pen.
    void theMaskFollowsThePen_data()
    {
        using Kind = core::ToolMask::Kind;
        QTest::addColumn<bool>("tellsRotation");
        QTest::addColumn<QPointF>("tilt");
        QTest::addColumn<bool>("follows");
        QTest::addColumn<bool>("foreshortened");
        QTest::addColumn<int>("shape");
        QTest::addColumn<double>("turned"); // 999: foreshortened to an outline
        QTest::addColumn<QSizeF>("size");
        const QSizeF whole(6.0, 3.0);
        const auto row = [](const char* name, bool rotates, const QPointF& tilt, bool follows,
                             bool foreshortened, Kind shape, double turned, const QSizeF& size) {
            QTest::newRow(name) << rotates << tilt << follows << foreshortened << int(shape)
                                << turned << size;
        };
        const Kind rectangle = Kind::Rectangle;
        // The pen is turned by 25° to the right, the mask by 10° to the left beforehand.
        row("rotation", true, {0.0, 0.0}, true, false, rectangle, -15.0, whole);
        row("rotation before tilt", true, {0.0, -40.0}, true, false, rectangle, -15.0, whole);
        row("not followed", true, {0.0, -40.0}, false, false, rectangle, 10.0, whole);
        row("leans away", false, {0.0, -40.0}, true, false, rectangle, 100.0, whole);
        row("leans left", false, {-40.0, 0.0}, true, false, rectangle, -170.0, whole);
        row("hardly leans", false, {-4.0, 5.0}, true, false, rectangle, 10.0, whole);
        row("upright", false, {0.0, 0.0}, true, true, rectangle, 10.0, whole);
        row("foreshortened circle", false, {0.0, 60.0}, true, true, Kind::Circle, -90.0,
            {3.0, 6.0});
        row("foreshortened, not turned", false, {60.0, 0.0}, false, true, Kind::Circle, 0.0,
            {3.0, 6.0});
        // A square of 6 mm turned by 10°, half as wide: max |x| is 3 (cos 10° + sin 10°) / 2.
        row("foreshortened square", false, {60.0, 0.0}, false, true, Kind::Square, 999.0,
            {2.0 * 1.7377, 2.0 * 3.4754});
    }
    void theMaskFollowsThePen()
    {
        QFETCH(bool, tellsRotation);
        QFETCH(QPointF, tilt);
        QFETCH(bool, follows);
        QFETCH(bool, foreshortened);
        QFETCH(int, shape);
        QFETCH(double, turned);
        QFETCH(QSizeF, size);
        DrillFixture fixture;
        ui::Workspace::DrillSettings settings = fixture.workspace.drillSettings();
        settings.shape = core::ToolMask::Kind(shape);
        settings.heightRatio = 0.5;
        settings.rotationDegrees = 10.0;
        settings.turnsWithPen = follows;
        settings.foreshortened = foreshortened;
        fixture.workspace.setDrillSettings(settings);
        test::Pen pen(fixture.view, test::Pen::End::Tip,
            tellsRotation ? test::Pen::Turns::Yes : test::Pen::Turns::No);
        pen.hold(tilt, tellsRotation ? 25.0 : 0.0);
        draw(fixture, pen);
        pen.hold({}, 0.0); // later the hand may move
        pen.release(fixture.middle() + stroke.back().offset, 70041);
        QVERIFY(fixture.session().settle());
        const auto edit = fixture.session().history().row(1).edit.get<core::DrillStroke>();
        if (turned == 999.0) {
            QVERIFY(edit.mask.polygonMm);
            glm::dvec2 reach(0.0);
            for (const glm::dvec2& point : *edit.mask.polygonMm)
                reach = glm::max(reach, glm::abs(point));
            QVERIFY(std::abs(2.0 * reach.x - size.width()) < 0.01);
            QVERIFY(std::abs(2.0 * reach.y - size.height()) < 0.01);
        } else {
            QVERIFY(!edit.mask.polygonMm);
            QVERIFY2(std::abs(edit.mask.rotationDegrees - turned) < 1e-6,
                qPrintable(QString::number(edit.mask.rotationDegrees)));
            QVERIFY(std::abs(edit.mask.widthMm - size.width()) < 1e-3);
            QVERIFY(std::abs(edit.mask.heightMm - size.height()) < 1e-3);
        }
        const QByteArray hash = fixture.session().stateHash();
        test::WorkspaceFixture recipe;
        recipe.apply(edit);
        QCOMPARE(recipe.session().stateHash(), hash);
    }

    /// In mode Rate a pen that rests reports nothing, and goes deeper.
    void aRestingPenGoesDeeper()
    {
        DrillFixture fixture;
        ui::Workspace::DrillSettings settings = fixture.workspace.drillSettings();
        settings.mode = core::DrillMode::Rate;
        settings.depthMm = 2.0;
        fixture.workspace.setDrillSettings(settings);
        // Through all of the head: at this rate no pause of a busy machine comes to the floor.
        ui::Workspace::VolumeDisplay display = fixture.workspace.volumeDisplay();
        display.surfaceThreshold = 0.0;
        fixture.workspace.setVolumeDisplay(display);
        test::Pen pen(fixture.view);
        pen.press(fixture.middle(), 1.0, 70000);
        constexpr int patience = 60000; // ms; only a hang takes that long
        QTRY_VERIFY_WITH_TIMEOUT(fixture.carvedVoxels() > 0, patience);
        const std::int64_t before = fixture.carvedVoxels();
        QTRY_VERIFY_WITH_TIMEOUT(fixture.carvedVoxels() > before, patience);
        pen.release(fixture.middle(), 71000);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().history().position(), core::RowId(1));
    }

    void escapeTakesTheStrokeBack()
    {
        DrillFixture fixture;
        test::Pen pen(fixture.view);
        draw(fixture, pen);
        QTest::keyClick(&fixture.view, Qt::Key_Escape);
        pen.release(fixture.middle(), 70050);
        QVERIFY(fixture.session().settle());
        QVERIFY(!fixture.session().transactionOpen());
        QCOMPARE(fixture.carvedVoxels(), 0);
        QVERIFY(fixture.session().history().rows().empty());
    }

    void theViewOfPenDownHolds()
    {
        DrillFixture fixture;
        test::Pen pen(fixture.view);
        const auto scene = std::get<gpu::VolumeScene>(fixture.view.context().scene);
        pen.press(fixture.middle(), 1.0, 10);
        fixture.view.lookFrom({1.0, 0.0, 0.0});
        pen.move(fixture.middle() + QPointF(10, 0), 1.0, 20);
        pen.release(fixture.middle() + QPointF(10, 0), 30);
        QVERIFY(fixture.session().settle());
        const auto& edit = fixture.session().history().row(1).edit.get<core::DrillStroke>();
        QVERIFY(glm::length(edit.view.eyeLps - scene.eyeLps) < 1e-3);
        const double mmPerPixel = scene.heightMm / fixture.view.height();
        QVERIFY(std::abs(edit.samples.back().xMm - 10.0 * mmPerPixel) < 1e-3);
    }

    void aMousePressesFully()
    {
        DrillFixture fixture;
        const core::WindowLevel window = fixture.workspace.windowLevel();
        QTest::mousePress(&fixture.view, Qt::LeftButton, {}, fixture.middle().toPoint());
        QTest::mouseMove(&fixture.view, fixture.middle().toPoint() + QPoint(12, 5));
        QTest::mouseRelease(
            &fixture.view, Qt::LeftButton, {}, fixture.middle().toPoint() + QPoint(12, 5));
        QVERIFY(fixture.session().settle());
        const auto& edit = fixture.session().history().row(1).edit.get<core::DrillStroke>();
        for (const core::PenSample& sample : edit.samples)
            QCOMPARE(sample.pressure, 1.0);
        QVERIFY(fixture.workspace.windowLevel() == window);
    }

    void slicesAreNotDrilledInto()
    {
        DrillFixture fixture;
        QWidget& slice = fixture.window.views().axial();
        test::Pen pen(slice);
        const QPointF at = QPointF(slice.width(), slice.height()) / 2.0;
        pen.press(at, 1.0, 10);
        pen.release(at, 20);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.session().history().rows().empty());
    }

    void aStrokeEndsWithItsSession()
    {
        DrillFixture fixture;
        test::Pen pen(fixture.view);
        pen.press(fixture.middle(), 1.0, 10);
        fixture.workspace.setSession(nullptr);
        pen.move(fixture.middle() + QPointF(5, 0), 1.0, 20);
        pen.release(fixture.middle() + QPointF(5, 0), 30);
        fixture.tool.cancel();
        QVERIFY(!fixture.workspace.session());
    }

    void theEraserEndDoesNotCut()
    {
        DrillFixture fixture;
        test::Pen pen(fixture.view, test::Pen::End::Eraser);
        draw(fixture, pen);
        pen.release(fixture.middle(), 70050);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.session().history().rows().empty());
    }

    void keysAndWheelSetTheMask()
    {
        DrillFixture fixture;
        const auto wheel = [&fixture](Qt::KeyboardModifiers modifiers) {
            QWheelEvent event(fixture.middle(), fixture.view.mapToGlobal(fixture.middle()), {},
                {0, 120}, Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
            QApplication::sendEvent(&fixture.view, &event);
        };
        wheel(Qt::ShiftModifier);
        QCOMPARE(fixture.workspace.drillSettings().radiusMm, 3.5);
        wheel(Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(fixture.workspace.drillSettings().depthMm, 6.5);
        QCOMPARE(fixture.workspace.drillSettings().radiusMm, 3.5);
        // Window managers take Alt: with it, the wheel does what it does without.
        const double rotation = fixture.workspace.drillSettings().rotationDegrees;
        wheel(Qt::AltModifier);
        QCOMPARE(fixture.workspace.drillSettings().depthMm, 6.5);
        wheel(Qt::AltModifier | Qt::ShiftModifier);
        QCOMPARE(fixture.workspace.drillSettings().radiusMm, 4.0);
        QCOMPARE(fixture.workspace.drillSettings().rotationDegrees, rotation);
        const double mmPerPixel = fixture.view.context().mmPerPixel();
        wheel(Qt::ControlModifier);
        QCOMPARE(fixture.workspace.drillSettings().rotationDegrees, rotation + 5.0);
        QCOMPARE(fixture.view.context().mmPerPixel(), mmPerPixel); // it did not zoom
        fixture.tool.changeRadius(-100);
        QCOMPARE(fixture.workspace.drillSettings().radiusMm, ui::DrillOptions::minimumRadiusMm);

        auto* radius = fixture.window.findChild<QDoubleSpinBox*>(QStringLiteral("drillRadius"));
        QVERIFY(radius);
        QCOMPARE(radius->value(), ui::DrillOptions::minimumRadiusMm);
        radius->setValue(12.0);
        QCOMPARE(fixture.workspace.drillSettings().radiusMm, 12.0);
    }
};

BURIN_WINDOW_TEST(DrillToolUiTest)

} // namespace drillToolUiTest

#include "DrillToolUiTest.moc"
