// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/Actions.h"
#include "ui/overlays/ReferenceLines.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/CuttingPlane.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace referenceLinesUiTest {

namespace {

constexpr double tiny = 1e-6;

/// How far a place lies beyond the border of the volume, in voxels; negative: inside.
double beyondBorder(const core::VolumeGeometry& geometry, const glm::dvec3& lps)
{
    const glm::dvec3 index = geometry.toIndex(lps);
    double most = -1e9;
    for (int axis = 0; axis < 3; ++axis) {
        most = std::max(most, -0.5 - index[axis]);
        most = std::max(most, index[axis] - (geometry.size[axis] - 0.5));
    }
    return most;
}

QImage seen(ui::ImageView& view)
{
    return view.grab().toImage().convertToFormat(QImage::Format_RGB32);
}

/// Whether pictures differ within two pixels of a place.
bool differsNear(const QImage& a, const QImage& b, const QPointF& at)
{
    for (int y = int(at.y()) - 2; y <= int(at.y()) + 2; ++y) {
        for (int x = int(at.x()) - 2; x <= int(at.x()) + 2; ++x) {
            if (a.rect().contains(x, y) && a.pixel(x, y) != b.pixel(x, y))
                return true;
        }
    }
    return false;
}

} // namespace

class ReferenceLinesUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void linesLieInBothPlanesAndEndAtTheVolume_data();
    void linesLieInBothPlanesAndEndAtTheVolume();
    void linesAreDrawnWithAGapAroundTheCrosshair();
    void theCuttingPlaneShowsAllThree();
};

void ReferenceLinesUiTest::linesLieInBothPlanesAndEndAtTheVolume_data()
{
    QTest::addColumn<bool>("oblique");
    QTest::newRow("along the patient") << false;
    QTest::newRow("oblique volume") << true;
}

void ReferenceLinesUiTest::linesLieInBothPlanesAndEndAtTheVolume()
{
    QFETCH(bool, oblique);
    test::WindowFixture fixture(oblique ? test::oblique() : test::headFirstSupine());
    const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
    fixture.workspace.setCrosshairLps(
        fixture.workspace.crosshairLps() + glm::dvec3(5.0, -7.0, 4.0));
    const ui::ViewContext view = fixture.window.views().axial().context();
    const auto& slice = std::get<gpu::SliceScene>(view.scene);
    const glm::dvec3 across = glm::cross(slice.rightLps, slice.downLps);
    // Sagittal, coronal, and one that is turned.
    for (const glm::dvec3& normal : {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0),
             glm::normalize(glm::dvec3(1.0, 2.0, 0.5))}) {
        const ui::ReferencePlane plane{
            .pointLps = fixture.workspace.crosshairLps(), .normalLps = normal, .colour = {}};
        const auto line = ui::referenceLine(view, plane, geometry);
        QVERIFY(line.has_value());
        for (const glm::dvec3& end : {line->first, line->second}) {
            QVERIFY(std::abs(glm::dot(end - slice.centreLps, across)) < tiny);
            QVERIFY(std::abs(glm::dot(end - plane.pointLps, normal)) < tiny);
            QVERIFY(std::abs(beyondBorder(geometry, end)) < tiny);
        }
        // The crosshair lies between the ends.
        QVERIFY(glm::dot(line->first - plane.pointLps, line->second - plane.pointLps) < 0.0);
    }
    // In itself, beside itself, and beside the volume it shows none.
    ui::ReferencePlane none{
        .pointLps = fixture.workspace.crosshairLps(), .normalLps = across, .colour = {}};
    QVERIFY(!ui::referenceLine(view, none, geometry));
    none.pointLps += 5.0 * across;
    QVERIFY(!ui::referenceLine(view, none, geometry));
    none.normalLps = {1.0, 0.0, 0.0};
    none.pointLps += glm::dvec3(1000.0, 0.0, 0.0);
    QVERIFY(!ui::referenceLine(view, none, geometry));
}

void ReferenceLinesUiTest::linesAreDrawnWithAGapAroundTheCrosshair()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::SliceView& axial = fixture.window.views().axial();
    ui::Actions& actions = fixture.window.actionTable();
    actions[QStringLiteral("view.crosshair")].trigger(); // it lies in the same place
    QCoreApplication::processEvents();
    const QImage before = seen(axial);
    QVERIFY(!fixture.workspace.viewOptions().referenceLines);
    actions[QStringLiteral("view.referenceLines")].trigger();
    QVERIFY(fixture.workspace.viewOptions().referenceLines);
    QVERIFY(actions[QStringLiteral("view.referenceLines")].isChecked());
    QCoreApplication::processEvents();
    const QImage after = seen(axial);

    const QPointF cross = axial.crosshairPixel();
    for (const QPointF& away :
        {QPointF(40.0, 0.0), QPointF(-40.0, 0.0), QPointF(0.0, 40.0), QPointF(0.0, -40.0)})
        QVERIFY(differsNear(before, after, cross + away));
    // Neither where the crosshair is nor beside the lines.
    for (const QPointF& still : {QPointF(0.0, 0.0), QPointF(8.0, 0.0), QPointF(0.0, -8.0),
             QPointF(40.0, 12.0), QPointF(-12.0, 40.0)})
        QVERIFY(!differsNear(before, after, cross + still));
    // Beyond the volume, which does not fill the view in this direction, there is none.
    const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
    const ui::ViewContext shown = axial.shownContext();
    const glm::dvec3 behind = fixture.workspace.crosshairLps() + glm::dvec3(0.0, 48.0 + 6.0, 0.0);
    QVERIFY(beyondBorder(geometry, behind) > 1.0);
    QVERIFY(!differsNear(before, after, shown.toPixel(behind)));

    actions[QStringLiteral("view.referenceLines")].trigger();
    QCoreApplication::processEvents();
    QCOMPARE(seen(axial), before);
}

void ReferenceLinesUiTest::theCuttingPlaneShowsAllThree()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::ViewGrid& grid = fixture.window.views();
    grid.arrange(ui::ViewGrid::Layout::PenAndStage);
    QTRY_VERIFY(grid.plane().isVisible());
    fixture.workspace.plane().setPose(ui::CuttingPlane::poseFacing(
        fixture.workspace.crosshairLps(), glm::normalize(glm::dvec3(1.0, 2.0, -2.0))));
    fixture.window.actionTable()[QStringLiteral("view.crosshair")].trigger();
    QTRY_VERIFY(grid.plane().quality() == gpu::Frame::Quality::Refined);
    const QImage before = seen(grid.plane());
    fixture.window.actionTable()[QStringLiteral("view.referenceLines")].trigger();
    QCoreApplication::processEvents();
    const QImage after = seen(grid.plane());
    const ui::ViewContext shown = grid.plane().shownContext();
    const auto& slice = std::get<gpu::SliceScene>(shown.scene);
    const glm::dvec3 across = glm::cross(slice.rightLps, slice.downLps);
    for (const glm::dvec3& normal :
        {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(0.0, 0.0, 1.0)}) {
        const glm::dvec3 along = glm::normalize(glm::cross(across, normal));
        const glm::dvec3 place = fixture.workspace.crosshairLps() + 12.0 * along;
        const QPointF way = shown.toPixel(place) - shown.toPixel(fixture.workspace.crosshairLps());
        QVERIFY(std::hypot(way.x(), way.y()) > 18.0); // beyond the gap
        QVERIFY(differsNear(before, after, shown.toPixel(place)));
    }
}

BURIN_WINDOW_TEST(ReferenceLinesUiTest)

} // namespace referenceLinesUiTest

#include "ReferenceLinesUiTest.moc"
