// SPDX-License-Identifier: Apache-2.0
#include "ui/overlays/MeasurementLines.h"

#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/views/ViewGrid.h"

#include <QTest>

namespace measurementLinesUiTest {

namespace {

constexpr double pixelMm = 0.5;
constexpr double sliceMm = 5.0;

/// Slices ten times as far apart as pixels.
glm::dmat4 thickSlices()
{
    glm::dmat4 matrix(1.0);
    matrix[0][0] = matrix[1][1] = pixelMm;
    matrix[2][2] = sliceMm;
    return matrix;
}

} // namespace

class MeasurementLinesUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Across a slice its voxels are as thick as they are there, however long along it.
    void aMeasurementIsSeenInItsSlice()
    {
        test::WindowFixture fixture(thickSlices());
        ui::ViewGrid& views = fixture.window.views();
        const auto isSeen = [&](const ui::SliceView& view, double awayMm) {
            ui::ViewContext context = view.context();
            auto& slice = std::get<gpu::SliceScene>(context.scene);
            const core::Measurement measured{
                .id = 1, .pointsLps = {slice.centreLps, slice.centreLps + 10.0 * slice.rightLps}};
            slice.centreLps += awayMm * glm::cross(slice.rightLps, slice.downLps);
            return ui::isShown(measured, context, fixture.workspace);
        };
        for (const ui::SliceView* view : {&views.sagittal(), &views.coronal()}) {
            for (const double side : {-1.0, 1.0}) {
                QVERIFY(isSeen(*view, 0.0));
                QVERIFY(isSeen(*view, side * 0.5 * pixelMm)); // between two slices: in both
                for (int away = 1; away <= 5; ++away)
                    QVERIFY2(!isSeen(*view, side * away * pixelMm), qPrintable(view->title()));
            }
        }
        QVERIFY(isSeen(views.axial(), 0.4 * sliceMm));
        QVERIFY(isSeen(views.axial(), -0.5 * sliceMm));
        QVERIFY(!isSeen(views.axial(), 0.6 * sliceMm));
    }
};

BURIN_WINDOW_TEST(MeasurementLinesUiTest)

} // namespace measurementLinesUiTest

#include "MeasurementLinesUiTest.moc"
