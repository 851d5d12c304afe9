// SPDX-License-Identifier: Apache-2.0
#include "ui/measure/CentreOnSegment.h"

#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/views/ViewGrid.h"

#include <QSignalSpy>
#include <QTest>

#include <cmath>
#include <functional>

namespace centreOnSegmentUiTest {

namespace {

/// The small study with a segment that has nothing yet, and one for each test.
class Fixture : public test::WindowFixture {
public:
    Fixture()
        : WindowFixture(test::smallStudy())
    {
        apply(test::addSegment("Parts"));
        apply(test::addSegment("Nothing"));
        QObject::connect(
            &workspace, &ui::Workspace::viewsCentred, &listener, [this] { ++centred; });
    }
    [[nodiscard]] glm::dvec3 placeOf(const glm::dvec3& voxel) const
    {
        return workspace.volume()->geometry.toWorld(voxel);
    }
    [[nodiscard]] bool waitFor(const std::function<bool()>& reached)
    {
        return QTest::qWaitFor(
            [&] {
                if (workspace.session())
                    session().poll();
                return reached();
            },
            60000);
    }
    [[nodiscard]] bool centresOn(int label)
    {
        const int before = centred;
        ui::centreOnSegment(workspace, label);
        return waitFor([&] { return centred > before; });
    }

    int centred = 0;
    QObject listener; ///< goes before what it writes
};

/// Whether a place is seen in the middle of a slice.
bool isInTheMiddle(const ui::SliceView& view, const glm::dvec3& placeLps)
{
    const QPointF away =
        view.context().toPixel(placeLps) - QPointF(view.width() / 2.0, view.height() / 2.0);
    return std::abs(away.x()) < 1.0 && std::abs(away.y()) < 1.0;
}

double scaleOf(const ui::SliceView& view)
{
    return std::get<gpu::SliceScene>(view.context().scene).mmPerPixel;
}

} // namespace

class CentreOnSegmentUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// A ball: crosshair and views go to its centre, as near as they looked before.
    void everyViewShowsItsMiddle()
    {
        Fixture fixture;
        const glm::dvec3 centre = fixture.placeOf({30.0, 8.0, 6.0});
        fixture.apply(test::paintAt(1, {centre}, 3.2));
        const std::size_t rows = fixture.session().history().rows().size();
        ui::ViewGrid& views = fixture.window.views();
        const auto slices = {&views.axial(), &views.sagittal(), &views.coronal()};
        std::vector<double> scales;
        for (const ui::SliceView* view : slices) {
            QVERIFY(!isInTheMiddle(*view, centre));
            scales.push_back(scaleOf(*view));
        }
        const double height = views.volume().camera().heightMm;
        fixture.workspace.setActiveSegment(1);
        QAction& action = fixture.window.actionTable()[QStringLiteral("segments.centre")];
        QCOMPARE(action.text(), QStringLiteral("Centre views on 'Parts'"));
        action.trigger();
        QVERIFY(fixture.waitFor([&] { return fixture.centred == 1; }));
        QVERIFY(glm::length(fixture.workspace.crosshairLps() - centre) < 1e-9);
        std::size_t place = 0;
        for (const ui::SliceView* view : slices) {
            QVERIFY2(isInTheMiddle(*view, centre), qPrintable(view->title()));
            QCOMPARE(scaleOf(*view), scales[place++]);
        }
        QVERIFY(glm::length(views.volume().camera().targetLps - centre) < 1e-9);
        QCOMPARE(views.volume().camera().heightMm, height);
        QCOMPARE(fixture.session().history().rows().size(), rows);
    }

    /// Where the middle is empty the crosshair stands on the segment all the same.
    void theCrosshairStandsOnTheSegment()
    {
        Fixture fixture;
        fixture.apply(test::paintAt(1, {fixture.placeOf({8.0, 10.0, 8.0})}, 1.6));
        fixture.apply(test::paintAt(1, {fixture.placeOf({30.0, 10.0, 8.0})}, 1.6));
        QVERIFY(fixture.centresOn(1));
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        const glm::ivec3 at(glm::floor(geometry.toIndex(fixture.workspace.crosshairLps()) + 0.5));
        const auto labels = fixture.session().questions().labels(0);
        QVERIFY(labels);
        const std::size_t voxel = std::size_t(at.x)
            + std::size_t(geometry.size.x)
                * (std::size_t(at.y) + std::size_t(geometry.size.y) * std::size_t(at.z));
        QCOMPARE(int((*labels)[voxel]), 1);
        const glm::dvec3 middle = fixture.placeOf({19.0, 10.0, 8.0});
        QVERIFY(isInTheMiddle(fixture.window.views().axial(), middle));
        QVERIFY(glm::length(fixture.window.views().volume().camera().targetLps - middle) < 1e-9);
    }

    void anEmptyOneSaysSo()
    {
        Fixture fixture;
        const glm::dvec3 crosshair = fixture.workspace.crosshairLps();
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        ui::centreOnSegment(fixture.workspace, 2);
        QVERIFY(fixture.waitFor([&] { return !said.isEmpty(); }));
        QCOMPARE(
            said.front().front().toString(), QStringLiteral("'Nothing' has no voxels to look at"));
        QCOMPARE(fixture.centred, 0);
        QVERIFY(fixture.workspace.crosshairLps() == crosshair);
        QVERIFY(!fixture.window.views().axial().place());
    }

    /// A view that is not seen, and fits the window, fits it when it comes back.
    void aHiddenViewGoesOnToFit()
    {
        Fixture fixture;
        fixture.apply(test::paintAt(1, {fixture.placeOf({30.0, 8.0, 6.0})}, 3.2));
        ui::ViewGrid& views = fixture.window.views();
        views.maximise(&views.axial());
        QVERIFY(fixture.centresOn(1));
        QVERIFY(views.axial().place());
        QVERIFY(!views.coronal().place());
        QVERIFY(!views.plane().place());
        QVERIFY(views.volume().fitted());
    }

    /// Who is impatient is shown it once.
    void asksOnce()
    {
        Fixture fixture;
        fixture.apply(test::paintAt(1, {fixture.placeOf({30.0, 8.0, 6.0})}, 3.2));
        ui::centreOnSegment(fixture.workspace, 1);
        ui::centreOnSegment(fixture.workspace, 1);
        QVERIFY(fixture.waitFor([&] { return fixture.centred > 0; }));
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        ui::centreOnSegment(fixture.workspace, 2);
        QVERIFY(fixture.waitFor([&] { return !said.isEmpty(); }));
        QCOMPARE(fixture.centred, 1);
    }

    /// The study is closed meanwhile: nothing is shown, and nothing is left behind.
    void aClosedStudyEndsTheSearch()
    {
        Fixture fixture;
        fixture.apply(test::paintAt(1, {fixture.placeOf({30.0, 8.0, 6.0})}, 3.2));
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        ui::centreOnSegment(fixture.workspace, 1);
        fixture.workspace.setSession(nullptr);
        ui::centreOnSegment(fixture.workspace, 1);
        QTest::qWait(50);
        QCOMPARE(fixture.centred, 0);
        QVERIFY(said.isEmpty() && failed.isEmpty());
        QVERIFY(!fixture.workspace.findChild<QObject*>(QStringLiteral("centreOnSegment")));
    }
};

BURIN_WINDOW_TEST(CentreOnSegmentUiTest)

} // namespace centreOnSegmentUiTest

#include "CentreOnSegmentUiTest.moc"
