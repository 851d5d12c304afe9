// SPDX-License-Identifier: Apache-2.0
#include "core/masks/SegPlanes.h"
#include "core/masks/SegLattice.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <utility>

namespace segPlanesTest {

namespace {

using test::randomInt;
using test::randomUnit;

struct Axes {
    glm::dvec3 row;
    glm::dvec3 column;
    glm::dvec3 normal;
};

/// Of the patient, turned over and about, or any.
Axes randomAxes(test::Random& random)
{
    std::array<glm::dvec3, 3> axes{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
    if (randomInt(random, 0, 2) == 0) {
        const auto any = [&] {
            return glm::dvec3(
                randomUnit(random) - 0.5, randomUnit(random) - 0.5, randomUnit(random) - 0.5);
        };
        axes[0] = glm::normalize(any());
        axes[1] = glm::normalize(glm::cross(any(), axes[0]));
    } else {
        for (std::size_t i = 0; i < 3; ++i)
            std::swap(axes[i], axes[std::size_t(randomInt(random, int(i), 2))]);
        for (glm::dvec3& axis : axes)
            axis *= randomInt(random, 0, 1) == 0 ? 1.0 : -1.0;
    }
    return {axes[0], axes[1], glm::cross(axes[0], axes[1])};
}

double randomSpacing(test::Random& random)
{
    return randomInt(random, 0, 1) == 0 ? 1.0 : 0.4 + 2.0 * randomUnit(random);
}

/// Few pixels in few frames, of which some lie in the same place.
core::SegFile randomSeg(test::Random& random, const Axes& axes)
{
    core::SegFile seg;
    seg.columns = randomInt(random, 1, 21);
    seg.rows = randomInt(random, 1, 21);
    if (randomInt(random, 0, 1) == 0) {
        seg.type = core::SegFile::Type::Fractional;
        seg.bitsPerPixel = 8;
        seg.fullPixel = 200;
    }
    const double rowSpacing = randomSpacing(random);
    const double columnSpacing = randomSpacing(random);
    const double apart = randomSpacing(random);
    const int frames = randomInt(random, 1, 8);
    for (int i = 0; i < frames; ++i) {
        const int height = randomInt(random, 0, 9);
        seg.frames.push_back({.segment = randomInt(random, 0, 4) == 0 ? 2 : 1,
            .plane = {.position = double(height) * apart * axes.normal,
                .rowDirection = axes.row,
                .columnDirection = axes.column,
                .rowSpacing = rowSpacing,
                .columnSpacing = columnSpacing}});
    }
    const std::size_t pixels = seg.frames.size() * std::size_t(seg.columns) * std::size_t(seg.rows);
    seg.bits.resize((pixels * std::size_t(seg.bitsPerPixel) + 7) / 8);
    const int oneIn = randomInt(random, 1, 60);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        if (randomInt(random, 1, oneIn) != 1)
            continue;
        if (seg.bitsPerPixel == 8)
            seg.bits[pixel] = std::uint8_t(randomInt(random, 0, 200));
        else
            seg.bits[pixel / 8] = std::uint8_t(seg.bits[pixel / 8] | 1U << (pixel % 8));
    }
    return seg;
}

core::VolumeGeometry randomGeometry(test::Random& random, const Axes& axes)
{
    core::VolumeGeometry geometry;
    geometry.size = {randomInt(random, 1, 24), randomInt(random, 1, 24), randomInt(random, 1, 12)};
    const double shift = randomInt(random, 0, 1) == 0 ? 1.0 : randomUnit(random);
    const glm::dvec3 origin = shift
        * (double(randomInt(random, -4, 4)) * axes.row
            + double(randomInt(random, -4, 4)) * axes.column
            + double(randomInt(random, -3, 3)) * axes.normal);
    geometry.indexToWorld = glm::dmat4(glm::dvec4(randomSpacing(random) * axes.row, 0.0),
        glm::dvec4(randomSpacing(random) * axes.column, 0.0),
        glm::dvec4(randomSpacing(random) * axes.normal, 0.0), glm::dvec4(origin, 1.0));
    return geometry;
}

} // namespace

/// Frames of a segment on the grid of a volume.
class SegPlanesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// What is passed over holds nothing: the same as where every voxel is looked at.
    void nothingIsPassedOver()
    {
        const int count = test::longRun() ? 40'000 : 2'000;
        std::size_t voxels = 0;
        std::size_t held = 0;
        std::size_t visited = 0;
        for (int number = 0; number < count; ++number) {
            auto random = test::Random(unsigned(number));
            const Axes axes = randomAxes(random);
            const core::SegFile seg = randomSeg(random, axes);
            core::Volume volume;
            volume.geometry =
                randomGeometry(random, randomInt(random, 0, 3) == 0 ? randomAxes(random) : axes);
            const core::VolumeGeometry& geometry = volume.geometry;
            const auto placed = core::placedFrames(seg, volume, {});
            QVERIFY2(placed, qPrintable(QString::number(number)));
            const core::SegmentPlanes planes(seg, 1, placed->toLattice);

            std::vector<std::uint8_t> looks(geometry.voxelCount(), 0);
            std::vector<std::uint8_t> found(geometry.voxelCount(), 0);
            std::vector<std::uint8_t> likely(geometry.voxelCount(), 0);
            core::forEachVoxelIn(planes, placed->map, geometry.size,
                [&](int, std::uint64_t voxel, const core::PlaneFrames& plane,
                    const core::LatticeMap::Place& place) {
                    ++looks[voxel];
                    found[voxel] = planes.holds(plane, place) ? 1 : 0;
                    likely[voxel] = planes.probability(plane, place);
                });
            std::size_t voxel = 0;
            for (int k = 0; k < geometry.size.z; ++k) {
                for (int j = 0; j < geometry.size.y; ++j) {
                    core::LatticeMap::Place place = placed->map.rowStart(j, k);
                    for (int i = 0; i < geometry.size.x; ++i, ++voxel) {
                        const core::PlaneFrames* plane = planes.at(place[2]);
                        const bool wanted = plane && planes.holds(*plane, place);
                        const int probability = plane ? planes.probability(*plane, place) : 0;
                        if (looks[voxel] > 1 || wanted != (found[voxel] != 0)
                            || probability != likely[voxel])
                            QFAIL(qPrintable(QStringLiteral("case %1, voxel %2 %3 %4")
                                                 .arg(number)
                                                 .arg(i)
                                                 .arg(j)
                                                 .arg(k)));
                        held += wanted ? 1 : 0;
                        visited += looks[voxel];
                        for (std::size_t axis = 0; axis < 3; ++axis)
                            place[axis] += placed->map.step()[axis];
                    }
                }
            }
            voxels += voxel;
        }
        qInfo("%zu of %zu voxels held, %zu looked at", held, voxels, visited);
        QVERIFY(held > 5U * std::size_t(count));
        QVERIFY(held < visited && visited < voxels / 4);
    }
};

BURIN_TEST(SegPlanesTest)

} // namespace segPlanesTest

#include "SegPlanesTest.moc"
