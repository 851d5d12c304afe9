// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/FillOutline.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/tools/growth/PaintTool.h"
#include "ui/tools/outline/FillOutlineTool.h"
#include "ui/views/PlaneView.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/CuttingPlane.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <functional>

namespace obliqueEdgesUiTest {

namespace {

/// The real window with the small head, cut near its middle by a plane along no axis.
class ObliqueFixture : public test::WindowFixture {
public:
    ObliqueFixture()
        : test::WindowFixture(test::smallHead::volume())
        , view(window.views().plane())
    {
        workspace.plane().setPose(ui::CuttingPlane::poseFacing(
            place({20.2, 19.7, 20.4}), glm::normalize(glm::dvec3(0.3, 0.5, 1.0))));
        window.views().arrange(ui::ViewGrid::Layout::PenAndStage);
        workspace.setWindowLevel({.centre = -50.0, .width = 1900.0}); // all values differ in it
        if (!QTest::qWaitFor(
                [this] { return view.isVisible() && view.width() > 100 && view.height() > 100; }))
            qFatal("the plane's view does not show");
        QCoreApplication::processEvents();
    }
    [[nodiscard]] glm::dvec3 normal() { return workspace.plane().pose().normalLps(); }
    /// The pixel of a place in the plane, from the foot of the head's middle, in mm.
    [[nodiscard]] QPointF at(double rightMm, double downMm)
    {
        const ui::CuttingPlane::Pose pose = workspace.plane().pose();
        const glm::dvec3 middle = place(glm::dvec3(20.0));
        const glm::dvec3 foot = middle - glm::dot(middle - pose.centreLps, normal()) * normal();
        return view.context().toPixel(foot + rightMm * pose.rightLps + downMm * pose.downLps);
    }
    /// How far a voxel's middle may lie from the plane of a slice that is one voxel thick.
    [[nodiscard]] double halfThicknessMm()
    {
        double half = 0.0;
        for (int axis = 0; axis < 3; ++axis)
            half = std::max(half,
                std::abs(
                    glm::dot(normal(), glm::dvec3(workspace.volume()->geometry.indexToWorld[axis])))
                    / 2.0);
        return half;
    }
    /// Calls @p take with every voxel: whether it is the segment's, its distances from the middle
    /// of the head and from the plane, mm.
    void forEachVoxel(const std::function<void(bool, double, double)>& take)
    {
        const auto held = voxels();
        const glm::ivec3 size = workspace.volume()->geometry.size;
        const glm::dvec3 middle = place(glm::dvec3(20.0));
        const glm::dvec3 inPlane = workspace.plane().pose().centreLps;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) {
                    const glm::dvec3 there = place(glm::dvec3(x, y, z));
                    take(held.count({x, y, z}) == 1, glm::distance(there, middle),
                        std::abs(glm::dot(there - inPlane, normal())));
                }
    }

    ui::PlaneView& view;
};

constexpr double unsureMm = 0.05; ///< places are rounded when they become an edit
constexpr double ventricleMm = 5.0;
constexpr double brainMm = 13.0;
constexpr double headMm = 16.0;

} // namespace

/// What follows the picture does so in a slice along no axis as well.
class ObliqueEdgesUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void theBrushFollowsEdges_data() { test::addMouseAndPen(); }
    void theBrushFollowsEdges()
    {
        QFETCH(const test::DrawnBy, by);
        ObliqueFixture fixture;
        const glm::dvec3 normal = fixture.normal();
        QVERIFY(std::abs(normal.x) > 0.2 && std::abs(normal.y) > 0.2 && std::abs(normal.z) > 0.2);
        ui::PaintTool paint(fixture.workspace);
        fixture.workspace.setActiveTool(&paint);
        fixture.workspace.setBrushSettings(ui::Workspace::Brush::Paint,
            {.radiusMm = 9.0, .disc = true, .followsEdges = true, .edgeTolerance = 10.0});
        const double half = fixture.halfThicknessMm();

        // From the ventricle into the brain: it takes the ventricle, in the slice alone.
        test::drawStroke(
            by, fixture.view, {fixture.at(0.0, 0.0), fixture.at(2.5, 0.0), fixture.at(8.0, 1.0)});
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(2)); // a segment for it, and the stroke
        const auto stroke = fixture.session().history().rows().back().edit.get<core::PaintStroke>();
        QCOMPARE(stroke.edgeTolerance.value_or(-1.0), 10.0);
        QVERIFY(stroke.path.shape == core::BrushPath::Shape::Disc);
        QVERIFY(stroke.path.normalLps);
        QVERIFY(std::abs(std::abs(glm::dot(*stroke.path.normalLps, normal)) - 1.0) < 1e-4);
        int missed = 0;
        int beyond = 0;
        int inside = 0;
        fixture.forEachVoxel([&](bool held, double fromMiddle, double fromPlane) {
            if (held && (fromMiddle >= ventricleMm || fromPlane > half + unsureMm))
                ++beyond;
            // At the rim of the slice a voxel may be connected with no other one.
            if (!held && fromMiddle < ventricleMm - 1.0 && fromPlane < half - unsureMm)
                ++missed;
            inside += held ? 1 : 0;
        });
        QCOMPARE(beyond, 0);
        QCOMPARE(missed, 0);
        QVERIFY(inside > 30);
        test::WorkspaceFixture recipe;
        recipe.apply(fixture.session().history().row(1).edit);
        recipe.apply(stroke);
        QCOMPARE(recipe.session().stateHash(), fixture.session().stateHash());

        // Begun in the brain it takes that, without the ventricle and without the bone.
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());
        test::drawStroke(by, fixture.view, {fixture.at(9.0, 0.0)});
        QVERIFY(fixture.session().settle());
        int brain = 0;
        int others = 0;
        fixture.forEachVoxel([&](bool held, double fromMiddle, double fromPlane) {
            const bool fits =
                fromMiddle >= ventricleMm && fromMiddle < brainMm && fromPlane < half + unsureMm;
            (fits ? brain : others) += held ? 1 : 0;
        });
        QCOMPARE(others, 0);
        QVERIFY(brain > 50);
    }

    /// Its pixels show the nearest voxels, so that the head is found to within one of them.
    void aWireFollowsTheEdge_data() { test::addMouseAndPen(); }
    void aWireFollowsTheEdge()
    {
        QFETCH(const test::DrawnBy, by);
        ObliqueFixture fixture;
        ui::FillOutlineTool wire(fixture.workspace);
        wire.setShape(ui::FillOutlineTool::Shape::Livewire);
        fixture.workspace.setActiveTool(&wire);
        constexpr int anchors = 6;
        for (int i = 0; i < anchors; ++i) {
            const double angle = 2.0 * M_PI * i / anchors;
            test::drawStroke(
                by, fixture.view, {fixture.at(headMm * std::cos(angle), headMm * std::sin(angle))});
            QCOMPARE(fixture.rows(), std::size_t(0));
            QVERIFY(wire.canTakeStepBack());
        }
        QTest::keyClick(&fixture.view, Qt::Key_Return);
        QVERIFY(QTest::qWaitFor(
            [&fixture] {
                fixture.session().poll();
                return fixture.rows() == 2; // a segment for it, and the outline
            },
            30000));
        QVERIFY(fixture.session().settle());
        const auto& edit = fixture.session().history().rows().back().edit.get<core::FillOutline>();
        QVERIFY(!edit.erase);
        QVERIFY(edit.polygonMm.size() > 4 * anchors); // it has corners that nobody clicked

        const double half = fixture.halfThicknessMm();
        // From a voxel to its foot in the plane, to the centre of the pixel, and to its voxel.
        const double unsureEdgeMm = half + std::sqrt(0.5) + std::sqrt(0.25 + 0.25 + 0.5625);
        int missed = 0;
        int beyond = 0;
        int inside = 0;
        fixture.forEachVoxel([&](bool held, double fromMiddle, double fromPlane) {
            if (held && (fromMiddle > headMm + unsureEdgeMm || fromPlane > half + unsureMm))
                ++beyond;
            if (!held && fromMiddle < headMm - unsureEdgeMm && fromPlane < half - unsureMm)
                ++missed;
            inside += held ? 1 : 0;
        });
        QCOMPARE(beyond, 0);
        QCOMPARE(missed, 0);
        QVERIFY(inside > 300);
    }
};

BURIN_WINDOW_TEST(ObliqueEdgesUiTest)

} // namespace obliqueEdgesUiTest

#include "ObliqueEdgesUiTest.moc"
