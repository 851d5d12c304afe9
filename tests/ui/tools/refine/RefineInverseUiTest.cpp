// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/PlaneScrape.h"
#include "core/edits/kinds/surface/SmoothSurface.h"
#include "core/edits/kinds/surface/SpherePush.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/SurfaceWindow.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/Refinement.h"

#include <QtTest>

#include <vector>

namespace refineInverseUiTest {

namespace {

using Mode = ui::Refinement::Mode;

constexpr double radius = test::SurfaceWindow::ballRadius;
constexpr double toolMm = 6.0;

/// The surface of a ball, seen from the front in 3D.
class InverseFixture : public test::SurfaceWindow {
public:
    InverseFixture()
        : slice(window.views().axial())
        , view(window.views().volume())
    {
        view.lookFrom({0.0, -1.0, 0.0});
        settle();
    }
    /// Draws a stroke through these places; returns how many voxels the segment gains by it.
    [[nodiscard]] std::int64_t gainOf(Mode mode, ui::ImageView& where, test::DrawnBy by,
        Qt::KeyboardModifiers keys, const std::vector<glm::dvec3>& places)
    {
        workspace.refinement().setSettings({.mode = mode, .radiusMm = toolMm});
        std::vector<QPointF> way;
        for (const glm::dvec3& place : places)
            way.push_back(where.context().toPixel(place));
        test::drawStroke(by, where, way, keys);
        settle();
        drawn = session().history().rows().back().edit;
        const std::int64_t before = session().document().segment(1)->voxels;
        workspace.refinement().writeBack();
        settle();
        return session().document().segment(1)->voxels - before;
    }

    ui::SliceView& slice;
    ui::VolumeView& view;
    core::Edit drawn; ///< the last stroke
};

QByteArray told(std::int64_t voxels)
{
    return QByteArray::number(qlonglong(voxels));
}

} // namespace

/// Ctrl and the pen's eraser end invert the tools of the surface that have an opposite.
class RefineInverseUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Beside the surface a sphere dents it; inverted it comes from within and makes a bulge.
    void theSphereOnASlice_data() { test::addWhatInverts(); }
    void theSphereOnASlice()
    {
        QFETCH(const test::DrawnBy, by);
        const std::vector<glm::dvec3> outside{{radius + 3.0, 0.0, 0.0}, {radius + 3.0, 2.0, 0.0}};
        InverseFixture plain;
        const std::int64_t lost =
            plain.gainOf(Mode::Sphere, plain.slice, test::DrawnBy::Pen, {}, outside);
        QVERIFY2(lost < -20, told(lost).constData());

        InverseFixture fixture;
        const std::int64_t gained =
            fixture.gainOf(Mode::Sphere, fixture.slice, by, test::invertingKeys(by), outside);
        QVERIFY2(gained > 20, told(gained).constData());
        // The sphere is where the pen is seen in the surface as in a mirror.
        const glm::dvec3 first = fixture.drawn.get<core::SpherePush>().path.pointsLps.front();
        const double wayMm = glm::distance(first, {radius - 3.0, 0.0, 0.0});
        QVERIFY2(wayMm < 1.5, QByteArray::number(wayMm).constData());
        QVERIFY(test::isWhatARecipeComesTo(fixture.session()));

        // From within it is the other way round.
        InverseFixture within;
        const std::int64_t dented = within.gainOf(Mode::Sphere, within.slice, by,
            test::invertingKeys(by), {{radius - 3.0, 0.0, 0.0}, {radius - 3.0, 2.0, 0.0}});
        QVERIFY2(dented < -20, told(dented).constData());
    }

    /// What stands out beyond the plane goes; inverted, what lies below is drawn up to it.
    void theScraperOnASlice_data() { test::addWhatInverts(); }
    void theScraperOnASlice()
    {
        QFETCH(const test::DrawnBy, by);
        InverseFixture plain;
        const std::int64_t lost = plain.gainOf(Mode::Scrape, plain.slice, test::DrawnBy::Pen, {},
            {{radius - 2.0, -2.0, 0.0}, {radius - 2.0, 0.0, 0.0}, {radius - 2.0, 2.0, 0.0}});
        QVERIFY2(lost < -20, told(lost).constData());
        QVERIFY(plain.drawn.get<core::PlaneScrape>().normalLps.x > 0.9); // outwards

        InverseFixture fixture;
        const std::int64_t gained =
            fixture.gainOf(Mode::Scrape, fixture.slice, by, test::invertingKeys(by),
                {{radius + 1.0, -2.0, 0.0}, {radius + 1.0, 0.0, 0.0}, {radius + 1.0, 2.0, 0.0}});
        QVERIFY2(gained > 20, told(gained).constData());
        QVERIFY(fixture.drawn.get<core::PlaneScrape>().normalLps.x < -0.9);
        QVERIFY(test::isWhatARecipeComesTo(fixture.session()));
    }

    void theScraperInThreeDimensions_data() { test::addWhatInverts(); }
    void theScraperInThreeDimensions()
    {
        QFETCH(const test::DrawnBy, by);
        InverseFixture fixture;
        const std::int64_t gained = fixture.gainOf(Mode::Scrape, fixture.view, by,
            test::invertingKeys(by), {{0.0, -radius, 0.0}, {2.0, -radius, 0.0}});
        QVERIFY2(gained > 10, told(gained).constData());
        QVERIFY(fixture.drawn.get<core::PlaneScrape>().normalLps.y > 0.9); // into the ball
    }

    /// What has no opposite does the same, and promises nothing else.
    void smoothingHasNone_data() { test::addWhatInverts(); }
    void smoothingHasNone()
    {
        QFETCH(const test::DrawnBy, by);
        InverseFixture fixture;
        static_cast<void>(fixture.gainOf(Mode::Smooth, fixture.slice, by, test::invertingKeys(by),
            {{radius, 0.0, 0.0}, {radius, 3.0, 0.0}}));
        QVERIFY(fixture.drawn.is<core::SmoothSurface>());
        QVERIFY(!fixture.tool.keys().contains(QStringLiteral("Ctrl")));
        fixture.workspace.refinement().setSettings({.mode = Mode::Scrape, .radiusMm = toolMm});
        QVERIFY(fixture.tool.keys().contains(QStringLiteral("Ctrl fills")));
    }
};

BURIN_WINDOW_TEST(RefineInverseUiTest)

} // namespace refineInverseUiTest

#include "RefineInverseUiTest.moc"
