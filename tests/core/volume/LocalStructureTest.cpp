// SPDX-License-Identifier: Apache-2.0
#include "core/volume/LocalStructure.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <cmath>
#include <functional>
#include <vector>

namespace localStructureTest {

namespace {

constexpr int side = 41;

/// Uneven and sheared, as a tilted series has it.
core::VolumeGeometry geometry()
{
    core::VolumeGeometry made;
    made.size = glm::ivec3(side);
    made.indexToWorld = glm::dmat4(1.0);
    made.indexToWorld[0] = {0.7, 0.0, 0.0, 0.0};
    made.indexToWorld[1] = {0.0, 0.7, 0.0, 0.0};
    made.indexToWorld[2] = {0.0, 0.3, 1.2, 0.0};
    made.indexToWorld[3] = {-10.0, 5.0, 30.0, 1.0};
    return made;
}

struct Values {
    core::VoxelBox box;
    std::vector<std::uint16_t> codes;
};

Values valuesOf(const core::VolumeGeometry& geometry, const glm::dvec3& middle, double radiusMm,
    const std::function<double(const glm::dvec3&)>& at)
{
    Values values{.box = core::localStructureBox(geometry, middle, radiusMm), .codes = {}};
    for (int z = values.box.minimum.z; z < values.box.maximum.z; ++z)
        for (int y = values.box.minimum.y; y < values.box.maximum.y; ++y)
            for (int x = values.box.minimum.x; x < values.box.maximum.x; ++x)
                values.codes.push_back(
                    std::uint16_t(std::lround(at(geometry.toWorld(glm::dvec3(x, y, z))))));
    return values;
}

double degreesBetween(const glm::dvec3& a, const glm::dvec3& b)
{
    return glm::degrees(std::acos(std::min(std::abs(glm::dot(a, b)), 1.0)));
}

/// 1 inside, 0 outside, over a millimetre and a half.
double soft(double insideMm)
{
    return 1.0 / (1.0 + std::exp(-insideMm / 0.4));
}

} // namespace

class LocalStructureTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aVesselRunsAlongItself()
    {
        const core::VolumeGeometry volume = geometry();
        const glm::dvec3 middle = volume.toWorld(glm::dvec3(20.0));
        for (const glm::dvec3& towards : {glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(1.0, 2.0, 2.0),
                 glm::dvec3(-3.0, 0.5, 1.0), glm::dvec3(1.0, 0.0, 0.0)}) {
            const glm::dvec3 along = glm::normalize(towards);
            const Values values = valuesOf(volume, middle, 8.0, [&](const glm::dvec3& lps) {
                const glm::dvec3 way = lps - middle;
                const double apart = glm::length(way - glm::dot(way, along) * along);
                return 1000.0 + 800.0 * soft(3.0 - apart);
            });
            // Beside its middle as well: nobody hits that.
            const glm::dvec3 aside =
                glm::normalize(glm::cross(along, glm::dvec3(0.3, 1.0, 0.2))) * 1.0;
            for (const glm::dvec3& place : {middle, middle + aside}) {
                const auto structure =
                    core::localStructure(values.codes, values.box, volume, place, 7.0);
                QVERIFY(structure);
                QVERIFY(structure->isTube());
                QVERIFY2(degreesBetween(structure->directions[2], along) < 3.0,
                    qPrintable(QString::number(degreesBetween(structure->directions[2], along))));
            }
        }
    }

    void aSurfaceLiesAcrossItsNormal()
    {
        const core::VolumeGeometry volume = geometry();
        const glm::dvec3 middle = volume.toWorld(glm::dvec3(20.0));
        const glm::dvec3 normal = glm::normalize(glm::dvec3(1.0, -2.0, 0.5));
        const Values values = valuesOf(volume, middle, 8.0, [&](const glm::dvec3& lps) {
            return 500.0 + 900.0 * soft(-glm::dot(lps - middle, normal));
        });
        const auto structure = core::localStructure(values.codes, values.box, volume, middle, 7.0);
        QVERIFY(structure);
        QVERIFY(!structure->isTube());
        QVERIFY(degreesBetween(structure->directions[0], normal) < 1.5);
        QVERIFY(structure->changes[0] > 20.0 * structure->changes[1]);
    }

    void nothingRunsWhereNothingChanges()
    {
        const core::VolumeGeometry volume = geometry();
        const glm::dvec3 middle = volume.toWorld(glm::dvec3(20.0));
        const Values even = valuesOf(volume, middle, 8.0, [](const glm::dvec3&) { return 300.0; });
        QVERIFY(!core::localStructure(even.codes, even.box, volume, middle, 7.0));
        QVERIFY(!core::localStructure({}, {}, volume, middle, 7.0));
    }

    void theBoxEndsAtTheVolume()
    {
        const core::VolumeGeometry volume = geometry();
        const core::VoxelBox corner =
            core::localStructureBox(volume, volume.toWorld(glm::dvec3(1.0)), 6.0);
        QCOMPARE(corner.minimum, glm::ivec3(0));
        QVERIFY(corner.maximum.x < side && corner.maximum.z < side);
        QVERIFY(core::localStructureBox(volume, glm::dvec3(1e4), 6.0).empty());
        QVERIFY(core::localStructureBox(volume, glm::dvec3(-1e4), 6.0).empty());
    }
};

BURIN_TEST(LocalStructureTest)

} // namespace localStructureTest

#include "LocalStructureTest.moc"
