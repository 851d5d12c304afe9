// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditJson.h"
#include "core/edits/EditQuantise.h"
#include "core/edits/kinds/layers/ChangeLayer.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/tools/common/SeedOptions.h"
#include "ui/tools/growth/PaintTool.h"
#include "ui/tools/sculpt/CarveBrushTool.h"
#include "ui/views/ViewGrid.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QJsonDocument>
#include <QStyleOptionComboBox>
#include <QToolButton>
#include <QtTest>

#include <cmath>
#include <set>

namespace brushToolsUiTest {

namespace {

using Brush = ui::Workspace::Brush;
using core::BrushPath;

/// The real window with the small head; the 3D view looks at its bone from the front.
class BrushFixture : public test::WindowFixture {
public:
    explicit BrushFixture(Brush brush)
        : test::WindowFixture(test::smallHead::volume())
        , paint(workspace)
        , carve(workspace)
        , slice(window.views().axial())
        , view(window.views().volume())
    {
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.surfaceThreshold = 300.0;
        workspace.setVolumeDisplay(display);
        workspace.setBrushSettings(Brush::Paint, {.radiusMm = 3.0, .disc = true});
        workspace.setBrushSettings(Brush::Carve, {.radiusMm = 3.0});
        workspace.setActiveTool(brush == Brush::Paint ? static_cast<ui::Tool*>(&paint) : &carve);
        view.lookFrom({0.0, -1.0, 0.0});
    }
    [[nodiscard]] static QPointF middleOf(const QWidget& widget)
    {
        return QPointF(widget.width(), widget.height()) / 2.0;
    }
    [[nodiscard]] const core::Edit& lastEdit()
    {
        return session().history().row(session().history().position()).edit;
    }
    /// Voxels that hold something, in a field of bytes.
    [[nodiscard]] std::set<std::array<int, 3>> voxels(
        core::Field field, std::uint8_t plane, int least)
    {
        std::set<std::array<int, 3>> found;
        const core::BrickGrid grid{workspace.volume()->geometry.size};
        std::vector<core::BrickKey> keys;
        for (int brick = 0; brick < grid.brickCount(); ++brick)
            keys.push_back({field, plane, std::uint32_t(brick)});
        const auto take = [&](const core::Result<std::vector<core::BrickImage>>& bricks) {
            for (const core::BrickImage& brick : *bricks) {
                const core::VoxelBox box = grid.boxOf(int(brick.key.brick));
                for (int z = box.minimum.z; z < box.maximum.z && !brick.bytes.empty(); ++z)
                    for (int y = box.minimum.y; y < box.maximum.y; ++y)
                        for (int x = box.minimum.x; x < box.maximum.x; ++x)
                            if (brick.bytes
                                    .read()[std::size_t(core::BrickGrid::offsetInBrick({x, y, z}))]
                                >= least)
                                found.insert({x, y, z});
            }
        };
        session().questions().bricks(std::move(keys), take);
        session().poll();
        return found;
    }
    [[nodiscard]] auto painted() { return voxels(core::Field::Labels, 0, 1); }
    [[nodiscard]] auto carved() { return voxels(core::Field::Coverage, 1, 128); }

    ui::PaintTool paint;
    ui::CarveBrushTool carve;
    ui::SliceView& slice;
    ui::VolumeView& view;
};

struct Reading {
    QPointF offset; ///< logical pixels from the view's middle
    quint64 milliseconds = 0;
};

const std::vector<Reading> stroke{
    {{0.0, 0.0}, 70000}, {{6.5, 2.0}, 70008}, {{24.25, 9.5}, 70017}, {{42.0, 1.0}, 70025}};

void draw(BrushFixture& fixture, QWidget& widget, test::Pen& pen,
    const std::vector<Reading>& readings = stroke)
{
    const QPointF middle = BrushFixture::middleOf(widget);
    for (std::size_t i = 0; i < readings.size(); ++i) {
        if (i == 0)
            pen.press(middle + readings[i].offset, 0.5, readings[i].milliseconds);
        else
            pen.move(middle + readings[i].offset, 0.5, readings[i].milliseconds);
        fixture.session().poll();
    }
}

void lift(BrushFixture& fixture, QWidget& widget, test::Pen& pen)
{
    pen.release(BrushFixture::middleOf(widget) + stroke.back().offset, 70100);
    fixture.session().poll();
    QVERIFY(fixture.session().settle());
}

/// A straight way from left to right over the middle, in so many readings, resting in between.
std::vector<Reading> across(double halfPixels, int readings)
{
    std::vector<Reading> way;
    for (int i = 0; i <= readings; ++i) {
        const QPointF at(halfPixels * (2.0 * i / readings - 1.0), 0.0);
        for (int rest = 0; rest < 3; ++rest)
            way.push_back({at, 80000 + quint64(way.size()) * 4});
    }
    return way;
}

QByteArray canonical(const core::Edit& edit)
{
    return QJsonDocument(core::editToJson(core::quantised(edit))).toJson(QJsonDocument::Compact);
}

} // namespace

class BrushToolsUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aPenStrokeOnASliceIsTheEditOfARecipe()
    {
        BrushFixture fixture(Brush::Paint);
        const ui::ViewContext context = fixture.slice.context();
        test::Pen pen(fixture.slice);
        pen.hover(BrushFixture::middleOf(fixture.slice), 69990);
        draw(fixture, fixture.slice, pen);
        QVERIFY(fixture.session().transactionOpen());
        QVERIFY(fixture.painted().size() > 30); // it shows while the pen is down
        lift(fixture, fixture.slice, pen);
        // A segment for it, and the stroke.
        QCOMPARE(fixture.session().history().position(), core::RowId(2));

        const auto& scene = std::get<gpu::SliceScene>(context.scene);
        core::PaintStroke expected{.segment = 1};
        expected.path.radiusMm = 3.0;
        expected.path.shape = BrushPath::Shape::Disc;
        expected.path.normalLps = glm::cross(scene.rightLps, scene.downLps);
        for (const Reading& reading : stroke)
            expected.path.pointsLps.push_back(scene.centreLps
                + scene.mmPerPixel
                    * (scene.rightLps * reading.offset.x() + scene.downLps * reading.offset.y()));
        QCOMPARE(canonical(fixture.lastEdit()), canonical(expected));
        const auto voxels = fixture.painted();
        for (const auto& voxel : voxels)
            QCOMPARE(voxel[2], (*voxels.begin())[2]); // of one slice

        test::WorkspaceFixture recipe;
        recipe.apply(fixture.session().history().row(1).edit);
        recipe.apply(expected);
        QCOMPARE(recipe.session().stateHash(), fixture.session().stateHash());
    }

    /// A square's sides are the view's; the eraser end takes it away as the mouse's Ctrl does.
    void aSquareOnASliceHasTheSidesOfTheView()
    {
        BrushFixture fixture(Brush::Paint);
        auto* shape = fixture.window.findChild<QComboBox*>(QStringLiteral("brushShape"));
        QVERIFY(shape);
        const int squareIndex = shape->findText(QStringLiteral("square"));
        shape->setCurrentIndex(squareIndex);
        Q_EMIT shape->activated(squareIndex);
        QVERIFY(fixture.workspace.brushSettings(Brush::Paint).square);
        QVERIFY(fixture.workspace.brushSettings(Brush::Paint).disc);
        ui::Workspace::BrushSettings settings = fixture.workspace.brushSettings(Brush::Paint);
        settings.radiusMm = 3.3; // no edge on the middle of a voxel
        fixture.workspace.setBrushSettings(Brush::Paint, settings);
        const QPointF middle = BrushFixture::middleOf(fixture.slice);
        {
            test::Pen pen(fixture.slice);
            pen.press(middle, 0.5, 70000);
            pen.release(middle, 70100);
        }
        QVERIFY(fixture.session().settle());
        const auto edit = fixture.lastEdit().get<core::PaintStroke>();
        QVERIFY(edit.path.shape == BrushPath::Shape::Square);
        const auto scene = std::get<gpu::SliceScene>(fixture.slice.context().scene);
        QVERIFY(glm::distance(*edit.path.sideLps, glm::normalize(scene.rightLps)) < 1e-3);
        // Voxels of one slice, as many as lie within the half side along both axes of the view.
        const auto voxels = fixture.painted();
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        std::set<std::array<int, 3>> expected;
        const int z = (*voxels.begin())[2];
        for (int y = 0; y < geometry.size.y; ++y) {
            for (int x = 0; x < geometry.size.x; ++x) {
                const glm::dvec3 way = geometry.toWorld({x, y, z}) - edit.path.pointsLps.front();
                const double half =
                    std::max(std::abs(glm::dot(way, glm::normalize(scene.rightLps))),
                        std::abs(glm::dot(way, glm::normalize(scene.downLps))));
                QVERIFY(std::abs(half - 3.3) > 1e-3); // there rounding would decide
                if (half < 3.3)
                    expected.insert({x, y, z});
            }
        }
        QVERIFY(expected.size() > 8);
        QCOMPARE(voxels, expected);

        // Its corners are taken away by a square, not by a disc of that radius.
        settings.square = false;
        fixture.workspace.setBrushSettings(Brush::Paint, settings);
        QCOMPARE(shape->currentText(), QStringLiteral("disc"));
        QTest::mouseClick(&fixture.slice, Qt::LeftButton, Qt::ControlModifier, middle.toPoint());
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.lastEdit().get<core::PaintStroke>().erase);
        QVERIFY(!fixture.painted().empty());
        QVERIFY(fixture.painted().size() < voxels.size());
        settings.square = true;
        fixture.workspace.setBrushSettings(Brush::Paint, settings);
        test::Pen eraser(fixture.slice, test::Pen::End::Eraser);
        eraser.press(middle, 0.5, 71000);
        eraser.release(middle, 71100);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.painted().empty());
        // A cube goes through more slices than one; in the 3D view all brushes are balls.
        settings.disc = false;
        fixture.workspace.setBrushSettings(Brush::Paint, settings);
        QCOMPARE(shape->currentText(), QStringLiteral("cube"));
        QTest::mouseClick(&fixture.slice, Qt::LeftButton, {}, middle.toPoint());
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.lastEdit().get<core::PaintStroke>().path.shape == BrushPath::Shape::Cube);
        QVERIFY(fixture.painted().size() > 2 * voxels.size());
        test::Pen pen(fixture.view);
        draw(fixture, fixture.view, pen);
        lift(fixture, fixture.view, pen);
        QVERIFY(fixture.lastEdit().get<core::PaintStroke>().path.shape == BrushPath::Shape::Ball);
    }

    /// In the small head's ventricle (8 HU) the brush takes the ventricle, beside it the brain.
    void theBrushFollowsEdgesOnSlices()
    {
        BrushFixture fixture(Brush::Paint);
        auto* button = fixture.window.findChild<QToolButton*>(QStringLiteral("brushEdges"));
        auto* follows = fixture.window.findChild<QCheckBox*>(QStringLiteral("brushFollowsEdges"));
        auto* within =
            fixture.window.findChild<QDoubleSpinBox*>(QStringLiteral("brushEdgeTolerance"));
        QVERIFY(button && follows && within);
        QVERIFY(!button->isChecked() && !within->isEnabled());
        fixture.workspace.setWindowLevel({.centre = 40.0, .width = 300.0});
        follows->click();
        QVERIFY(button->isChecked() && within->isEnabled());
        QCOMPARE(fixture.workspace.brushSettings(Brush::Paint).edgeTolerance, 30.0);
        QVERIFY(within->suffix().endsWith(QStringLiteral("HU")));
        within->setValue(10.0);
        QVERIFY(button->toolTip().contains(QStringLiteral("±10 HU")));
        ui::Workspace::BrushSettings settings = fixture.workspace.brushSettings(Brush::Paint);
        QCOMPARE(settings.edgeTolerance, 10.0);
        settings.radiusMm = 9.0;
        fixture.workspace.setBrushSettings(Brush::Paint, settings);

        // From the ventricle into the brain: what is alike only lies in the ventricle.
        const QPointF middle = BrushFixture::middleOf(fixture.slice);
        const double perMm = 1.0 / fixture.slice.context().mmPerPixel();
        test::Pen pen(fixture.slice);
        pen.press(middle, 1.0, 70000);
        fixture.session().poll();
        pen.move(middle + QPointF(2.5 * perMm, 0.0), 1.0, 70010);
        fixture.session().poll();
        pen.move(middle + QPointF(8.0 * perMm, 0.0), 1.0, 70020);
        pen.release(middle + QPointF(8.0 * perMm, 0.0), 70100);
        QVERIFY(fixture.session().settle());
        const auto edit = fixture.lastEdit().get<core::PaintStroke>();
        QCOMPARE(edit.edgeTolerance.value_or(-1.0), 10.0);
        const auto ventricle = fixture.painted();
        QVERIFY(!ventricle.empty());
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        std::set<std::array<int, 3>> expected;
        for (int y = 0; y < geometry.size.y; ++y) {
            for (int x = 0; x < geometry.size.x; ++x) {
                const int z = (*ventricle.begin())[2];
                if (glm::length(geometry.toWorld({x, y, z})) < 5.0)
                    expected.insert({x, y, z});
            }
        }
        QCOMPARE(ventricle, expected);
        // The oracle comes to the same from a recipe.
        test::WorkspaceFixture recipe;
        recipe.apply(fixture.session().history().row(1).edit);
        recipe.apply(edit);
        QCOMPARE(recipe.session().stateHash(), fixture.session().stateHash());

        // The eraser end follows them, too: it begins in the brain and leaves the ventricle.
        const core::RowId row = fixture.session().history().position();
        const QPointF brain = middle + QPointF(8.0 * perMm, 0.0);
        {
            test::Pen eraser(fixture.slice, test::Pen::End::Eraser);
            eraser.press(brain, 1.0, 71000);
            eraser.release(brain, 71100);
        }
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().history().position(), row);
        // A mouse paints the brain around it; the cursor's label names the tolerance.
        QTest::mouseClick(&fixture.slice, Qt::LeftButton, {}, brain.toPoint());
        QVERIFY(fixture.session().settle());
        const auto both = fixture.painted();
        QVERIFY(both.size() > ventricle.size() + 50);
        for (const auto& voxel : both) {
            const double distance = glm::length(geometry.toWorld({voxel[0], voxel[1], voxel[2]}));
            QVERIFY(distance < 13.0); // no bone
        }
        QTest::mouseClick(&fixture.slice, Qt::LeftButton, Qt::ControlModifier, middle.toPoint());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.painted().size(), both.size() - ventricle.size());
        // In the 3D view it is a plain brush.
        test::Pen other(fixture.view);
        draw(fixture, fixture.view, other);
        lift(fixture, fixture.view, other);
        QVERIFY(!fixture.lastEdit().get<core::PaintStroke>().edgeTolerance);
        QVERIFY(fixture.window.minimumSizeHint().width() <= 1280);
    }

    /// Lightly pressed it takes the ventricle (8 HU), firmly the brain (40 HU) as well, with the
    /// same radius; a mouse presses fully.
    void thePressureIsTheTolerance()
    {
        BrushFixture fixture(Brush::Paint);
        auto* byPressure =
            fixture.window.findChild<QCheckBox*>(QStringLiteral("brushTolerancePressure"));
        auto* follows = fixture.window.findChild<QCheckBox*>(QStringLiteral("brushFollowsEdges"));
        QVERIFY(byPressure && !byPressure->isEnabled());
        follows->click();
        QVERIFY(byPressure->isEnabled() && !byPressure->isChecked());
        byPressure->click();
        ui::Workspace::BrushSettings settings = fixture.workspace.brushSettings(Brush::Paint);
        QVERIFY(settings.toleranceByPressure);
        settings.radiusMm = 9.0;
        settings.edgeTolerance = 60.0;
        fixture.workspace.setBrushSettings(Brush::Paint, settings);
        const QPointF middle = BrushFixture::middleOf(fixture.slice);
        const auto dab = [&](double pressure, unsigned long milliseconds) {
            test::Pen pen(fixture.slice);
            pen.press(middle, pressure, milliseconds);
            fixture.session().poll();
            pen.release(middle, milliseconds + 100);
            QVERIFY(fixture.session().settle());
        };
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        const auto within = [&](double distanceMm) {
            std::set<std::array<int, 3>> expected;
            const int z = (*fixture.painted().begin())[2];
            for (int y = 0; y < geometry.size.y; ++y) {
                for (int x = 0; x < geometry.size.x; ++x) {
                    if (glm::length(geometry.toWorld({x, y, z})) < distanceMm)
                        expected.insert({x, y, z});
                }
            }
            return expected;
        };
        dab(0.25, 70000);
        const auto light = fixture.lastEdit().get<core::PaintStroke>();
        QVERIFY(light.path.pressures && light.toleranceByPressure.value_or(false));
        QCOMPARE(light.path.radiusMm, 9.0);
        const auto ventricle = fixture.painted();
        QVERIFY(!ventricle.empty());
        QCOMPARE(ventricle, within(5.0));
        dab(1.0, 71000);
        const auto both = fixture.painted();
        QVERIFY(both.size() > ventricle.size() + 50);
        // The oracle comes to the same from a recipe.
        test::WorkspaceFixture recipe;
        recipe.apply(fixture.session().history().row(1).edit);
        recipe.apply(light);
        recipe.apply(fixture.lastEdit());
        QCOMPARE(recipe.session().stateHash(), fixture.session().stateHash());

        QTest::mouseClick(&fixture.slice, Qt::LeftButton, Qt::ControlModifier, middle.toPoint());
        QVERIFY(fixture.session().settle());
        QVERIFY(!fixture.lastEdit().get<core::PaintStroke>().toleranceByPressure);
        QVERIFY(!fixture.lastEdit().get<core::PaintStroke>().path.pressures);
    }

    void theEraserEndAndControlErase()
    {
        BrushFixture fixture(Brush::Paint);
        ui::Workspace::BrushSettings settings = fixture.workspace.brushSettings(Brush::Paint);
        settings.disc = false;
        fixture.workspace.setBrushSettings(Brush::Paint, settings);
        {
            test::Pen pen(fixture.slice);
            draw(fixture, fixture.slice, pen);
            lift(fixture, fixture.slice, pen);
        }
        const std::size_t painted = fixture.painted().size();
        QVERIFY(painted > 100); // a ball goes through more slices than one
        test::Pen eraser(fixture.slice, test::Pen::End::Eraser);
        draw(fixture, fixture.slice, eraser, {stroke[0]});
        eraser.release(BrushFixture::middleOf(fixture.slice), 70100);
        QVERIFY(fixture.session().settle());
        const std::size_t left = fixture.painted().size();
        QVERIFY(left < painted);
        QVERIFY(fixture.lastEdit().get<core::PaintStroke>().erase);

        const QPoint end = (BrushFixture::middleOf(fixture.slice) + stroke.back().offset).toPoint();
        QTest::mousePress(&fixture.slice, Qt::LeftButton, Qt::ControlModifier, end);
        QTest::mouseRelease(&fixture.slice, Qt::LeftButton, Qt::ControlModifier, end);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.painted().size() < left);
        // Where nothing is left nothing is done, and no entry says so.
        const core::RowId row = fixture.session().history().position();
        QTest::mousePress(&fixture.slice, Qt::LeftButton, Qt::ControlModifier, end);
        QTest::mouseRelease(&fixture.slice, Qt::LeftButton, Qt::ControlModifier, end);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().history().position(), row);
    }

    /// Erasing makes no segment, neither with Ctrl nor with the eraser end.
    void withoutASegmentNothingIsErased()
    {
        BrushFixture fixture(Brush::Paint);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const auto refused = [&] {
            fixture.session().poll();
            return fixture.session().settle() && fixture.session().history().rows().empty()
                && !fixture.session().transactionOpen() && !said.isEmpty()
                && said.takeLast()[0].toString() == QStringLiteral("There is no segment to erase");
        };
        for (QWidget* widget :
            {static_cast<QWidget*>(&fixture.slice), static_cast<QWidget*>(&fixture.view)}) {
            const QPointF middle = BrushFixture::middleOf(*widget);
            QTest::mouseClick(widget, Qt::LeftButton, Qt::ControlModifier, middle.toPoint());
            QVERIFY(refused());
            test::Pen eraser(*widget, test::Pen::End::Eraser);
            eraser.press(middle, 0.5, 70000);
            eraser.move(middle + QPointF(5, 0), 0.5, 70010);
            eraser.release(middle + QPointF(5, 0), 70100);
            QVERIFY(refused());
        }
        QVERIFY(fixture.session().document().segments.empty());
        // Turned round, the pen's tip erases and Ctrl paints.
        fixture.paint.setErases(true);
        const QPoint middle = BrushFixture::middleOf(fixture.slice).toPoint();
        QTest::mouseClick(&fixture.slice, Qt::LeftButton, {}, middle);
        QVERIFY(refused());
        QTest::mouseClick(&fixture.slice, Qt::LeftButton, Qt::ControlModifier, middle);
        QVERIFY(fixture.session().settle());
        QVERIFY(!fixture.painted().empty());
    }

    void theRadiusFollowsThePressure()
    {
        BrushFixture fixture(Brush::Paint);
        auto* button = fixture.window.findChild<QToolButton*>(QStringLiteral("radiusByPressure"));
        QVERIFY(button);
        QVERIFY(!button->isChecked());
        button->click();
        QVERIFY(fixture.workspace.brushSettings(Brush::Paint).radiusByPressure);
        QVERIFY(!fixture.workspace.brushSettings(Brush::Carve).radiusByPressure);
        const QPointF middle = BrushFixture::middleOf(fixture.slice);
        const std::vector<double> pressures{0.25, 0.5, 1.0, 0.0};
        {
            test::Pen pen(fixture.slice);
            for (std::size_t i = 0; i < stroke.size(); ++i) {
                if (i == 0)
                    pen.press(middle + stroke[i].offset, pressures[i], stroke[i].milliseconds);
                else
                    pen.move(middle + stroke[i].offset, pressures[i], stroke[i].milliseconds);
                fixture.session().poll();
            }
            lift(fixture, fixture.slice, pen);
        }
        const auto pressed = fixture.lastEdit().get<core::PaintStroke>();
        QVERIFY(pressed.path.pressures);
        QCOMPARE(pressed.path.pressures->size(), pressed.path.pointsLps.size());
        QCOMPARE(pressed.path.pressures->size(), pressures.size());
        for (std::size_t i = 0; i < pressures.size(); ++i)
            // What only touches still has a tenth of the radius.
            QVERIFY(std::abs((*pressed.path.pressures)[i] - std::max(pressures[i], 0.1)) < 1e-4);
        const std::size_t painted = fixture.painted().size();
        // As a recipe does it at once, to the bit; pressed fully it is more.
        test::WorkspaceFixture recipe;
        recipe.apply(fixture.session().history().row(1).edit);
        recipe.apply(pressed);
        QCOMPARE(recipe.session().stateHash(), fixture.session().stateHash());
        core::PaintStroke whole = pressed;
        whole.path.pressures.reset();
        QVERIFY(fixture.session().apply(whole));
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.painted().size() > painted);

        // The eraser end takes away as much as it is pressed.
        const std::size_t before = fixture.painted().size();
        test::Pen eraser(fixture.slice, test::Pen::End::Eraser);
        eraser.press(middle, 0.5, 71000);
        eraser.release(middle, 71100);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.lastEdit().get<core::PaintStroke>().erase);
        QCOMPARE(
            fixture.lastEdit().get<core::PaintStroke>().path.pressures->size(), std::size_t(1));
        QVERIFY(fixture.painted().size() < before);
        // A mouse knows no pressure.
        QTest::mouseClick(&fixture.slice, Qt::LeftButton, {}, middle.toPoint());
        QVERIFY(fixture.session().settle());
        QVERIFY(!fixture.lastEdit().get<core::PaintStroke>().erase);
        QVERIFY(!fixture.lastEdit().get<core::PaintStroke>().path.pressures);
    }

    /// The lower button on the pen pans, the upper one changes the grey scale or opens the menu,
    /// with a tool in hand; neither paints.
    void barrelButtonsNavigate()
    {
        BrushFixture fixture(Brush::Paint);
        const core::RowId before = fixture.session().history().position();
        const QPointF middle = BrushFixture::middleOf(fixture.slice);
        const auto centreOf = [&fixture] {
            return std::get<gpu::SliceScene>(fixture.slice.context().scene).centreLps;
        };
        const glm::dvec3 centre = centreOf();
        const double mmPerPixel = fixture.slice.context().mmPerPixel();
        test::Pen pen(fixture.slice);
        pen.hover(middle, 70000);
        pen.pressButton(Qt::MiddleButton, middle, 70010);
        pen.moveWith(Qt::MiddleButton, middle + QPointF(20.0, 0.0), 70020);
        pen.moveWith(Qt::MiddleButton, middle + QPointF(40.0, 0.0), 70030);
        pen.releaseButton(Qt::MiddleButton, middle + QPointF(40.0, 0.0), 70040);
        QVERIFY(std::abs(glm::distance(centreOf(), centre) - 40.0 * mmPerPixel) < 1e-6);
        const core::WindowLevel window = fixture.workspace.windowLevel();
        pen.pressButton(Qt::RightButton, middle, 70050);
        pen.moveWith(Qt::RightButton, middle + QPointF(30.0, 0.0), 70060);
        pen.releaseButton(Qt::RightButton, middle + QPointF(30.0, 0.0), 70070);
        QVERIFY(fixture.workspace.windowLevel() != window);
        QVERIFY(!QApplication::activePopupWidget());
        pen.pressButton(Qt::RightButton, middle, 70080);
        pen.releaseButton(Qt::RightButton, middle, 70090);
        for (int round = 0; round < 5; ++round) {
            QVERIFY(fixture.session().settle());
            fixture.session().poll();
        }
        QVERIFY(QApplication::activePopupWidget());
        QCOMPARE(QApplication::activePopupWidget()->objectName(), QStringLiteral("voxelMenu"));
        QApplication::activePopupWidget()->close();
        QCOMPARE(fixture.session().history().position(), before);
        QVERIFY(fixture.painted().empty());
    }

    /// A hand that squeezes the pen while it draws does not end or change the stroke.
    void aBarrelButtonDoesNotEndTheStroke()
    {
        BrushFixture fixture(Brush::Paint);
        const QPointF middle = BrushFixture::middleOf(fixture.slice);
        const auto centreOf = [&fixture] {
            return std::get<gpu::SliceScene>(fixture.slice.context().scene).centreLps;
        };
        const glm::dvec3 centre = centreOf();
        test::Pen pen(fixture.slice);
        pen.press(middle + stroke[0].offset, 0.5, stroke[0].milliseconds);
        pen.move(middle + stroke[1].offset, 0.5, stroke[1].milliseconds);
        pen.pressButton(Qt::MiddleButton, middle + stroke[1].offset, 70010, Qt::LeftButton);
        pen.moveWith(Qt::LeftButton | Qt::MiddleButton, middle + stroke[2].offset, 70017);
        pen.releaseButton(Qt::MiddleButton, middle + stroke[2].offset, 70020, Qt::LeftButton);
        pen.move(middle + stroke[3].offset, 0.5, stroke[3].milliseconds);
        lift(fixture, fixture.slice, pen);
        const auto path = fixture.lastEdit().get<core::PaintStroke>().path;
        QCOMPARE(path.pointsLps.size(), stroke.size());
        QVERIFY(glm::distance(centreOf(), centre) < 1e-9);
    }

    void pressureIsTheRadiusIn3d()
    {
        BrushFixture fixture(Brush::Carve);
        ui::Workspace::BrushSettings settings = fixture.workspace.brushSettings(Brush::Carve);
        settings.radiusByPressure = true;
        fixture.workspace.setBrushSettings(Brush::Carve, settings);
        test::Pen pen(fixture.view);
        draw(fixture, fixture.view, pen);
        lift(fixture, fixture.view, pen);
        const auto half = fixture.lastEdit().get<core::BrushStroke>();
        QVERIFY(half.path.pressures);
        QCOMPARE(half.path.pressures->size(), half.path.pointsLps.size());
        for (const double pressure : *half.path.pressures)
            QVERIFY(std::abs(pressure - 0.5) < 1e-4);
        QVERIFY(!fixture.carved().empty());
    }

    void escapeTakesTheStrokeBack_data()
    {
        QTest::addColumn<bool>("inVolume");
        QTest::addColumn<bool>("carves");
        QTest::addRow("paint on a slice") << false << false;
        QTest::addRow("paint in 3D") << true << false;
        QTest::addRow("carve on a slice") << false << true;
        QTest::addRow("carve in 3D") << true << true;
    }
    void escapeTakesTheStrokeBack()
    {
        QFETCH(bool, inVolume);
        QFETCH(bool, carves);
        BrushFixture fixture(carves ? Brush::Carve : Brush::Paint);
        QWidget& widget = inVolume ? static_cast<QWidget&>(fixture.view) : fixture.slice;
        test::Pen pen(widget);
        draw(fixture, widget, pen);
        QVERIFY((carves ? fixture.carved() : fixture.painted()).size() > 30);
        const QByteArray segmentOnly = fixture.session().stateHash();
        QTest::keyClick(&widget, Qt::Key_Escape);
        pen.release(BrushFixture::middleOf(widget), 70200);
        QVERIFY(fixture.session().settle());
        QVERIFY(!fixture.session().transactionOpen());
        QVERIFY(fixture.painted().empty());
        QVERIFY(fixture.carved().empty());
        // A segment that was made for the stroke is an entry of its own.
        QCOMPARE(fixture.session().history().rows().size(), std::size_t(carves ? 0 : 1));
        QCOMPARE(fixture.session().stateHash(), segmentOnly);
    }

    void paintIn3dLiesOnWhatIsSeen()
    {
        BrushFixture fixture(Brush::Paint);
        test::Pen pen(fixture.view);
        draw(fixture, fixture.view, pen);
        lift(fixture, fixture.view, pen);
        const auto edit = fixture.lastEdit().get<core::PaintStroke>();
        QVERIFY(edit.path.shape == BrushPath::Shape::Ball);
        QVERIFY(edit.path.lifts.empty());
        QVERIFY(edit.path.pointsLps.size() > 4);
        for (const glm::dvec3& point : edit.path.pointsLps) {
            // The head's bone ends at 16 mm; what is seen looks to −y.
            QVERIFY2(std::abs(glm::length(point) - 15.7) < 1.2,
                qPrintable(QString::number(glm::length(point))));
            QVERIFY(point.y < 0.0);
        }
        test::WorkspaceFixture recipe;
        recipe.apply(fixture.session().history().row(1).edit);
        recipe.apply(edit);
        QCOMPARE(recipe.session().stateHash(), fixture.session().stateHash());
        QVERIFY(fixture.painted().size() > 100);
    }

    /// As an eraser it does without Ctrl what else it does with it, and the other way round.
    void anEraserErasesAndPaintsWithCtrl()
    {
        BrushFixture fixture(Brush::Paint);
        const QPointF middle = BrushFixture::middleOf(fixture.slice);
        const auto click = [&](Qt::KeyboardModifiers modifiers) {
            test::WindowFixture::click(fixture.slice, middle, modifiers);
            QVERIFY(fixture.session().settle());
        };
        click({});
        const auto painted = fixture.painted();
        QVERIFY(!painted.empty());
        fixture.paint.setErases(true);
        test::WindowFixture::hover(fixture.slice, middle);
        QVERIFY(fixture.paint.target().startsWith(QStringLiteral("erases ")));
        click({});
        QVERIFY(fixture.lastEdit().get<core::PaintStroke>().erase);
        QVERIFY(fixture.painted().empty());
        click(Qt::ControlModifier);
        QVERIFY(!fixture.lastEdit().get<core::PaintStroke>().erase);
        QCOMPARE(fixture.painted(), painted);
    }

    /// "erases Segment 1" stands at the pointer, and nowhere once a study was opened again without
    /// it being over the view.
    void anotherStudyHasNothingAtThePointer()
    {
        BrushFixture fixture(Brush::Paint);
        const auto draws = [&fixture] {
            QImage picture(fixture.slice.size(), QImage::Format_ARGB32_Premultiplied);
            picture.fill(Qt::transparent);
            const QImage nothing = picture;
            QPainter painter(&picture);
            fixture.paint.paintOverlay(painter, fixture.slice.context());
            painter.end();
            return picture != nothing;
        };
        const auto open = [&fixture] {
            auto session = core::EditSession::create(fixture.engine, test::smallHead::volume(), {});
            QVERIFY(session);
            fixture.workspace.setSession(std::move(*session));
            QVERIFY(fixture.session().apply(test::newSegment(QStringLiteral("Head"), 0x804020)));
            QVERIFY(fixture.session().settle());
            fixture.workspace.setActiveSegment(1);
            fixture.paint.setErases(true);
            fixture.workspace.setActiveTool(&fixture.paint);
        };
        fixture.workspace.setSession(nullptr);
        open();
        QVERIFY(!draws());
        test::WindowFixture::hover(fixture.slice, BrushFixture::middleOf(fixture.slice));
        QCOMPARE(fixture.paint.target(), QStringLiteral("erases Head"));
        QVERIFY(draws());
        fixture.workspace.setSession(nullptr);
        open();
        QVERIFY(!draws());
        test::WindowFixture::hover(fixture.slice, BrushFixture::middleOf(fixture.slice));
        QVERIFY(draws());
    }

    /// With Ctrl or the eraser end what is seen of the segment goes, and what lies deeper stays.
    void erasingIn3dTakesWhatIsSeen_data()
    {
        QTest::addColumn<bool>("control");
        QTest::newRow("the eraser end") << false;
        QTest::newRow("Ctrl") << true;
    }
    void erasingIn3dTakesWhatIsSeen()
    {
        QFETCH(const bool, control);
        BrushFixture fixture(Brush::Paint);
        QVERIFY(fixture.session().apply(test::newSegment(QStringLiteral("Head"), 0x804020)));
        QVERIFY(fixture.session().apply(core::ThresholdSegment{.segment = 1, .lower = 0.0}));
        QVERIFY(fixture.session().settle());
        fixture.workspace.setActiveSegment(1);
        const auto before = fixture.painted();
        if (control) {
            const QPoint middle = BrushFixture::middleOf(fixture.view).toPoint();
            const QPoint end = middle + QPoint(30, 0);
            QTest::mousePress(&fixture.view, Qt::LeftButton, Qt::ControlModifier, middle);
            QTest::mouseMove(&fixture.view, end);
            fixture.session().poll();
            QTest::mouseRelease(&fixture.view, Qt::LeftButton, Qt::ControlModifier, end);
            fixture.session().poll();
            QVERIFY(fixture.session().settle());
        } else {
            test::Pen pen(fixture.view, test::Pen::End::Eraser);
            draw(fixture, fixture.view, pen);
            lift(fixture, fixture.view, pen);
        }
        const auto edit = fixture.lastEdit().get<core::PaintStroke>();
        QVERIFY(edit.erase);
        for (const glm::dvec3& point : edit.path.pointsLps)
            QVERIFY(std::abs(glm::length(point) - 15.7) < 1.2 && point.y < 0.0);
        const auto after = fixture.painted();
        QVERIFY(after.size() + 20 < before.size());
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        for (const auto& voxel : before) {
            if (after.count(voxel) > 0)
                continue;
            const glm::dvec3 lps = geometry.toWorld(glm::dvec3(voxel[0], voxel[1], voxel[2]));
            QVERIFY(glm::length(lps) > 15.7 - 1.2 - 3.0 - 0.1 && lps.y < 0.0);
        }
    }

    /// Where the volume steps back, a stroke lies on the segments that are shown, however deep in
    /// the head they are; a brush that carves does not work there.
    void erasingLiesOnSegmentsWhereTheyAreSeenAlone_data()
    {
        QTest::addColumn<int>("shown");
        QTest::newRow("segments only") << int(gpu::Context::Hidden);
        QTest::newRow("cut away") << int(gpu::Context::CutAway);
        QTest::newRow("translucent") << int(gpu::Context::Translucent);
    }
    void erasingLiesOnSegmentsWhereTheyAreSeenAlone()
    {
        QFETCH(const int, shown);
        const auto context = gpu::Context(shown);
        BrushFixture fixture(Brush::Paint);
        ui::Workspace::VolumeDisplay display = fixture.workspace.volumeDisplay();
        display.context = context;
        fixture.workspace.setVolumeDisplay(display);
        QCOMPARE(
            fixture.carve.worksIn(fixture.view.context()), context == gpu::Context::Translucent);
        QVERIFY(fixture.paint.worksIn(fixture.view.context()));
        // The ventricle, 5 mm around the middle.
        QVERIFY(fixture.session().apply(test::newSegment(QStringLiteral("Ventricle"), 0x804020)));
        QVERIFY(fixture.session().apply(
            core::ThresholdSegment{.segment = 1, .lower = 0.0, .upper = 20.0}));
        QVERIFY(fixture.session().settle());
        fixture.workspace.setActiveSegment(1);
        fixture.workspace.setBrushSettings(Brush::Paint, {.radiusMm = 1.6});
        const auto before = fixture.painted();
        test::Pen pen(fixture.view, test::Pen::End::Eraser);
        draw(fixture, fixture.view, pen, {stroke[0], stroke[1]});
        pen.release(BrushFixture::middleOf(fixture.view) + stroke[1].offset, 70100);
        fixture.session().poll();
        QVERIFY(fixture.session().settle());
        const auto edit = fixture.lastEdit().get<core::PaintStroke>();
        QVERIFY(edit.erase);
        for (const glm::dvec3& point : edit.path.pointsLps) {
            QVERIFY2(std::abs(glm::length(point) - 4.5) < 1.2,
                qPrintable(QString::number(glm::length(point))));
            QVERIFY(point.y < 0.0);
        }
        const auto after = fixture.painted();
        QVERIFY(after.size() < before.size() && after.size() > before.size() / 2);
        // Resting digs no deeper: the way was looked for before anything was erased.
        const auto stays = fixture.workspace.volume()->geometry.toIndex(glm::dvec3(0.0, 0.0, 0.0));
        const glm::ivec3 middle(glm::floor(stays + 0.5));
        QVERIFY(after.count({middle.x, middle.y, middle.z}) > 0);
    }

    /// The cut follows the surface of pen-down: neither resting nor a fast tablet digs deeper.
    void carvingDoesNotDependOnTheEventRate()
    {
        std::vector<std::set<std::array<int, 3>>> cuts;
        for (const int readings : {2, 7, 40, 160}) {
            BrushFixture fixture(Brush::Carve);
            test::Pen pen(fixture.view);
            draw(fixture, fixture.view, pen, across(60.0, readings));
            lift(fixture, fixture.view, pen);
            cuts.push_back(fixture.carved());
            QVERIFY(cuts.back().size() > 200);
            double deepest = 0.0;
            const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
            for (const auto& voxel : cuts.back())
                deepest = std::max(
                    deepest, 16.0 - glm::length(geometry.toWorld({voxel[0], voxel[1], voxel[2]})));
            QVERIFY2(deepest < 3.0 + 1.6, qPrintable(QString::number(deepest)));
        }
        for (const auto& cut : cuts) {
            std::vector<std::array<int, 3>> apart;
            std::set_symmetric_difference(
                cut.begin(), cut.end(), cuts[0].begin(), cuts[0].end(), std::back_inserter(apart));
            QVERIFY2(apart.size() * 25 < cut.size(),
                qPrintable(QStringLiteral("%1 of %2").arg(apart.size()).arg(cut.size())));
        }
    }

    void restoringIsCarvingTurnedRound()
    {
        BrushFixture fixture(Brush::Carve);
        test::Pen pen(fixture.slice);
        draw(fixture, fixture.slice, pen);
        lift(fixture, fixture.slice, pen);
        QVERIFY(fixture.carved().size() > 100);
        test::Pen eraser(fixture.slice, test::Pen::End::Eraser);
        draw(fixture, fixture.slice, eraser);
        lift(fixture, fixture.slice, eraser);
        QVERIFY(fixture.carved().empty());
        QVERIFY(fixture.lastEdit().get<core::BrushStroke>().restore);
    }

    /// Over the edge of what is seen the brush is lifted; off it nothing happens.
    void nothingIsDrawnThroughTheAir()
    {
        BrushFixture fixture(Brush::Paint);
        const double perMm = 1.0 / fixture.view.context().mmPerPixel();
        test::Pen pen(fixture.view);
        // From the middle over the upper edge, round outside, and back over the right edge.
        draw(fixture, fixture.view, pen,
            {{{0.0, 0.0}, 1000}, {{0.0, -30.0 * perMm}, 1010},
                {{30.0 * perMm, -30.0 * perMm}, 1020}, {{30.0 * perMm, 0.0}, 1030},
                {{8.0 * perMm, 0.0}, 1040}});
        lift(fixture, fixture.view, pen);
        const auto edit = fixture.lastEdit().get<core::PaintStroke>();
        QVERIFY(!edit.path.lifts.empty());
        for (const glm::dvec3& point : edit.path.pointsLps)
            QVERIFY(glm::length(point) < 18.0);
        for (const auto& voxel : fixture.painted())
            QVERIFY(glm::length(fixture.workspace.volume()->geometry.toWorld(
                        {voxel[0], voxel[1], voxel[2]}))
                < 16.0 + 3.0 + 1.5);

        const core::RowId row = fixture.session().history().position();
        test::Pen beside(fixture.view);
        draw(fixture, fixture.view, beside,
            {{{40.0 * perMm, 0.0}, 2000}, {{44.0 * perMm, 0.0}, 2010}});
        lift(fixture, fixture.view, beside);
        QCOMPARE(fixture.session().history().position(), row);
        QVERIFY(!fixture.session().transactionOpen());
    }

    void whatIsLockedOrMutedIsLeftAlone()
    {
        BrushFixture fixture(Brush::Paint);
        int failures = 0;
        connect(&fixture.workspace, &ui::Workspace::failed, this, [&failures] { ++failures; });
        QVERIFY(fixture.session().apply(test::newSegment(QStringLiteral("Liver"), 0x804020)));
        QVERIFY(fixture.session().apply(test::lockSegment(1)));
        QVERIFY(fixture.session().settle());
        fixture.workspace.setActiveSegment(1);
        QCOMPARE(fixture.paint.target(), QStringLiteral("Liver is locked"));
        test::Pen pen(fixture.slice);
        draw(fixture, fixture.slice, pen);
        lift(fixture, fixture.slice, pen);
        QCOMPARE(failures, 1);
        QVERIFY(fixture.painted().empty());

        fixture.workspace.setActiveTool(&fixture.carve);
        QCOMPARE(fixture.carve.target(), QStringLiteral("carves layer Sculpt 1"));
        QVERIFY(fixture.session().apply(core::ChangeLayer{.layer = 1, .muted = true}));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.carve.target(), QStringLiteral("layer Sculpt 1 is muted"));
        test::Pen other(fixture.view);
        draw(fixture, fixture.view, other);
        lift(fixture, fixture.view, other);
        QCOMPARE(failures, 2);
        QVERIFY(fixture.carved().empty());
        QVERIFY(!fixture.session().transactionOpen());
    }

    /// What is painted for a segment with seeds is a seed too.
    void paintTakesPartInGrowth()
    {
        BrushFixture fixture(Brush::Paint);
        QVERIFY(fixture.session().apply(test::newSegment(QStringLiteral("Brain"), 0x804020)));
        QVERIFY(!ui::takesPartInGrowth(fixture.session().history(), 1));
        QVERIFY(fixture.session().apply(test::WorkspaceFixture::middleSeed(1)));
        QVERIFY(fixture.session().settle());
        fixture.workspace.setActiveSegment(1);
        QVERIFY(ui::takesPartInGrowth(fixture.session().history(), 1));
        QVERIFY(!ui::takesPartInGrowth(fixture.session().history(), 2));
        test::Pen pen(fixture.slice);
        draw(fixture, fixture.slice, pen);
        lift(fixture, fixture.slice, pen);
        QVERIFY(fixture.lastEdit().get<core::PaintStroke>().seeds);
    }

    void aStrokeEndsWithItsSession()
    {
        for (const bool inVolume : {false, true}) {
            BrushFixture fixture(Brush::Paint);
            QWidget& widget = inVolume ? static_cast<QWidget&>(fixture.view) : fixture.slice;
            test::Pen pen(widget);
            pen.press(BrushFixture::middleOf(widget), 1.0, 10); // in 3D a question is on its way
            fixture.workspace.setSession(nullptr);
            pen.move(BrushFixture::middleOf(widget) + QPointF(5, 0), 1.0, 20);
            pen.release(BrushFixture::middleOf(widget) + QPointF(5, 0), 30);
            fixture.paint.cancel();
            QVERIFY(!fixture.workspace.session());
        }
    }

    /// What was drawn and let go of is a stroke, however long the question of its place waits.
    void whatWasLetGoOfIsAStroke()
    {
        BrushFixture fixture(Brush::Paint);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        test::Pen pen(fixture.view);
        const QPointF middle = BrushFixture::middleOf(fixture.view);
        const auto drawUnanswered = [&](quint64 ms) {
            pen.press(middle, 1.0, ms);
            pen.move(middle + QPointF(6, 0), 1.0, ms + 10);
            pen.release(middle + QPointF(6, 0), ms + 20);
        };
        drawUnanswered(10);
        QVERIFY(fixture.paint.canTakeStepBack());
        // Another stroke does not begin meanwhile, and that is told.
        const qsizetype before = said.size();
        drawUnanswered(100);
        QCOMPARE(said.size(), before + 1);
        QVERIFY(
            said.back().front().toString().startsWith(QStringLiteral("The stroke before waits")));
        // Nor does another tool take it back.
        fixture.paint.cancel();
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.lastEdit().is<core::PaintStroke>());
        QVERIFY(!fixture.paint.canTakeStepBack());
        const std::size_t rows = fixture.session().history().rows().size();
        // Undo does, and it takes back nothing else.
        drawUnanswered(200);
        QVERIFY(fixture.paint.canTakeStepBack());
        fixture.paint.takeStepBack();
        QVERIFY(!fixture.paint.canTakeStepBack());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().history().rows().size(), rows);
        QCOMPARE(std::size_t(fixture.session().history().position()), rows);
        // A stroke that somebody else began since is not ended by it.
        drawUnanswered(300);
        QVERIFY(fixture.session().begin(test::paintAt(1, {glm::dvec3(0.0)}, 1.0)));
        QTRY_VERIFY((fixture.session().poll(), !fixture.paint.canTakeStepBack()));
        QVERIFY(fixture.session().isOpen<core::PaintStroke>());
        QVERIFY(said.back().front().toString().startsWith(
            QStringLiteral("The stroke before was dropped")));
        fixture.session().end(core::Ending::Rollback);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().history().rows().size(), rows);
    }

    void optionsAndKeysSetTheBrush()
    {
        BrushFixture fixture(Brush::Paint);
        const QPointF at = BrushFixture::middleOf(fixture.slice);
        QWheelEvent event(at, fixture.slice.mapToGlobal(at), {}, {0, 120}, Qt::NoButton,
            Qt::ShiftModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&fixture.slice, &event);
        const auto settings = [&] { return fixture.workspace.brushSettings(Brush::Paint); };
        QCOMPARE(settings().radiusMm, 3.5);
        QCOMPARE(fixture.workspace.brushSettings(Brush::Carve).radiusMm, 3.0);
        fixture.paint.changeRadius(-100);
        QCOMPARE(settings().radiusMm, ui::BrushTool::minimumRadiusMm);

        auto* radius = fixture.window.findChild<QDoubleSpinBox*>(QStringLiteral("brushRadius"));
        auto* shape = fixture.window.findChild<QComboBox*>(QStringLiteral("brushShape"));
        auto* only = fixture.window.findChild<QCheckBox*>(QStringLiteral("brushOnlyBetween"));
        auto* lower = fixture.window.findChild<QDoubleSpinBox*>(QStringLiteral("brushLower"));
        auto* over = fixture.window.findChild<QCheckBox*>(QStringLiteral("brushOverwrite"));
        QVERIFY(radius && shape && only && lower && over);
        QCOMPARE(radius->value(), ui::BrushTool::minimumRadiusMm);
        radius->setValue(5.0);
        QCOMPARE(settings().radiusMm, 5.0);
        shape->setCurrentIndex(0);
        Q_EMIT shape->activated(0);
        QVERIFY(!settings().disc);
        auto* limits = fixture.window.findChild<QToolButton*>(QStringLiteral("brushLimits"));
        QVERIFY(limits);
        QCOMPARE(limits->text(), QStringLiteral("no limits"));
        QVERIFY(!lower->isEnabled());
        fixture.workspace.setGrowSettings({.lower = 0.0, .upper = 100.0});
        only->click();
        QVERIFY(settings().onlyBetween);
        QCOMPARE(settings().upper, 100.0);
        QVERIFY(lower->isEnabled());
        lower->setValue(20.0);
        over->click();
        QVERIFY(limits->toolTip().endsWith(QStringLiteral(": only 20 … 100 HU, over others")));
        QVERIFY(fixture.window.minimumSizeHint().width() <= 1280);
        QVERIFY(settings().overwriteUnlocked);

        test::Pen pen(fixture.slice);
        draw(fixture, fixture.slice, pen);
        lift(fixture, fixture.slice, pen);
        const auto& edit = fixture.lastEdit().get<core::PaintStroke>();
        QCOMPARE(*edit.lower, 20.0);
        QCOMPARE(*edit.upper, 100.0);
        QVERIFY(edit.overwriteUnlocked);
        QVERIFY(edit.path.shape == BrushPath::Shape::Ball);
    }

    /// The name of a segment that is too long for the options ends with "…", not within a letter.
    void aLongNameEndsWithDots()
    {
        BrushFixture fixture(Brush::Paint);
        ui::SeedOptions options(fixture.workspace, {});
        options.resize(options.sizeHint());
        auto* box = options.findChild<QComboBox*>(QStringLiteral("seedSegment"));
        const auto drawn = [box](const QString& name) {
            box->setItemText(box->currentIndex(), name);
            return box->grab().toImage();
        };
        const QString name = QStringLiteral("Superior mesenteric artery with its branches");
        QVERIFY(box->itemIcon(box->currentIndex()).isNull());
        const QImage whole = drawn(name);
        QStyleOptionComboBox option;
        option.initFrom(box);
        const int room =
            box->style()
                ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box)
                .width()
            - 4; // "a new segment" has no swatch
        bool isDotted = false;
        for (int length = 4; length < name.size() && !isDotted; ++length) {
            const QString part = name.left(length) + QChar(0x2026);
            const bool isWhole = box->fontMetrics().horizontalAdvance(part) <= room;
            isDotted = isWhole && drawn(part) == whole;
        }
        QVERIFY(isDotted);
    }
};

BURIN_WINDOW_TEST(BrushToolsUiTest)

} // namespace brushToolsUiTest

#include "BrushToolsUiTest.moc"
