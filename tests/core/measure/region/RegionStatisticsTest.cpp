// SPDX-License-Identifier: Apache-2.0
#include "core/measure/region/RegionStatistics.h"

#include "core/measure/MeasuredSize.h"
#include "core/measure/region/RegionVoxels.h"
#include "core/volume/UnevenSlices.h"
#include "tests/support/cases/MeasurePhantoms.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

namespace regionStatisticsTest {

using namespace core;
using Kind = Measurement::Kind;

namespace {

int codeAt(int x, int y, int z)
{
    return 1000 + 3 * x + 5 * y + 7 * z;
}

/// A ramp along all axes, in a unit of its own.
std::vector<std::uint16_t> rampOf(Volume& volume)
{
    volume.encoding.rescaleSlope = 2.0;
    volume.encoding.rescaleIntercept = -1024.0;
    std::vector<std::uint16_t> codes;
    const glm::ivec3 size = volume.geometry.size;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x)
                codes.push_back(std::uint16_t(codeAt(x, y, z)));
        }
    }
    return codes;
}

/// From a list of values, one after the other.
struct Plain {
    std::vector<double> values;

    [[nodiscard]] double mean() const
    {
        double sum = 0.0;
        for (const double value : values)
            sum += value;
        return sum / double(values.size());
    }
    [[nodiscard]] double deviation() const
    {
        double squares = 0.0;
        for (const double value : values)
            squares += (value - mean()) * (value - mean());
        return std::sqrt(squares / double(values.size()));
    }
};

bool agree(const std::optional<RegionStatistics>& found, const Plain& plain)
{
    if (!found || found->voxels != std::int64_t(plain.values.size())) {
        qWarning(
            "%d voxels instead of %d", found ? int(found->voxels) : -1, int(plain.values.size()));
        return false;
    }
    const auto near = [](double a, double b) { return std::abs(a - b) < 1e-6; };
    return near(found->mean, plain.mean()) && near(found->deviation, plain.deviation())
        && near(found->minimum, *std::min_element(plain.values.begin(), plain.values.end()))
        && near(found->maximum, *std::max_element(plain.values.begin(), plain.values.end()));
}

} // namespace

class RegionStatisticsTest : public QObject {
    Q_OBJECT

private:
    static void everyPhantom()
    {
        QTest::addColumn<int>("index");
        const std::vector<test::MeasurePhantom> phantoms = test::measurePhantoms();
        for (std::size_t i = 0; i < phantoms.size(); ++i)
            QTest::newRow(phantoms[i].name) << int(i);
    }

private Q_SLOTS:
    /// Against the sorted list.
    void percentilesAreValuesOfTheList()
    {
        std::mt19937 random(35);
        VoxelEncoding encoding;
        encoding.rescaleSlope = 2.0;
        encoding.rescaleIntercept = -1024.0;
        QVERIFY(!RegionTally().percentile(50, encoding));
        for (const int count : {1, 2, 3, 49, 50, 51, 100, 777}) {
            std::vector<std::uint16_t> codes;
            for (int i = 0; i < count; ++i)
                codes.push_back(
                    std::uint16_t(std::uniform_int_distribution(0, i % 3 ? 65535 : 40)(random)));
            RegionTally tally;
            tally.add(codes);
            std::sort(codes.begin(), codes.end());
            for (const int percent : {0, 1, 2, 50, 98, 99, 100}) {
                // The first of the list up to which there are so many percent.
                int place = 0;
                while ((place + 1) * 100 < percent * count)
                    ++place;
                const auto found = tally.percentile(percent, encoding);
                QVERIFY(found.has_value());
                QCOMPARE(*found, encoding.value(codes[std::size_t(place)]));
            }
        }
    }
    /// Every voxel of the volume is asked how far its centre lies from the ball's.
    void aBallHoldsTheVoxelsWithinItsRadius_data() { everyPhantom(); }
    void aBallHoldsTheVoxelsWithinItsRadius()
    {
        QFETCH(const int, index);
        test::MeasurePhantom study = test::measurePhantoms()[std::size_t(index)];
        Volume& volume = study.volume;
        const std::vector<std::uint16_t> codes = rampOf(volume);
        const glm::ivec3 size = volume.geometry.size;
        // Inside, across the border of the volume, less than a voxel, and around nothing.
        for (const auto& [centre, radius] :
            {std::pair(glm::dvec3(1.3, -2.1, 3.7), 11.25), std::pair(glm::dvec3(28, 3, -20), 14.0),
                std::pair(glm::dvec3(0.2, 0.1, 0.3), 0.7)}) {
            const Measurement ball{.id = 1,
                .kind = Kind::Ball,
                .pointsLps = {study.shown(centre), study.shown(centre + glm::dvec3(radius, 0, 0))}};
            Plain plain;
            for (int z = 0; z < size.z; ++z) {
                for (int y = 0; y < size.y; ++y) {
                    for (int x = 0; x < size.x; ++x) {
                        const glm::dvec3 at =
                            worldBetweenSlices(volume.geometry, glm::dvec3(x, y, z));
                        if (glm::distance(at, centre) <= radius)
                            plain.values.push_back(2.0 * codeAt(x, y, z) - 1024.0);
                    }
                }
            }
            const auto found = regionStatistics(ball, volume, codes);
            if (plain.values.empty())
                QVERIFY(!found);
            else
                QVERIFY(agree(found, plain));
        }
        const Measurement outside{.id = 1,
            .kind = Kind::Ball,
            .pointsLps = {glm::dvec3(500, 0, 0), glm::dvec3(510, 0, 0)}};
        QVERIFY(!regionStatistics(outside, volume, codes));
    }

    /// In slices across each axis: pixels whose centres lie in an ellipse by its equation.
    void aRegionOfASliceHoldsItsPixels()
    {
        Volume volume;
        volume.geometry.size = {40, 30, 20};
        volume.geometry.indexToWorld =
            glm::dmat4({0.5, 0, 0, 0}, {0, 0.75, 0, 0}, {0, 0, 3, 0}, {-7, 11, 5, 1});
        const std::vector<std::uint16_t> codes = rampOf(volume);
        const glm::dvec3 spacing(0.5, 0.75, 3.0);
        for (int axis = 0; axis < 3; ++axis) {
            const int right = axis == 0 ? 1 : 0;
            const int down = axis == 2 ? 1 : 2;
            glm::dvec3 middle = glm::dvec3(volume.geometry.size) * 0.45;
            middle[axis] = 8.0;
            const glm::dvec3 centre = volume.geometry.toWorld(middle);
            glm::dvec3 a(0.0);
            glm::dvec3 b(0.0);
            a[right] = 5.2;
            b[down] = 7.3;
            Plain ellipse;
            Plain rectangle;
            for (int v = 0; v < volume.geometry.size[down]; ++v) {
                for (int u = 0; u < volume.geometry.size[right]; ++u) {
                    const double x = (u - middle[right]) * spacing[right];
                    const double y = (v - middle[down]) * spacing[down];
                    glm::ivec3 voxel(8);
                    voxel[right] = u;
                    voxel[down] = v;
                    const double value = 2.0 * codeAt(voxel.x, voxel.y, voxel.z) - 1024.0;
                    if (x * x / (5.2 * 5.2) + y * y / (7.3 * 7.3) <= 1.0)
                        ellipse.values.push_back(value);
                    if (x >= 0.0 && x <= 5.2 && y >= 0.0 && y <= 7.3)
                        rectangle.values.push_back(value);
                }
            }
            Measurement measured{
                .id = 1, .kind = Kind::Ellipse, .pointsLps = {centre, centre + a, centre + b}};
            QVERIFY(agree(regionStatistics(measured, volume, codes), ellipse));
            measured.kind = Kind::Rectangle;
            QVERIFY(agree(regionStatistics(measured, volume, codes), rectangle));
            measured.kind = Kind::Outline;
            measured.pointsLps = {centre, centre + a, centre + a + b, centre + b};
            QVERIFY(agree(regionStatistics(measured, volume, codes), rectangle));
            // Between two slices the nearer one counts; beside the volume none does.
            glm::dvec3 off(0.0);
            off[axis] = 0.4 * spacing[axis];
            for (glm::dvec3& point : measured.pointsLps)
                point += off;
            QVERIFY(agree(regionStatistics(measured, volume, codes), rectangle));
            off[axis] = 60.0 * spacing[axis];
            for (glm::dvec3& point : measured.pointsLps)
                point += off;
            QVERIFY(!regionStatistics(measured, volume, codes));
        }
    }

    /// The samples of a plane cover its area evenly, and a ramp has in their middle the mean.
    void anObliquePlaneIsSampled_data() { everyPhantom(); }
    void anObliquePlaneIsSampled()
    {
        QFETCH(const int, index);
        test::MeasurePhantom study = test::measurePhantoms()[std::size_t(index)];
        Volume& volume = study.volume;
        const std::vector<std::uint16_t> codes = rampOf(volume);
        const glm::dvec3 along = glm::normalize(glm::dvec3(2, 1, 1));
        const glm::dvec3 across = glm::normalize(glm::cross(along, glm::dvec3(0, 1, -3)));
        const glm::dvec3 centre(1.0, 2.0, -3.0);
        const Measurement ellipse{.id = 1,
            .kind = Kind::Ellipse,
            .pointsLps = {centre, centre + 18.0 * along, centre + 12.0 * across}};
        const auto found = regionStatistics(ellipse, volume, codes);
        QVERIFY(found);
        const glm::dvec3 spacing = volume.geometry.spacingMm();
        const double step = std::min({spacing.x, spacing.y, spacing.z});
        QVERIFY(std::abs(double(found->voxels) * step * step - M_PI * 18.0 * 12.0)
            < 0.02 * M_PI * 18.0 * 12.0);
        const glm::dvec3 middle = volume.geometry.toIndex(centre);
        const double mean =
            2.0 * (1000.0 + 3.0 * middle.x + 5.0 * middle.y + 7.0 * middle.z) - 1024.0;
        QVERIFY2(std::abs(found->mean - mean) < 2.0, qPrintable(QString::number(found->mean)));
        // Half of a plane that leaves the volume is not there.
        Measurement large = ellipse;
        large.pointsLps = {centre, centre + 4000.0 * along, centre + 4000.0 * across};
        const RegionVoxels region(large, volume.geometry);
        QVERIFY(region.boxes().empty());
        QVERIFY(!region.samples().empty());
        QVERIFY(int(region.samples().size()) < RegionVoxels::mostSamples);
        for (const glm::ivec3& voxel : region.samples())
            QVERIFY(volume.geometry.contains(voxel));
    }

    void aProbeIsTheNearestVoxel()
    {
        test::MeasurePhantom study = test::measurePhantoms()[4];
        const std::vector<std::uint16_t> codes = rampOf(study.volume);
        const VolumeGeometry& geometry = study.volume.geometry;
        const Measurement probe{
            .id = 1, .kind = Kind::Probe, .pointsLps = {geometry.toWorld({10.4, 19.6, 7.1})}};
        const auto found = regionStatistics(probe, study.volume, codes);
        QVERIFY(found && found->voxels == 1);
        QCOMPARE(found->mean, 2.0 * codeAt(10, 20, 7) - 1024.0);
        const Measurement outside{
            .id = 1, .kind = Kind::Probe, .pointsLps = {geometry.toWorld({-1.0, 19.6, 7.1})}};
        QVERIFY(!regionStatistics(outside, study.volume, codes));
        const Measurement length{.id = 1,
            .kind = Kind::Distance,
            .pointsLps = {geometry.toWorld({1, 1, 1}), geometry.toWorld({2, 2, 2})}};
        QVERIFY(!regionStatistics(length, study.volume, codes));
    }

    /// A large ball is read slab by slab, without gap or overlap.
    void boxesAreReadInParts()
    {
        VolumeGeometry geometry;
        geometry.size = {512, 512, 300};
        const Measurement ball{
            .id = 1, .kind = Kind::Ball, .pointsLps = {{250, 250, 150}, {250, 250, 270}}};
        const RegionVoxels region(ball, geometry);
        QVERIFY(region.boxes().size() > 3);
        int z = region.boxes().front().minimum.z;
        QVERIFY(z <= 30);
        for (const VoxelBox& box : region.boxes()) {
            QCOMPARE(box.minimum.z, z);
            const glm::ivec3 extent = box.maximum - box.minimum;
            QVERIFY(extent.x * extent.y * extent.z <= RegionVoxels::mostVoxelsOfBox);
            QVERIFY(box.minimum.x <= 130 && box.maximum.x > 370);
            z = box.maximum.z;
        }
        QVERIFY(z > 270);
        QVERIFY(region.contains({250, 250, 30}) && !region.contains({250, 250, 29}));
    }
};

BURIN_TEST(RegionStatisticsTest)

} // namespace regionStatisticsTest

#include "RegionStatisticsTest.moc"
