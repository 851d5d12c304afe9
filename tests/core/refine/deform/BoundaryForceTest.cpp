// SPDX-License-Identifier: Apache-2.0
#include "core/refine/deform/BoundaryForce.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/ShapedMask.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <cmath>

namespace boundaryForceTest {

/// The smooth boundary of a mask, and the way to it.
class BoundaryForceTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void centresAreWhatTheirVoxelsAre();
    void flatFacesLieBetweenVoxels();
    void aBallDoesNotShrink();
    void thinPartsHaveABoundary();
    void theWayToTheBoundary();
    void onUnevenSlices();
    void crumpledNormals();
    void bentSurfacesAreWantedFartherOut();
    void onlyYellowFollows();
};

void BoundaryForceTest::centresAreWhatTheirVoxelsAre()
{
    auto random = test::Random(2);
    for (int trial = 0; trial < (test::longRun() ? 100 : 5); ++trial) {
        test::ShapedMask made({test::randomInt(random, 1, 20), test::randomInt(random, 1, 20),
            test::randomInt(random, 1, 20)});
        const int share = test::randomInt(random, 2, 98);
        for (auto& label : made.labels)
            label = test::randomInt(random, 0, 99) < share ? 1 : 0;
        const core::BoxMask mask = made.mask();
        const core::SmoothOccupancy field(mask);
        for (int z = -4; z < 24; ++z) {
            for (int y = -4; y < 24; ++y) {
                for (int x = -4; x < 24; ++x) {
                    const double value = field.at(glm::dvec3(x, y, z));
                    QVERIFY(mask.contains({x, y, z}) ? value >= 0.6875 : value <= 0.3125);
                }
            }
        }
    }
    QCOMPARE(core::SmoothOccupancy(core::BoxMask()).at({1, 2, 3}), 0.0);
}

void BoundaryForceTest::flatFacesLieBetweenVoxels()
{
    for (int axis = 0; axis < 3; ++axis) {
        test::ShapedMask made({30, 30, 30});
        made.fill([&](const glm::dvec3& at) { return at[axis] >= 10.0; });
        const core::SmoothOccupancy field(made.mask());
        glm::dvec3 at(15.2, 15.7, 14.9);
        at[axis] = 9.5;
        QCOMPARE(field.at(at), 0.5);
        // The same on either side.
        glm::dvec3 before = at;
        glm::dvec3 beyond = at;
        before[axis] = 8.2;
        beyond[axis] = 10.8;
        QVERIFY(std::abs(field.at(before) + field.at(beyond) - 1.0) < 1e-12);
        QVERIFY(field.at(before) < 0.1);
    }
}

void BoundaryForceTest::aBallDoesNotShrink()
{
    test::ShapedMask made({50, 50, 50});
    const glm::dvec3 middle(24.3, 24.6, 25.1);
    made.fill([&](const glm::dvec3& at) { return glm::distance(at, middle) < 15.0; });
    const core::BoundaryForce force(made.mask(), made.geometry, 3.0);
    auto random = test::Random(1);
    double sum = 0.0;
    double most = 0.0;
    constexpr int count = 2000;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 way = glm::normalize(
            glm::dvec3{test::randomUnit(random), test::randomUnit(random), test::randomUnit(random)}
            - 0.5);
        const auto off = force.alongNormalMm(made.lps(middle + 15.0 * way), way);
        QVERIFY(off.has_value());
        sum += *off;
        most = std::max(most, std::abs(*off));
    }
    qInfo("a ball of radius 15: mean %.4f voxels off, at most %.3f", sum / count, most);
    QVERIFY(std::abs(sum / count) < 0.03);
    QVERIFY(most < 0.5);
}

void BoundaryForceTest::thinPartsHaveABoundary()
{
    test::ShapedMask made({20, 20, 20});
    made.at(4, 4, 4) = 1;
    for (int x = 9; x < 16; ++x) {
        made.at(x, 4, 12) = 1;
        for (int y = 9; y < 16; ++y)
            made.at(x, y, 5) = 1;
    }
    const core::BoundaryForce force(made.mask(), made.geometry, 3.0);
    const glm::dvec3 up(0, 0, 1);
    for (const glm::dvec3& place :
        {glm::dvec3(4, 4, 4), glm::dvec3(12, 4, 12), glm::dvec3(12, 12, 5)}) {
        for (const double from : {0.0, 0.4, 1.5}) {
            const auto off = force.alongNormalMm(made.lps(place + from * up), up);
            QVERIFY(off.has_value());
            QVERIFY2(
                from + *off > 0.25 && from + *off <= 0.5, qPrintable(QString::number(from + *off)));
        }
    }
}

void BoundaryForceTest::theWayToTheBoundary()
{
    test::ShapedMask made({30, 30, 30}, {0.5, 0.5, 2.0});
    made.fill([](const glm::dvec3& at) { return at.z > 19.0 && at.z < 41.0; });
    const core::BoundaryForce force(made.mask(), made.geometry, 4.0);
    const glm::dvec3 down(0, 0, -1);
    for (const double z : {12.5, 14.0, 17.3, 18.9, 19.1, 20.5, 23.0}) {
        const auto off = force.alongNormalMm(made.lps({7, 8, z}), down);
        QVERIFY(off.has_value());
        QVERIFY2(std::abs(z - *off - 19.0) < 1e-3, qPrintable(QString::number(z - *off)));
    }
    // Beyond reach, away from it, and without a normal.
    QVERIFY(!force.alongNormalMm(made.lps({7, 8, 9.0}), down));
    QVERIFY(!force.alongNormalMm(made.lps({7, 8, 17.0}), -down));
    QVERIFY(!force.alongNormalMm(made.lps({7, 8, 17.0}), glm::dvec3(0.0)));
    // Aslant: as far as it is along the way.
    const glm::dvec3 aslant = glm::normalize(glm::dvec3(0.3, 0.1, -1.0));
    const auto off = force.alongNormalMm(made.lps({7, 8, 20.5}), aslant);
    QVERIFY(off.has_value());
    QVERIFY(std::abs(*off * aslant.z + 1.5) < 0.01);
}

void BoundaryForceTest::onUnevenSlices()
{
    test::ShapedMask made({20, 20, 5}, {1, 1, 2});
    for (const double z : {0.0, 2.0, 5.0, 10.0, 12.0})
        made.geometry.slicePositions.push_back(made.geometry.originLps() + glm::dvec3(0, 0, z));
    made.fill([](const glm::dvec3& at) { return at.z < 5.0; });
    const core::BoundaryForce force(made.mask(), made.geometry, 4.0);
    // Between the slices at 5 and 10 mm.
    const auto off = force.alongNormalMm(made.lps({9, 9, 6.5}), {0, 0, 1});
    QVERIFY(off.has_value());
    QVERIFY2(std::abs(6.5 + *off - 7.5) < 1e-3, qPrintable(QString::number(6.5 + *off)));
}

void BoundaryForceTest::crumpledNormals()
{
    test::ShapedMask made({30, 30, 30}, {1, 1, 2});
    made.fill([](const glm::dvec3& at) { return at.z > 19.0; });
    const core::BoundaryForce force(made.mask(), made.geometry, 4.0);
    // Along the boundary, or, outside, inwards: the shortest way. The boundary lies at 19 mm.
    for (const glm::dvec3& normal :
        {glm::dvec3(1, 0, 0), glm::normalize(glm::dvec3(1, 1, -0.3)), glm::dvec3(0, 0, 1)}) {
        const core::SurfacePoint outside{
            .positionLps = made.lps({9, 9, 18.3}), .normalLps = normal};
        QVERIFY(glm::distance(force.forceMm(outside), glm::dvec3(0, 0, 0.7)) < 1e-3);
    }
    const core::SurfacePoint inside{
        .positionLps = made.lps({9, 9, 19.6}), .normalLps = {0.8, 0.6, 0}};
    QVERIFY(glm::distance(force.forceMm(inside), glm::dvec3(0, 0, -0.6)) < 1e-3);
    // Through a sheet of one voxel, where the vertex's own side is.
    test::ShapedMask sheet({20, 20, 20});
    sheet.fill([](const glm::dvec3& at) { return at.z == 10.0; });
    const core::BoundaryForce thin(sheet.mask(), sheet.geometry, 4.0);
    const core::SurfacePoint below{.positionLps = sheet.lps({9, 9, 9.8}), .normalLps = {0, 0, 1}};
    const glm::dvec3 back = thin.forceMm(below);
    QVERIFY2(back.z > 0.45 && back.z < 0.75, qPrintable(QString::number(back.z)));
}

void BoundaryForceTest::bentSurfacesAreWantedFartherOut()
{
    test::ShapedMask made({20, 20, 20});
    made.fill([](const glm::dvec3& at) { return at.x < 9.6; });
    const core::BoundaryForce force(made.mask(), made.geometry, 4.0);
    core::SurfacePoint point{.positionLps = made.lps({8.5, 9, 9}), .normalLps = {1, 0, 0}};
    point.distanceMm = 1.2;
    for (const double curvature : {0.1, -0.1, 5.0}) {
        point.curvaturePerMm = curvature;
        const double cut = std::min(7.0 / 24.0 * curvature * 1.44, 0.12);
        QVERIFY(std::abs(force.forceMm(point).x - 1.0 - cut) < 1e-3);
    }
}

void BoundaryForceTest::onlyYellowFollows()
{
    test::ShapedMask made({20, 20, 20});
    made.fill([](const glm::dvec3& at) { return at.x < 9.6; });
    const core::BoundaryForce force(made.mask(), made.geometry, 4.0);
    core::SurfacePoint point{.positionLps = made.lps({8.5, 9, 9}), .normalLps = {1, 0, 0}};
    QVERIFY(glm::distance(force.forceMm(point), glm::dvec3(1, 0, 0)) < 1e-3);
    point.mark = core::SurfaceMark::Red;
    QCOMPARE(force.forceMm(point), glm::dvec3(0.0));
    point.mark = core::SurfaceMark::Green;
    QCOMPARE(force.forceMm(point), glm::dvec3(0.0));
}

BURIN_TEST(BoundaryForceTest)

} // namespace boundaryForceTest

#include "BoundaryForceTest.moc"
