// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/view/MeasureTool.h"

#include "core/edits/kinds/pieces/ChangePiece.h"
#include "core/edits/kinds/pieces/CutPiece.h"
#include "core/edits/kinds/pieces/RemovePiece.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/FillOutline.h"
#include "core/edits/kinds/views/Measurements.h"
#include "core/measure/MeasuredSize.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/measure/MeasuredRegions.h"
#include "ui/overlays/MeasurementLines.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/Pieces.h"

#include <QComboBox>
#include <QJsonObject>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

#include <cmath>
#include <memory>

namespace measureToolUiTest {

namespace {

class Fixture : public test::WindowFixture {
public:
    Fixture()
        : test::WindowFixture(test::smallHead::volume())
        , tool(workspace)
    {
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.surfaceThreshold = 300.0;
        workspace.setVolumeDisplay(display);
        workspace.setActiveTool(&tool);
    }
    [[nodiscard]] const std::vector<core::Measurement>& measurements()
    {
        return session().document().measurements;
    }
    void apply(const core::Edit& edit)
    {
        if (!session().apply(edit) || !session().settle())
            qFatal("refused");
    }
    void drag(ui::ImageView& view, const QPointF& from, const QPointF& to,
        test::DrawnBy by = test::DrawnBy::Pen)
    {
        test::drawStroke(by, view, {from, (from + to) / 2.0, to});
        settle();
    }
    void settle()
    {
        // What an answer asks for is asked after it came.
        for (int i = 0; i < 4; ++i) {
            session().poll();
            if (!session().settle())
                qFatal("not settled");
        }
    }

    [[nodiscard]] QString lastRow() { return session().history().rows().back().name; }
    /// Waits until what it comes to is known.
    [[nodiscard]] bool isMeasured(const core::Measurement& measured)
    {
        return QTest::qWaitFor([&] {
            session().poll();
            return workspace.measured(measured) != nullptr;
        });
    }

    ui::MeasureTool tool;
};

using Kind = core::Measurement::Kind;

QPointF middleOf(const ui::ImageView& view)
{
    return QPointF(view.width(), view.height()) / 2.0;
}

} // namespace

class MeasureToolUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aDragOnASliceIsADistance_data() { test::addMouseAndPen(); }
    void aDragOnASliceIsADistance()
    {
        QFETCH(const test::DrawnBy, by);
        Fixture fixture;
        const QByteArray before = fixture.session().stateHash();
        ui::SliceView& view = fixture.window.views().sagittal();
        const QPointF from = middleOf(view) + QPointF(-30, -10);
        const QPointF to = middleOf(view) + QPointF(10, 20);
        const double mm = view.context().mmPerPixel() * 50.0;
        fixture.drag(view, from, to, by);
        QCOMPARE(fixture.measurements().size(), std::size_t(1));
        QVERIFY(test::isWhatARecipeComesTo(fixture.session()));
        QVERIFY(std::abs(fixture.measurements()[0].lengthMm() - mm) < 0.01);
        QCOMPARE(fixture.measurements()[0].piece, 0);
        QCOMPARE(fixture.session().history().rows().back().name,
            QStringLiteral("Measure %1 mm").arg(QString::number(mm, 'f', 1)));
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QVERIFY(fixture.measurements().empty());
        QCOMPARE(fixture.session().stateHash(), before);
        QVERIFY(fixture.session().redo());
        fixture.settle();
        QCOMPARE(fixture.measurements().size(), std::size_t(1));
    }

    void clicksAndDroppedLinesMeasureNothing()
    {
        Fixture fixture;
        ui::SliceView& view = fixture.window.views().axial();
        fixture.drag(view, middleOf(view), middleOf(view) + QPointF(1, 1));
        test::Pen pen(view);
        pen.press(middleOf(view), 0.5, 1);
        pen.move(middleOf(view) + QPointF(30, 0), 0.5, 2);
        QTest::keyClick(&view, Qt::Key_Escape);
        pen.release(middleOf(view) + QPointF(30, 0), 3);
        // Beside all that is seen.
        ui::VolumeView& volume = fixture.window.views().volume();
        fixture.drag(volume, QPointF(6, 6), middleOf(volume));
        QVERIFY(fixture.session().history().rows().empty());
    }

    void inThreeDimensionsItIsMeasuredOnWhatIsSeen_data() { test::addMouseAndPen(); }
    void inThreeDimensionsItIsMeasuredOnWhatIsSeen()
    {
        QFETCH(const test::DrawnBy, by);
        Fixture fixture;
        ui::VolumeView& view = fixture.window.views().volume();
        view.lookFrom({0.0, -1.0, 0.0});
        const double mmPerPixel = view.context().mmPerPixel();
        const QPointF reach(10.0 / mmPerPixel, 0.0);
        fixture.drag(view, middleOf(view) - reach, middleOf(view) + reach, by);
        QCOMPARE(fixture.measurements().size(), std::size_t(1));
        QVERIFY(test::isWhatARecipeComesTo(fixture.session()));
        const core::Measurement& measured = fixture.measurements()[0];
        QVERIFY2(std::abs(measured.lengthMm() - 20.0) < 1.5,
            qPrintable(QString::number(measured.lengthMm())));
        // Both ends lie on the bone, 16 mm from the middle, on the viewer's side.
        for (const glm::dvec3& end : measured.pointsLps)
            QVERIFY(std::abs(glm::length(end) - 16.0) < 1.6 && end.y < 0.0);
    }

    /// Far from home and twice as large: the length is that of the patient.
    void onAPieceItIsTheTrueLength()
    {
        Fixture fixture;
        fixture.apply(test::carveAt({{0, 0, 0}}, 26.0));
        core::CutPiece lift;
        lift.name = QStringLiteral("Ball");
        lift.pivotLps = glm::dvec3(0.0);
        fixture.apply(lift);
        core::ChangePiece move;
        move.piece = 1;
        move.offsetMm = glm::dvec3(8, 0, 4);
        move.zoom = 2.0;
        fixture.apply(move);
        ui::VolumeView& view = fixture.window.views().volume();
        view.lookFrom({0.0, -1.0, 0.0});
        const QPointF at = view.context().toPixel({8, 0, 4});
        const QPointF reach(8.0 / view.context().mmPerPixel(), 0.0);
        fixture.drag(view, at - reach, at + reach); // 16 mm as shown
        QCOMPARE(fixture.measurements().size(), std::size_t(1));
        const core::Measurement measured = fixture.measurements()[0];
        QVERIFY2(std::abs(measured.lengthMm() - 8.0) < 1.5,
            qPrintable(QString::number(measured.lengthMm())));
        QCOMPARE(measured.piece, 1);
        QVERIFY(std::abs(glm::length(measured.pointsLps[0]) - 16.0) < 1.6);
        // Without the piece it stays, at its true place.
        fixture.apply(core::RemovePiece{.piece = 1});
        QCOMPARE(fixture.measurements()[0].piece, 0);
        QCOMPARE(fixture.measurements()[0].pointsLps, measured.pointsLps);
    }

    /// A right angle on a slice: a drag along one side, then a click at the end of the other.
    void anAngleHasTwoSides()
    {
        Fixture fixture;
        fixture.tool.setKind(Kind::Angle);
        ui::SliceView& view = fixture.window.views().axial();
        const QPointF vertex = middleOf(view);
        fixture.drag(view, vertex + QPointF(40, 0), vertex);
        QVERIFY(fixture.measurements().empty());
        QVERIFY(fixture.tool.canTakeStepBack());
        fixture.drag(view, vertex + QPointF(5, 20), vertex + QPointF(0, 30));
        QCOMPARE(fixture.measurements().size(), std::size_t(1));
        QVERIFY(fixture.measurements()[0].kind == Kind::Angle);
        const core::MeasuredSize size =
            core::measuredSize(fixture.measurements()[0], *fixture.workspace.volume());
        QVERIFY(std::abs(*size.angleDegrees - 90.0) < 0.2);
        QCOMPARE(fixture.lastRow(),
            QStringLiteral("Measure angle %1°").arg(QString::number(*size.angleDegrees, 'f', 1)));
        // The first side alone is none, in another slice it is dropped, and undo takes it back.
        fixture.drag(view, vertex + QPointF(40, 15), vertex + QPointF(-15, 0));
        fixture.drag(fixture.window.views().coronal(), vertex, vertex + QPointF(0, 30));
        QVERIFY(!fixture.tool.canTakeStepBack());
        fixture.drag(view, vertex + QPointF(40, 15), vertex + QPointF(-15, 0));
        fixture.tool.takeStepBack();
        QVERIFY(!fixture.tool.canTakeStepBack());
        QCOMPARE(fixture.measurements().size(), std::size_t(1));
    }

    void regionsAreDraggedOnSlices_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<double>("areaOfBox"); // as a share of the box of the drag
        QTest::newRow("ellipse") << int(Kind::Ellipse) << M_PI / 4.0;
        QTest::newRow("rectangle") << int(Kind::Rectangle) << 1.0;
        // Of a ball the drag is the radius.
        QTest::newRow("ball") << int(Kind::Ball) << 0.0;
    }
    void regionsAreDraggedOnSlices()
    {
        QFETCH(const int, kind);
        QFETCH(const double, areaOfBox);
        Fixture fixture;
        const ui::MeasuredRegions regions(fixture.workspace);
        fixture.tool.setKind(Kind(kind));
        ui::SliceView& view = fixture.window.views().sagittal();
        const QPointF from = middleOf(view) + QPointF(-30, -10);
        fixture.drag(view, from, from + QPointF(40, 24));
        QCOMPARE(fixture.measurements().size(), std::size_t(1));
        const core::Measurement measured = fixture.measurements()[0];
        const core::MeasuredSize size = core::measuredSize(measured, *fixture.workspace.volume());
        const double mm = view.context().mmPerPixel();
        if (areaOfBox > 0.0)
            QVERIFY(std::abs(*size.area / (areaOfBox * 40.0 * 24.0 * mm * mm) - 1.0) < 0.002);
        else
            QVERIFY(std::abs(*size.longAxis / (2.0 * std::hypot(40.0, 24.0) * mm) - 1.0) < 0.002);
        // Its values are worked out beside the window, and are those of the volume.
        QVERIFY(fixture.isMeasured(measured));
        const auto known = core::regionStatistics(
            measured, *fixture.workspace.volume(), test::smallHead::volume().codes);
        const auto found = fixture.workspace.measured(measured)->values;
        QVERIFY(known && found);
        QCOMPARE(found->voxels, known->voxels);
        QCOMPARE(found->mean, known->mean);
        QCOMPARE(found->maximum, known->maximum);
        // Area and axes, or volume and diameter; mean and range.
        QCOMPARE(ui::measurementLines(measured, fixture.workspace).size(), 4);
        // It is drawn as long as it is there.
        const QImage with = view.grab().toImage();
        fixture.apply(core::RemoveMeasurement{.measurement = 1});
        QVERIFY(view.grab().toImage() != with);
        QVERIFY(fixture.lastRow().startsWith(QStringLiteral("Remove ")));
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QVERIFY(fixture.workspace.measured(measured)); // still known
    }

    void aCurveIsAnOutline()
    {
        Fixture fixture;
        fixture.tool.setKind(Kind::Outline);
        ui::SliceView& view = fixture.window.views().axial();
        const QPointF middle = middleOf(view);
        test::Pen pen(view);
        pen.press(middle + QPointF(30, 0), 0.5, 100);
        for (int i = 1; i < 900; ++i) {
            const double angle = 2.0 * M_PI * i / 900.0;
            pen.move(
                middle + 30.0 * QPointF(std::cos(angle), std::sin(angle)), 0.5, quint64(100 + i));
        }
        pen.release(middle + QPointF(30, 0), 1100);
        fixture.settle();
        QCOMPARE(fixture.measurements().size(), std::size_t(1));
        const core::Measurement& measured = fixture.measurements()[0];
        QVERIFY(measured.pointsLps.size() <= core::Annotate::mostCorners);
        const double mm = view.context().mmPerPixel();
        const core::MeasuredSize size = core::measuredSize(measured, *fixture.workspace.volume());
        QVERIFY(std::abs(*size.area / (M_PI * 900.0 * mm * mm) - 1.0) < 0.02);
    }

    void pointsAreDragged()
    {
        Fixture fixture;
        ui::SliceView& view = fixture.window.views().sagittal();
        const double mm = view.context().mmPerPixel();
        const QPointF from = middleOf(view) + QPointF(-30, -10);
        const QPointF to = middleOf(view) + QPointF(10, -10);
        fixture.drag(view, from, to);
        fixture.drag(view, to + QPointF(2, 1), to + QPointF(2, 31));
        QCOMPARE(fixture.measurements().size(), std::size_t(1));
        QCOMPARE(fixture.measurements()[0].id, 1);
        QVERIFY(fixture.lastRow().startsWith(QStringLiteral("Move distance ")));
        QVERIFY(
            std::abs(fixture.measurements()[0].lengthMm() - std::hypot(40.0, 30.0) * mm) < 0.01);
        // A click near it changes nothing, Esc leaves it where it was; elsewhere it is a new one.
        const std::vector<glm::dvec3> points = fixture.measurements()[0].pointsLps;
        const std::size_t rows = fixture.session().history().rows().size();
        fixture.drag(view, from + QPointF(3, 2), from + QPointF(3, 2));
        QCOMPARE(fixture.session().history().rows().size(), rows);
        test::Pen pen(view);
        pen.press(from, 0.5, 300);
        pen.move(from + QPointF(0, 20), 0.5, 310);
        QTest::keyClick(&view, Qt::Key_Escape);
        pen.release(from + QPointF(0, 20), 320);
        fixture.settle();
        QCOMPARE(fixture.measurements()[0].pointsLps, points);
        fixture.drag(view, from + QPointF(0, 20), from + QPointF(20, 20));
        QCOMPARE(fixture.measurements().size(), std::size_t(2));
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QVERIFY(std::abs(fixture.measurements()[0].lengthMm() - 40.0 * mm) < 0.01);
    }

    void notesSayWhatIsWritten()
    {
        Fixture fixture;
        const std::unique_ptr<QWidget> options(fixture.tool.createOptions(nullptr));
        auto* shapes = options->findChild<QComboBox*>(QStringLiteral("measureShape"));
        auto* text = options->findChild<QLineEdit*>(QStringLiteral("measureText"));
        QVERIFY(shapes && text && text->isHidden());
        shapes->setCurrentIndex(shapes->findData(int(Kind::Text)));
        Q_EMIT shapes->activated(shapes->currentIndex());
        QVERIFY(fixture.tool.kind() == Kind::Text && !text->isHidden());
        ui::SliceView& view = fixture.window.views().axial();
        fixture.drag(view, middleOf(view), middleOf(view));
        QVERIFY(fixture.measurements().empty()); // it has no words
        text->setText(QStringLiteral("Fissure"));
        fixture.drag(view, middleOf(view), middleOf(view));
        QCOMPARE(fixture.measurements().size(), std::size_t(1));
        QCOMPARE(fixture.lastRow(), QStringLiteral("Add text 'Fissure'"));
        fixture.tool.setKind(Kind::Arrow);
        fixture.drag(view, middleOf(view) + QPointF(20, 0), middleOf(view) + QPointF(40, 20));
        QCOMPARE(fixture.lastRow(), QStringLiteral("Add arrow 'Fissure'"));
        text->clear();
        fixture.drag(view, middleOf(view) + QPointF(0, 20), middleOf(view) + QPointF(20, 45));
        QCOMPARE(fixture.lastRow(), QStringLiteral("Add arrow"));
    }

    /// In 3D there is no plane for a region, and a projection says that it is one.
    void inThreeDimensionsThereAreNoRegions()
    {
        Fixture fixture;
        ui::VolumeView& view = fixture.window.views().volume();
        view.lookFrom({0.0, -1.0, 0.0});
        fixture.tool.setKind(Kind::Ellipse);
        QVERIFY(!fixture.tool.worksIn(view.context()));
        fixture.tool.setKind(Kind::Probe);
        QVERIFY(fixture.tool.worksIn(view.context()));
        fixture.drag(view, middleOf(view), middleOf(view));
        QCOMPARE(fixture.measurements().size(), std::size_t(1));
        QVERIFY(!fixture.measurements()[0].projected);
        ui::Workspace::VolumeDisplay display = fixture.workspace.volumeDisplay();
        display.mode = gpu::RenderMode::Mip;
        fixture.workspace.setVolumeDisplay(display);
        fixture.tool.setKind(Kind::Distance);
        const QPointF reach(6.0 / view.context().mmPerPixel(), 0.0);
        fixture.drag(view, middleOf(view) - reach, middleOf(view) + reach);
        QCOMPARE(fixture.measurements().size(), std::size_t(2));
        QVERIFY(fixture.measurements()[1].projected);
        QCOMPARE(ui::measurementLines(fixture.measurements()[1], fixture.workspace).back(),
            QStringLiteral("projected"));
    }

    /// A segment's outline in the middle slice, 12 × 6 mm, has these axes from corner to corner.
    void axesOfASegmentAreSuggested()
    {
        Fixture fixture;
        fixture.apply(core::AddSegment{.name = QStringLiteral("Lesion"), .rgb = 0x40C080});
        ui::SliceView& view = fixture.window.views().axial();
        const auto slice = std::get<gpu::SliceScene>(view.context().scene);
        core::FillOutline fill{.segment = 1,
            .originLps = slice.centreLps,
            .rightLps = slice.rightLps,
            .upLps = -slice.downLps,
            .polygonMm = {{-6.25, -3.25}, {6.25, -3.25}, {6.25, 3.25}, {-6.25, 3.25}}};
        fixture.apply(fill);
        fixture.tool.suggestAxes();
        QVERIFY(!fixture.tool.worksIn(fixture.window.views().volume().context()));
        const QPointF at = view.context().toPixel(slice.centreLps);
        fixture.drag(view, at, at);
        QVERIFY(QTest::qWaitFor([&] {
            fixture.session().poll();
            return fixture.measurements().size() == 2;
        }));
        const core::Measurement& longer = fixture.measurements()[0];
        const core::Measurement& shorter = fixture.measurements()[1];
        const glm::dvec3 spacing = fixture.workspace.volume()->geometry.spacingMm();
        const double pixel = std::max({spacing.x, spacing.y, spacing.z});
        QVERIFY2(std::abs(longer.lengthMm() - std::hypot(12.5, 6.5)) < 2.0 * pixel,
            qPrintable(QString::number(longer.lengthMm())));
        QVERIFY(shorter.lengthMm() < longer.lengthMm());
        const glm::dvec3 along = longer.pointsLps[1] - longer.pointsLps[0];
        const glm::dvec3 across = shorter.pointsLps[1] - shorter.pointsLps[0];
        QVERIFY(
            std::abs(glm::dot(along, across)) < 0.01 * glm::length(along) * glm::length(across));
        // Beside the segment there is nothing to be suggested.
        const QPointF beside = view.context().toPixel(slice.centreLps + 11.0 * slice.rightLps);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.drag(view, beside, beside);
        QVERIFY(QTest::qWaitFor([&] {
            fixture.session().poll();
            return said.size() > 0;
        }));
        QCOMPARE(fixture.measurements().size(), std::size_t(2));
        // It is kept as a setting, and a shape ends it.
        const QJsonObject kept = fixture.tool.settingsJson();
        fixture.tool.setKind(Kind::Distance);
        QVERIFY(!fixture.tool.suggestsAxes());
        fixture.tool.applySettings(kept);
        QVERIFY(fixture.tool.suggestsAxes());
    }

    void theShapeIsKept()
    {
        Fixture fixture;
        fixture.tool.setKind(Kind::Ball);
        const QJsonObject kept = fixture.tool.settingsJson();
        fixture.tool.setKind(Kind::Angle);
        fixture.tool.applySettings(kept);
        QVERIFY(fixture.tool.kind() == Kind::Ball);
        fixture.tool.applySettings({{QStringLiteral("kind"), QStringLiteral("cone")}});
        QVERIFY(fixture.tool.kind() == Kind::Ball);
    }

    /// The words of one do not cover those of its neighbour, as long as there is room.
    void wordsGiveWay()
    {
        Fixture fixture;
        const ui::ViewContext view = fixture.window.views().sagittal().context();
        QImage image(QSize(int(view.sizePixels.width()), int(view.sizePixels.height())),
            QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::black);
        QPainter painter(&image);
        ui::MeasurementDrawing drawing{.marks = {QPointF(150, 150)}};
        drawing.text = QPointF(150, 150);
        const QStringList words{QStringLiteral("600.0 mm²"), QStringLiteral("mean 84 ± 166")};
        std::vector<QRectF> taken{ui::paintMeasurement(painter, view, drawing, words)};
        QVERIFY(taken.front().isValid());
        QCOMPARE(ui::paintMeasurement(painter, view, drawing, words), taken.front());
        for (int i = 0; i < 3; ++i) {
            const QRectF box = ui::paintMeasurement(painter, view, drawing, words, taken);
            QVERIFY(QRectF(QPointF(), view.sizePixels).contains(box));
            for (const QRectF& each : taken)
                QVERIFY(!each.intersects(box));
            taken.push_back(box);
        }
    }
    void theListTakesThemAway()
    {
        Fixture fixture;
        const std::unique_ptr<QWidget> options(fixture.tool.createOptions(nullptr));
        auto* button = options->findChild<QToolButton*>(QStringLiteral("measurements"));
        QVERIFY(button && !button->isEnabled());
        fixture.apply(core::AddMeasurement{.fromLps = {0, 0, 0}, .toLps = {3, 4, 0}, .piece = {}});
        fixture.apply(core::AddMeasurement{.fromLps = {0, 0, 0}, .toLps = {0, 0, 9}, .piece = {}});
        QCOMPARE(button->text(), QStringLiteral("2 measurements"));
        Q_EMIT button->menu()->aboutToShow();
        QCOMPARE(button->menu()->actions().size(), 2);
        QCOMPARE(button->menu()->actions()[0]->text(), QStringLiteral("Remove 1: 5.0 mm"));
        button->menu()->actions()[0]->trigger();
        fixture.settle();
        QCOMPARE(fixture.measurements().size(), std::size_t(1));
        QCOMPARE(fixture.measurements()[0].id, 2);
        QCOMPARE(button->text(), QStringLiteral("1 measurement"));
    }
};

BURIN_WINDOW_TEST(MeasureToolUiTest)

} // namespace measureToolUiTest

#include "MeasureToolUiTest.moc"
