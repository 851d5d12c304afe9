// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/ApplyTemplate.h"
#include "core/edits/kinds/surface/AttractSurface.h"
#include "core/edits/kinds/surface/MarkSurface.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/SurfaceWindow.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/Refinement.h"

#include <QSignalSpy>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <vector>

namespace refineStrokesUiTest {

namespace {

using Mode = ui::Refinement::Mode;
using Places = std::vector<glm::dvec3>;

constexpr double radius = test::SurfaceWindow::ballRadius;

/// How a lobe on the patient's left ought to run in the axial slice through the middle, or in the
/// coronal one: 5 mm farther out than the ball.
Places lobeAlong(const glm::dvec3& side)
{
    Places line;
    for (int i = -8; i <= 8; ++i) {
        const double off = 0.75 * i;
        line.push_back(glm::dvec3(radius + 5.0 - 0.14 * off * off, 0.0, 0.0) + off * side);
    }
    return line;
}

const glm::dvec3 inAxial(0.0, 1.0, 0.0);
const glm::dvec3 inCoronal(0.0, 0.0, 1.0);

/// The surface of a ball in the brain, 2 to 3 mm within the bone; the 3D view looks at its front.
class StrokesFixture : public test::SurfaceWindow {
public:
    StrokesFixture()
        : axial(window.views().axial())
        , coronal(window.views().coronal())
        , view(window.views().volume())
        , refinement(workspace.refinement())
    {
        workspace.setCrosshairLps(glm::dvec3(0.0));
        view.lookFrom({0.0, -1.0, 0.0});
        settle();
    }
    void draw(ui::ImageView& where, test::DrawnBy by, const Places& places,
        Qt::KeyboardModifiers keys = {})
    {
        std::vector<QPointF> way;
        for (const glm::dvec3& place : places)
            way.push_back(where.context().toPixel(place));
        test::drawStroke(by, where, way, keys);
        settle();
    }
    /// Both contours of the lobe, which are two then.
    void drawLobe(test::DrawnBy by)
    {
        refinement.setSettings({.mode = Mode::Template});
        draw(axial, by, lobeAlong(inAxial));
        draw(coronal, by, lobeAlong(inCoronal));
        QCOMPARE(refinement.contours().size(), std::size_t(2));
    }
    /// Of the nearest vertex as it is shown, mm.
    [[nodiscard]] double apartFrom(const glm::dvec3& placeLps) const
    {
        const core::SurfaceMirror& mirror = refinement.mirror();
        return glm::distance(mirror.vertex(mirror.nearestVertex(placeLps)).positionLps, placeLps);
    }
    /// How far out the vertex lies that is nearest to a place, along the line from the middle, mm.
    [[nodiscard]] double heightAt(const glm::dvec3& placeLps) const
    {
        const core::SurfaceMirror& mirror = refinement.mirror();
        return glm::dot(
            mirror.vertex(mirror.nearestVertex(placeLps)).positionLps, glm::normalize(placeLps));
    }
    [[nodiscard]] const core::HistoryRow& lastRow() { return session().history().rows().back(); }
    /// How many voxels the segment gains when the surface is written back.
    [[nodiscard]] std::int64_t gain()
    {
        const std::int64_t before = session().document().segment(1)->voxels;
        refinement.writeBack();
        settle();
        return session().document().segment(1)->voxels - before;
    }

    ui::SliceView& axial;
    ui::SliceView& coronal;
    ui::VolumeView& view;
    ui::Refinement& refinement;
};

} // namespace

/// Strokes of the tools of the surface that are neither pushed nor dragged, by mouse and by pen.
class RefineStrokesUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// The inner face of the bone, 13 mm from the middle, draws the surface on.
    void edgesAttract_data()
    {
        QTest::addColumn<test::DrawnBy>("by");
        QTest::addColumn<bool>("inVolume");
        for (const auto by : {test::DrawnBy::Mouse, test::DrawnBy::Pen}) {
            const char* name = by == test::DrawnBy::Mouse ? "mouse" : "pen";
            QTest::addRow("on a slice, %s", name) << by << false;
            QTest::addRow("in 3D, %s", name) << by << true;
        }
    }
    void edgesAttract()
    {
        QFETCH(const test::DrawnBy, by);
        QFETCH(const bool, inVolume);
        StrokesFixture fixture;
        fixture.refinement.setSettings({.mode = Mode::Attract, .radiusMm = 8.0});
        // As deep as the edge lies where the stroke is drawn: the last brain and the first bone
        // are half a voxel before and behind it.
        const glm::dvec3 edge = inVolume ? glm::dvec3(0.0, -12.5, 0.0) : glm::dvec3(12.5, 0.0, 0.0);
        const glm::dvec3 side = inVolume ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
        const glm::dvec3 middle =
            inVolume ? glm::dvec3(0.0, -radius, 0.0) : glm::dvec3(radius, 0.0, 0.0);
        const std::size_t rows = fixture.rows();
        const double before = fixture.heightAt(edge);
        QVERIFY2(before < glm::length(edge) - 1.5, QByteArray::number(before).constData());
        ui::ImageView& where = inVolume ? static_cast<ui::ImageView&>(fixture.view) : fixture.axial;
        fixture.draw(where, by, {middle - 3.0 * side, middle, middle + 3.0 * side});
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(fixture.lastRow().edit.is<core::AttractSurface>());
        QVERIFY2(fixture.lastRow().name.contains(QStringLiteral("8.0 mm")),
            qPrintable(fixture.lastRow().name));
        const double after = fixture.heightAt(edge);
        QVERIFY2(after > before + 0.7 && after < glm::length(edge) + 0.7,
            QByteArray::number(after).constData());
        QVERIFY(fixture.refinement.mirror().markCounts()[std::size_t(core::SurfaceMark::Red)] > 5);
        const std::int64_t gained = fixture.gain();
        QVERIFY2(gained > 20, QByteArray::number(qlonglong(gained)).constData());
        QVERIFY(test::isWhatARecipeComesTo(fixture.session()));
    }

    /// Contours are no steps; what they make is one, and the surface lies on them then.
    void contoursMakeATemplate_data() { test::addMouseAndPen(); }
    void contoursMakeATemplate()
    {
        QFETCH(const test::DrawnBy, by);
        StrokesFixture fixture;
        fixture.apply(core::MarkSurface{.mark = core::SurfaceMark::Red,
            .path = {.radiusMm = 7.0, .pointsLps = {glm::dvec3(radius, 0.0, 0.0)}}});
        fixture.settle();
        const std::size_t rows = fixture.rows();
        fixture.drawLobe(by);
        QCOMPARE(fixture.rows(), rows);
        const glm::dvec3 top(radius + 5.0, 0.0, 0.0);
        for (const auto& contour : fixture.refinement.contours()) {
            const auto nearest =
                std::min_element(contour.begin(), contour.end(), [&](const auto& a, const auto& b) {
                    return glm::distance(a, top) < glm::distance(b, top);
                });
            QVERIFY(glm::distance(*nearest, top) < 1.0); // where the pointer was
        }
        QVERIFY(fixture.apartFrom(top) > 3.0);
        fixture.refinement.previewTemplate();
        fixture.refinement.takeTemplate();
        fixture.settle();
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(fixture.lastRow().edit.is<core::ApplyTemplate>());
        QVERIFY(fixture.refinement.contours().empty());
        QVERIFY2(
            fixture.apartFrom(top) < 1.5, QByteArray::number(fixture.apartFrom(top)).constData());
        const std::int64_t gained = fixture.gain();
        QVERIFY2(gained > 50, QByteArray::number(qlonglong(gained)).constData());
        QVERIFY(test::isWhatARecipeComesTo(fixture.session()));
    }

    /// Contours of the slice are rubbed out; those of others, which are only seen through it, stay.
    void contoursAreRubbedOut_data() { test::addWhatInverts(); }
    void contoursAreRubbedOut()
    {
        QFETCH(const test::DrawnBy, by);
        StrokesFixture fixture;
        fixture.drawLobe(test::DrawnBy::Pen);
        const std::size_t rows = fixture.rows();
        const auto rub = [&](ui::ImageView& where, const Places& places) {
            fixture.draw(where, by, places, test::invertingKeys(by));
            return fixture.refinement.contours().size();
        };
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        // Between both: nothing, which is told. Where the other slice's contour crosses, likewise.
        QCOMPARE(rub(fixture.axial, {{radius - 6.0, 8.0, 0.0}}), std::size_t(2));
        QCOMPARE(said.size(), 1);
        QVERIFY(said.back().front().toString().contains(QStringLiteral("No contour")));
        QCOMPARE(rub(fixture.axial, {{radius + 2.0, 0.0, 0.0}}), std::size_t(2));
        QCOMPARE(said.size(), 2);
        QCOMPARE(fixture.tool.target(), QStringLiteral("rubs contours out"));
        // A stroke across it takes it away, though no event lies on it.
        QCOMPARE(
            rub(fixture.axial, {{radius + 8.0, 3.0, 0.0}, {radius, 3.0, 0.0}}), std::size_t(1));
        QCOMPARE(said.size(), 2);
        for (const glm::dvec3& point : fixture.refinement.contours().front())
            QVERIFY(std::abs(point.y) < 1.0); // the coronal one is left
        // A touch does.
        QCOMPARE(rub(fixture.coronal, {lobeAlong(inCoronal)[3]}), std::size_t(0));
        QCOMPARE(fixture.rows(), rows);
        // Without it contours are drawn.
        fixture.draw(fixture.axial, test::DrawnBy::Pen, lobeAlong(inAxial));
        QCOMPARE(fixture.refinement.contours().size(), std::size_t(1));
    }

    /// What is previewed is taken back only where a contour goes.
    void aPreviewGoesWithItsContour()
    {
        StrokesFixture fixture;
        fixture.apply(core::MarkSurface{.mark = core::SurfaceMark::Red,
            .path = {.radiusMm = 7.0, .pointsLps = {glm::dvec3(radius, 0.0, 0.0)}}});
        fixture.settle();
        fixture.drawLobe(test::DrawnBy::Mouse);
        fixture.refinement.previewTemplate();
        QVERIFY(fixture.refinement.isPreviewing());
        const auto touch = [&](const glm::dvec3& place) {
            test::drawStroke(
                test::DrawnBy::Eraser, fixture.axial, {fixture.axial.context().toPixel(place)});
        };
        touch({radius - 6.0, 8.0, 0.0});
        QVERIFY(fixture.refinement.isPreviewing());
        touch(lobeAlong(inAxial)[3]);
        fixture.settle();
        QVERIFY(!fixture.refinement.isPreviewing());
        QCOMPARE(fixture.refinement.contours().size(), std::size_t(1));
    }
};

BURIN_WINDOW_TEST(RefineStrokesUiTest)

} // namespace refineStrokesUiTest

#include "RefineStrokesUiTest.moc"
