// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/ShownSurface.h"

#include "core/measure/MeasuredSize.h"
#include "core/volume/UnevenSlices.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <cmath>

namespace shownSurfaceTest {

using namespace core;

namespace {

constexpr double near = 1e-9;

/// Slices of a tilted acquisition, evenly spaced.
VolumeGeometry evenSlices()
{
    VolumeGeometry geometry;
    geometry.size = {10, 12, 6};
    geometry.indexToWorld[0] = {1.0, 0.0, 0.0, 0.0};
    geometry.indexToWorld[1] = {0.0, 1.2, 0.0, 0.0};
    geometry.indexToWorld[2] = {0.0, 0.3, 1.5, 0.0};
    geometry.indexToWorld[3] = {-3.0, 4.0, -7.0, 1.0};
    return geometry;
}

VolumeGeometry unevenSlices()
{
    VolumeGeometry geometry = evenSlices();
    glm::dvec3 place = geometry.originLps();
    for (const double gap : {1.0, 1.0, 2.5, 2.0, 1.0, 0.0}) {
        geometry.slicePositions.push_back(place);
        place += gap * glm::dvec3(0.0, 0.2, 1.0);
    }
    return geometry;
}

SurfaceUpdate oneVertex(const glm::dvec3& positionLps, const glm::dvec3& normalLps)
{
    SurfaceUpdate update;
    update.vertices.push_back({.id = 0, .positionLps = positionLps, .normalLps = normalLps});
    return update;
}

} // namespace

/// Where views show a surface whose slices are unevenly spaced.
class ShownSurfaceTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void evenSlicesChangeNothing()
    {
        const VolumeGeometry geometry = evenSlices();
        const glm::dvec3 place(0.1, 0.7, -5.3);
        const glm::dvec3 normal = glm::normalize(glm::dvec3(1.0, 2.0, 3.0));
        SurfaceUpdate update = oneVertex(place, normal);
        moveToShown(update, geometry);
        QCOMPARE(update.vertices[0].positionLps, place);
        QCOMPARE(update.vertices[0].normalLps, normal);
        QCOMPARE(trueNormal(geometry, place, normal), normal);
        const MarkedRegion region =
            shownRegion({.middleLps = place, .normalLps = normal}, geometry);
        QCOMPARE(region.middleLps, place);
        QCOMPARE(region.normalLps, normal);
    }

    void placesAreThoseOfTheSameVoxels_data()
    {
        QTest::addColumn<double>("slice");
        for (const double slice : {0.4, 1.5, 2.4, 3.5, 4.25, -0.3, 5.3})
            QTest::addRow("%g", slice) << slice;
    }
    void placesAreThoseOfTheSameVoxels()
    {
        QFETCH(const double, slice);
        const VolumeGeometry geometry = unevenSlices();
        const glm::dvec3 index(3.2, 4.1, slice);
        const glm::dvec3 truth = worldBetweenSlices(geometry, index);
        // A part of a surface, and its normal, by two ways within it that stay between the slices.
        const glm::dvec3 one(1.0, 0.3, 0.05);
        const glm::dvec3 other(-0.2, 0.8, 0.1);
        const auto trueWay = [&](const glm::dvec3& way) {
            return worldBetweenSlices(geometry, index + way) - truth;
        };
        const glm::dvec3 normal = glm::normalize(glm::cross(trueWay(one), trueWay(other)));

        SurfaceUpdate update = oneVertex(truth, normal);
        moveToShown(update, geometry);
        const SurfaceUpdate::Vertex& shown = update.vertices[0];
        QVERIFY(glm::distance(shown.positionLps, geometry.toWorld(index)) < near);
        QVERIFY(glm::distance(truePlace(geometry, shown.positionLps), truth) < near);
        const glm::dmat3 steps(geometry.indexToWorld);
        QVERIFY(std::abs(glm::length(shown.normalLps) - 1.0) < near);
        QVERIFY(std::abs(glm::dot(shown.normalLps, steps * one)) < near);
        QVERIFY(std::abs(glm::dot(shown.normalLps, steps * other)) < near);
        QVERIFY(glm::dot(shown.normalLps, normal) > 0.0);
        QVERIFY(
            glm::distance(trueNormal(geometry, shown.positionLps, shown.normalLps), normal) < near);

        const MarkedRegion region = shownRegion(
            {.middleLps = truth, .normalLps = normal, .areaMm2 = 12.0, .vertices = 7}, geometry);
        QVERIFY(glm::distance(region.middleLps, shown.positionLps) < near);
        QVERIFY(glm::distance(region.normalLps, shown.normalLps) < near);
        QCOMPARE(region.areaMm2, 12.0);
        QCOMPARE(region.vertices, std::size_t(7));
        // One without a direction has none.
        const MarkedRegion folded = shownRegion({.middleLps = truth}, geometry);
        QCOMPARE(folded.normalLps, glm::dvec3(0.0));
    }
};

BURIN_TEST(ShownSurfaceTest)

} // namespace shownSurfaceTest

#include "ShownSurfaceTest.moc"
