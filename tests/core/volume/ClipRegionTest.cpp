// SPDX-License-Identifier: Apache-2.0
#include "core/volume/ClipRegion.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <cmath>
#include <random>

namespace clipRegionTest {

using core::ClipRegion;
using core::VolumeGeometry;

namespace {

VolumeGeometry sheared()
{
    VolumeGeometry geometry;
    geometry.size = {40, 30, 20};
    geometry.indexToWorld =
        glm::dmat4(glm::dvec4(0.5, 0.0, 0.0, 0.0), glm::dvec4(0.0, -0.7, 0.0, 0.0),
            glm::dvec4(0.0, 0.3, 1.5, 0.0), glm::dvec4(-10.0, 12.0, 30.0, 1.0));
    return geometry;
}

class Random {
public:
    explicit Random(unsigned seed)
        : m_engine(seed)
    {
    }
    double between(double low, double high)
    {
        return low + (high - low) * double(m_engine()) / 4294967296.0;
    }
    glm::dvec3 index(const glm::ivec3& size)
    {
        return {between(-1.0, size.x), between(-1.0, size.y), between(-1.0, size.z)};
    }
    ClipRegion region(const VolumeGeometry& geometry)
    {
        ClipRegion region = core::wholeVolume(geometry);
        const glm::dvec3 a = index(geometry.size);
        const glm::dvec3 b = index(geometry.size);
        region.box = {glm::min(a, b), glm::max(a, b), between(0.0, 1.0) < 0.7};
        for (core::ClipPlane& plane : region.planes) {
            const glm::dvec3 normal{between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0)};
            plane = {geometry.toWorld(index(geometry.size)), glm::normalize(normal),
                between(0.0, 1.0) < 0.5};
        }
        return region;
    }

private:
    std::mt19937 m_engine;
};

/// Said once more, in the patient's millimetres.
bool isSeen(const ClipRegion& region, const VolumeGeometry& geometry, const glm::dvec3& index)
{
    const glm::dvec3 lps = geometry.toWorld(index);
    for (const core::ClipPlane& plane : region.planes) {
        if (plane.on && glm::dot(lps - plane.pointLps, plane.normalLps) > 0.0)
            return false;
    }
    return !region.box.on
        || (glm::all(glm::greaterThanEqual(index, region.box.minimum))
            && glm::all(glm::lessThanEqual(index, region.box.maximum)));
}

} // namespace

class ClipRegionTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aWholeVolumeHidesNothing()
    {
        const VolumeGeometry geometry = sheared();
        const ClipRegion region = core::wholeVolume(geometry);
        QVERIFY(!region.any());
        QVERIFY(core::halfSpaces(region, geometry).empty());
        QVERIFY(region.box.maximum == glm::dvec3(39.5, 29.5, 19.5));
    }

    /// Along random lines, what the stretch says is what holds of every point.
    void stretchesAreWhatIsSeen()
    {
        const VolumeGeometry geometry = sheared();
        Random random(4);
        int some = 0;
        int none = 0;
        for (int round = 0; round < 400; ++round) {
            const ClipRegion region = random.region(geometry);
            const auto halves = core::halfSpaces(region, geometry);
            const glm::dvec3 from = random.index(geometry.size);
            glm::dvec3 way = random.index(geometry.size) - from;
            if (round % 5 == 0)
                way = {0.0, way.y, 0.0}; // along a face
            const auto stretch = core::stretchInside({-1.0, 2.0}, from, way, halves);
            (stretch ? some : none) += 1;
            for (int step = 0; step <= 300; ++step) {
                const double t = -1.0 + step / 100.0;
                const bool inside = stretch && t >= stretch->from && t <= stretch->to;
                const bool atBorder = stretch
                    && std::min(std::abs(t - stretch->from), std::abs(t - stretch->to)) < 1e-9;
                if (!atBorder)
                    QCOMPARE(inside, isSeen(region, geometry, from + t * way));
            }
        }
        QVERIFY(some > 40 && none > 40);
    }

    void sectionsLieOnPlaneAndBox()
    {
        const VolumeGeometry geometry = sheared();
        Random random(7);
        int met = 0;
        for (int round = 0; round < 200; ++round) {
            const ClipRegion region = random.region(geometry);
            const core::ClipPlane& plane = region.planes[0];
            const auto corners =
                core::boxSection(region.box, geometry, plane.pointLps, plane.normalLps);
            met += corners.empty() ? 0 : 1;
            glm::dvec3 turn(0.0);
            for (std::size_t i = 0; i < corners.size(); ++i) {
                QVERIFY(std::abs(glm::dot(corners[i] - plane.pointLps, plane.normalLps)) < 1e-9);
                const glm::dvec3 index = geometry.toIndex(corners[i]);
                int sides = 0;
                for (int axis = 0; axis < 3; ++axis) {
                    QVERIFY(index[axis] > region.box.minimum[axis] - 1e-9);
                    QVERIFY(index[axis] < region.box.maximum[axis] + 1e-9);
                    sides += std::abs(index[axis] - region.box.minimum[axis]) < 1e-9
                            || std::abs(index[axis] - region.box.maximum[axis]) < 1e-9
                        ? 1
                        : 0;
                }
                QVERIFY(sides >= 2); // on an edge
                // In order: it turns the same way at every corner.
                const glm::dvec3 here = corners[(i + 1) % corners.size()] - corners[i];
                const glm::dvec3 next =
                    corners[(i + 2) % corners.size()] - corners[(i + 1) % corners.size()];
                const glm::dvec3 now = glm::cross(here, next);
                QVERIFY(glm::dot(now, turn) > -1e-9);
                turn = now;
            }
        }
        QVERIFY(met > 40);
    }

    void whereThereIsNoSectionIsNone()
    {
        const VolumeGeometry geometry = sheared();
        const glm::dvec3 above = geometry.toWorld({0.0, 0.0, 25.0});
        QVERIFY(core::boxSection(
            core::wholeVolume(geometry).box, geometry, above, glm::dvec3(0.0, 0.0, 1.0))
                    .empty());
    }
};

BURIN_TEST(ClipRegionTest)

} // namespace clipRegionTest

#include "ClipRegionTest.moc"
