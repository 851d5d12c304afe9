// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/SegmentScissors.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/edits/kinds/splitting/SplitByCurve.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/edits/kinds/views/Measurements.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/tools/growth/BarrierTool.h"
#include "ui/tools/growth/PaintTool.h"
#include "ui/tools/growth/SeedTool.h"
#include "ui/tools/scissors/SegmentScissorsTool.h"
#include "ui/tools/sculpt/DrillTool.h"
#include "ui/tools/view/MeasureTool.h"
#include "ui/views/ViewGrid.h"

#include <QtTest>

#include <cmath>
#include <functional>
#include <vector>

namespace mouseAndPenUiTest {

namespace {

using Brush = ui::Workspace::Brush;
using Kind = core::Measurement::Kind;

/// What the two segments hold before a tool is used: nothing, a seed in the first one, or bone and
/// brain.
enum class Start { Bare, Seeded, Filled };

/// The real window with the small head, two segments, and every tool that is tried here. The 3D
/// view looks from the front.
class HandFixture : public test::WindowFixture {
public:
    HandFixture()
        : test::WindowFixture(test::smallHead::volume())
        , paint(workspace)
        , seed(workspace)
        , barrier(workspace)
        , drill(workspace)
        , scissors(workspace)
        , measure(workspace)
        , slice(window.views().axial())
        , view(window.views().volume())
    {
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.surfaceThreshold = 300.0;
        workspace.setVolumeDisplay(display);
        workspace.setBrushSettings(Brush::Paint, {.radiusMm = 3.0, .disc = true});
        workspace.setBrushSettings(Brush::Barrier, {.radiusMm = 2.0});
        view.lookFrom({0.0, -1.0, 0.0});
        apply(test::newSegment(QStringLiteral("Bone"), 0xE0D0B0));
        apply(test::newSegment(QStringLiteral("Brain"), 0xB05060));
        workspace.setActiveSegment(1);
    }
    void begin(Start start)
    {
        if (start == Start::Seeded)
            apply(test::seedAt(1, {{0.0, 0.0, 9.0}}));
        if (start != Start::Filled)
            return;
        apply(core::ThresholdSegment{.segment = 1, .lower = 300.0});
        apply(core::ThresholdSegment{.segment = 2, .lower = 20.0, .upper = 100.0});
    }
    /// Right of and below the middle of a view, mm.
    [[nodiscard]] static QPointF at(const ui::ImageView& where, double right, double down)
    {
        return QPointF(where.width(), where.height()) / 2.0
            + QPointF(right, down) / where.context().mmPerPixel();
    }
    /// In eight parts.
    [[nodiscard]] static std::vector<QPointF> line(
        const ui::ImageView& where, const QPointF& fromMm, const QPointF& toMm)
    {
        std::vector<QPointF> way;
        for (int part = 0; part <= 8; ++part) {
            const QPointF mm = fromMm + (toMm - fromMm) * (part / 8.0);
            way.push_back(at(where, mm.x(), mm.y()));
        }
        return way;
    }
    /// Not quite closed.
    [[nodiscard]] static std::vector<QPointF> ring(const ui::ImageView& where, double radiusMm)
    {
        std::vector<QPointF> way;
        for (int i = 0; i < 39; ++i) {
            const double angle = 2.0 * M_PI * i / 40.0;
            way.push_back(at(where, radiusMm * std::cos(angle), radiusMm * std::sin(angle)));
        }
        return way;
    }
    /// What an answer asks for is asked after it came.
    void settle()
    {
        for (int round = 0; round < 4; ++round) {
            session().poll();
            if (!session().settle())
                qFatal("not settled");
        }
    }

    ui::PaintTool paint;
    ui::SeedTool seed;
    ui::BarrierTool barrier;
    ui::DrillTool drill;
    ui::SegmentScissorsTool scissors;
    ui::MeasureTool measure;
    ui::SliceView& slice;
    ui::VolumeView& view;
};

/// A tool in a view, and how it is used there.
struct Case {
    const char* name = "";
    Start start = Start::Bare;
    std::function<ui::Tool&(HandFixture&)> tool;
    std::function<ui::ImageView&(HandFixture&)> where;
    std::function<std::vector<QPointF>(const ui::ImageView&)> way;
    /// Whether an edit is of the kind that this makes.
    std::function<bool(const core::Edit&)> isMade;
};

template <class Made> bool isA(const core::Edit& edit)
{
    return edit.is<Made>();
}

ui::ImageView& inSlice(HandFixture& fixture)
{
    return fixture.slice;
}

ui::ImageView& in3d(HandFixture& fixture)
{
    return fixture.view;
}

std::vector<QPointF> short3d(const ui::ImageView& where)
{
    return HandFixture::line(where, {-5.0, 1.0}, {5.0, -2.0});
}

/// In the middle of the head.
std::vector<QPointF> throughVentricle(const ui::ImageView& where)
{
    return HandFixture::line(where, {-3.0, 0.5}, {3.0, -0.5});
}

void addBrushes(std::vector<Case>& cases)
{
    const auto paint = [](HandFixture& fixture) -> ui::Tool& { return fixture.paint; };
    const auto erase = [](HandFixture& fixture) -> ui::Tool& {
        fixture.paint.setErases(true);
        return fixture.paint;
    };
    const auto isPaint = [](const core::Edit& edit) {
        return edit.is<core::PaintStroke>() && !edit.get<core::PaintStroke>().erase;
    };
    const auto isErase = [](const core::Edit& edit) {
        return edit.is<core::PaintStroke>() && edit.get<core::PaintStroke>().erase;
    };
    const auto throughBone = [](const ui::ImageView& where) {
        return HandFixture::line(where, {8.0, 0.0}, {15.0, 2.0});
    };
    const auto barrier = [](HandFixture& fixture) -> ui::Tool& { return fixture.barrier; };
    const auto seed = [](HandFixture& fixture) -> ui::Tool& { return fixture.seed; };
    cases.push_back({"paint on a slice", Start::Bare, paint, inSlice, throughVentricle, isPaint});
    cases.push_back({"paint in 3D", Start::Bare, paint, in3d, short3d, isPaint});
    cases.push_back({"erase on a slice", Start::Filled, erase, inSlice, throughBone, isErase});
    cases.push_back({"erase in 3D", Start::Filled, erase, in3d, short3d, isErase});
    cases.push_back({"barrier on a slice", Start::Seeded, barrier, inSlice, throughVentricle,
        isA<core::BarrierStroke>});
    cases.push_back(
        {"barrier in 3D", Start::Seeded, barrier, in3d, short3d, isA<core::BarrierStroke>});
    cases.push_back(
        {"seed on a slice", Start::Bare, seed, inSlice, throughBone, isA<core::SeedStroke>});
    cases.push_back({"seed in 3D", Start::Bare, seed, in3d, short3d, isA<core::SeedStroke>});
    cases.push_back(
        {"drill", Start::Bare, [](HandFixture& fixture) -> ui::Tool& { return fixture.drill; },
            in3d, short3d, isA<core::DrillStroke>});
}

void addScissors(std::vector<Case>& cases)
{
    using Does = ui::SegmentScissorsTool::Does;
    using Shape = ui::SegmentScissorsTool::Shape;
    const auto scissors = [](Does does, Shape shape) {
        return [does, shape](HandFixture& fixture) -> ui::Tool& {
            fixture.scissors.setSettings({.does = does, .shape = shape});
            return fixture.scissors;
        };
    };
    const auto diagonal = [](const ui::ImageView& where) {
        return HandFixture::line(where, {-6.0, -5.0}, {6.0, 5.0});
    };
    const auto around = [](const ui::ImageView& where) { return HandFixture::ring(where, 6.0); };
    const auto across = [](const ui::ImageView& where) {
        return HandFixture::line(where, {-6.0, -4.0}, {7.0, -4.0});
    };
    cases.push_back({"scissors, rectangle", Start::Filled,
        scissors(Does::EraseInside, Shape::Rectangle), in3d, diagonal, isA<core::SegmentScissors>});
    cases.push_back({"scissors, freehand", Start::Filled,
        scissors(Does::EraseInside, Shape::Freehand), in3d, around, isA<core::SegmentScissors>});
    cases.push_back({"split off inside", Start::Filled,
        scissors(Does::SplitInside, Shape::Freehand), in3d, around, isA<core::SplitByCurve>});
    cases.push_back({"split along a line", Start::Filled,
        scissors(Does::SplitAlong, Shape::Freehand), in3d, across, isA<core::SplitByCurve>});
}

void addMeasurements(std::vector<Case>& cases)
{
    const auto shape = [](Kind kind) {
        return [kind](HandFixture& fixture) -> ui::Tool& {
            fixture.measure.setKind(kind);
            fixture.measure.setText(QStringLiteral("Fissure"));
            return fixture.measure;
        };
    };
    const auto drag = [](const ui::ImageView& where) {
        return HandFixture::line(where, {-6.0, -3.0}, {5.0, 6.0});
    };
    const auto click = [](const ui::ImageView& where) {
        return std::vector<QPointF>{HandFixture::at(where, 2.0, -3.0)};
    };
    const auto around = [](const ui::ImageView& where) { return HandFixture::ring(where, 7.0); };
    const auto add = [&](const char* name, Kind kind, const auto& where, const auto& way) {
        cases.push_back({name, Start::Bare, shape(kind), where, way, isA<core::Annotate>});
    };
    add("ellipse", Kind::Ellipse, inSlice, drag);
    add("rectangle", Kind::Rectangle, inSlice, drag);
    add("freehand region", Kind::Outline, inSlice, around);
    add("ball", Kind::Ball, inSlice, drag);
    add("probe", Kind::Probe, inSlice, click);
    add("probe in 3D", Kind::Probe, in3d, click);
    add("arrow", Kind::Arrow, inSlice, drag);
    add("text", Kind::Text, inSlice, click);
}

const std::vector<Case>& cases()
{
    static const std::vector<Case> all = [] {
        std::vector<Case> made;
        addBrushes(made);
        addScissors(made);
        addMeasurements(made);
        return made;
    }();
    return all;
}

} // namespace

/// What a mouse does with a tool, a pen that is pressed fully does as well, to the voxel: one row
/// of the history, which undo takes back whole. Tools that are not here have both in tests of their
/// own.
class MouseAndPenUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void bothDoTheSame_data()
    {
        QTest::addColumn<int>("which");
        for (std::size_t i = 0; i < cases().size(); ++i)
            QTest::newRow(cases()[i].name) << int(i);
    }
    void bothDoTheSame()
    {
        QFETCH(const int, which);
        const Case& tried = cases().at(std::size_t(which));
        std::vector<QByteArray> reached;
        for (const test::DrawnBy by : {test::DrawnBy::Mouse, test::DrawnBy::Pen}) {
            HandFixture fixture;
            fixture.begin(tried.start);
            const QByteArray before = fixture.session().stateHash();
            const std::size_t rows = fixture.rows();
            fixture.workspace.setActiveTool(&tried.tool(fixture));
            ui::ImageView& where = tried.where(fixture);
            test::drawStroke(by, where, tried.way(where));
            fixture.settle();
            QCOMPARE(fixture.rows(), rows + 1);
            QVERIFY(tried.isMade(fixture.session().history().rows().back().edit));
            reached.push_back(fixture.session().stateHash());
            QVERIFY(reached.back() != before);
            QVERIFY(test::isWhatARecipeComesTo(fixture.session()));
            QVERIFY(fixture.session().undo());
            fixture.settle();
            QCOMPARE(fixture.session().stateHash(), before);
        }
        QCOMPARE(reached[0], reached[1]);
    }

    /// The end of an angle's second side is clicked.
    void anAngleByBoth()
    {
        std::vector<QByteArray> reached;
        for (const test::DrawnBy by : {test::DrawnBy::Mouse, test::DrawnBy::Pen}) {
            HandFixture fixture;
            const std::size_t rows = fixture.rows();
            fixture.measure.setKind(Kind::Angle);
            fixture.workspace.setActiveTool(&fixture.measure);
            test::drawStroke(
                by, fixture.slice, HandFixture::line(fixture.slice, {8.0, 0.0}, {0.0, 0.0}));
            fixture.settle();
            QCOMPARE(fixture.rows(), rows);
            test::drawStroke(by, fixture.slice, {HandFixture::at(fixture.slice, 0.0, 9.0)});
            fixture.settle();
            QCOMPARE(fixture.rows(), rows + 1);
            QVERIFY(fixture.session().document().measurements.back().kind == Kind::Angle);
            reached.push_back(fixture.session().stateHash());
        }
        QCOMPARE(reached[0], reached[1]);
    }
};

BURIN_WINDOW_TEST(MouseAndPenUiTest)

} // namespace mouseAndPenUiTest

#include "MouseAndPenUiTest.moc"
