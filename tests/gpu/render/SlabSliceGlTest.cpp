// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/fixtures/frames/VoxelNoise.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace slabSliceGlTest {

using namespace gpu;

namespace {

const glm::ivec2 size(151, 149);
const glm::ivec3 voxels(40, 30, 24);
constexpr double edge = 1e-3; // voxels: nearer to a border either side is right

/// Across k, through the middle of slice 12.
SliceScene axial(const core::VolumeGeometry& geometry)
{
    SliceScene scene;
    scene.centreLps = {0.1, 0.2, geometry.toWorld({0.0, 0.0, 12.0}).z};
    scene.mmPerPixel = 0.31;
    scene.window = {2000.0, 4001.0};
    return scene;
}

SliceScene oblique()
{
    SliceScene scene;
    scene.centreLps = {1.3, -0.7, 2.1};
    scene.rightLps = glm::normalize(glm::dvec3(1.0, 0.4, 0.2));
    scene.downLps = glm::normalize(glm::cross(scene.rightLps, glm::dvec3(0.3, -1.0, 0.2)));
    scene.mmPerPixel = 0.31;
    scene.window = {2000.0, 4001.0};
    return scene;
}

glm::dvec3 lpsOf(const SliceScene& scene, double x, double y)
{
    return scene.centreLps + scene.rightLps * ((x - size.x / 2.0) * scene.mmPerPixel)
        + scene.downLps * ((y - size.y / 2.0) * scene.mmPerPixel);
}

using Counts = std::function<bool(const glm::dvec3& lps)>;

/// The slab's value through a place, sample by sample; none where no sample counts.
std::optional<double> slabOf(const test::VoxelNoise& noise, const SliceScene& scene,
    const glm::dvec3& lps, const Counts& counts)
{
    const glm::dvec3 normal = glm::cross(scene.rightLps, scene.downLps);
    const Interpolation sampled = scene.interpolation == Interpolation::Nearest
        ? Interpolation::Nearest
        : Interpolation::Linear;
    std::vector<double> values;
    for (int k = -scene.slab.reach; k <= scene.slab.reach; ++k) {
        const glm::dvec3 at = lps + normal * (scene.slab.offsetMm + k * scene.slab.stepMm);
        if (noise.depthOf(at) >= 0.0 && counts(at))
            values.push_back(noise.at(at, sampled));
    }
    if (values.empty())
        return std::nullopt;
    std::sort(values.begin(), values.end());
    if (scene.slab.mode == SlabMode::Maximum)
        return values.back();
    if (scene.slab.mode == SlabMode::Minimum)
        return values.front();
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return sum / double(values.size());
}

/// Whether a sample lies so near to a border that rounding decides on which side: the volume's, or
/// one between voxels where those are seen.
bool isDoubtful(const test::VoxelNoise& noise, const SliceScene& scene, const glm::dvec3& lps)
{
    const glm::dvec3 normal = glm::cross(scene.rightLps, scene.downLps);
    bool doubtful = std::abs(noise.depthOf(lps)) < edge;
    for (int k = -scene.slab.reach; k <= scene.slab.reach; ++k) {
        const glm::dvec3 at = lps + normal * (scene.slab.offsetMm + k * scene.slab.stepMm);
        doubtful = doubtful || std::abs(noise.depthOf(at)) < edge
            || (scene.interpolation == Interpolation::Nearest && noise.depthOf(at) >= 0.0
                && noise.besideBorder(at) < edge);
    }
    return doubtful;
}

} // namespace

/// Slices whose grey values are those of a slab.
class SlabSliceGlTest : public test::FrameTest {
    Q_OBJECT

private Q_SLOTS:
    void valuesAreThoseOfTheSamples_data()
    {
        QTest::addColumn<bool>("isOblique");
        QTest::addColumn<SlabMode>("mode");
        QTest::addColumn<int>("reach");
        QTest::addColumn<double>("stepMm");
        QTest::addColumn<double>("offsetMm");
        QTest::addColumn<Interpolation>("interpolation");
        const auto row = [](const char* name, bool isOblique, const SceneSlab& slab,
                             Interpolation interpolation = Interpolation::Linear) {
            QTest::newRow(name) << isOblique << slab.mode << slab.reach << slab.stepMm
                                << slab.offsetMm << interpolation;
        };
        row("axial MIP", false, {SlabMode::Maximum, 2, 2.0, 0.0});
        row("axial MinIP", false, {SlabMode::Minimum, 2, 2.0, 0.0});
        row("axial mean", false, {SlabMode::Mean, 3, 2.0, 0.0});
        row("beside the slice", false, {SlabMode::Maximum, 1, 2.0, 2.0});
        row("beyond the volume", false, {SlabMode::Mean, 15, 2.0, 0.0});
        row("oblique MIP", true, {SlabMode::Maximum, 4, 0.7, 0.0});
        row("oblique MinIP", true, {SlabMode::Minimum, 4, 0.7, 0.2});
        row("oblique mean", true, {SlabMode::Mean, 6, 0.7, 0.0});
        row("one sample", true, {SlabMode::Mean, 0, 0.7, 0.0});
        row("axial mean of voxels", false, {SlabMode::Mean, 3, 2.0, 0.0}, Interpolation::Nearest);
        row("oblique MIP of voxels", true, {SlabMode::Maximum, 4, 0.7, 0.0},
            Interpolation::Nearest);
        row("oblique MinIP of voxels", true, {SlabMode::Minimum, 4, 0.7, 0.2},
            Interpolation::Nearest);
        row("oblique mean of voxels", true, {SlabMode::Mean, 6, 0.7, 0.0}, Interpolation::Nearest);
        row("oblique MIP, cubic", true, {SlabMode::Maximum, 4, 0.7, 0.0}, Interpolation::Cubic);
    }
    void valuesAreThoseOfTheSamples()
    {
        QFETCH(bool, isOblique);
        QFETCH(SlabMode, mode);
        QFETCH(int, reach);
        QFETCH(double, stepMm);
        QFETCH(double, offsetMm);
        QFETCH(Interpolation, interpolation);
        const test::VoxelNoise noise(isOblique ? test::tiltedGeometry(voxels)
                                               : test::centredGeometry(voxels, {0.7, 1.1, 2.0}));
        m_fixture->open(noise.geometry(), noise.codes());
        SliceScene scene = isOblique ? oblique() : axial(noise.geometry());
        scene.slab = {mode, reach, stepMm, offsetMm};
        scene.interpolation = interpolation;
        const Frame frame = m_fixture->draw(scene, size);
        double worst = 0.0;
        int inside = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec3 lps = lpsOf(scene, x + 0.5, y + 0.5);
                if (isDoubtful(noise, scene, lps))
                    continue;
                if (noise.depthOf(lps) < 0.0) {
                    QCOMPARE(test::pixel(frame, x, y), glm::ivec3(0));
                    continue;
                }
                const auto value =
                    slabOf(noise, scene, lps, [](const glm::dvec3&) { return true; });
                if (!value)
                    continue;
                ++inside;
                worst = std::max(worst,
                    std::abs(test::pixel(frame, x, y).g - test::greyOf(*value, scene.window)));
            }
        }
        qInfo("%d pixels: off by %.3f of 255", inside, worst);
        QVERIFY(inside > 4000);
        QVERIFY(worst < 0.65); // as CubicSliceGlTest
    }

    /// Without interpolation each sample is a voxel, so a slab of slices is an exact one.
    void nearestVoxelsStayVoxels()
    {
        const test::VoxelNoise noise(test::centredGeometry(voxels, {0.7, 1.1, 2.0}));
        m_fixture->open(noise.geometry(), noise.codes());
        SliceScene scene = axial(noise.geometry());
        scene.interpolation = Interpolation::Nearest;
        scene.slab = {SlabMode::Maximum, 3, 2.0, 0.0};
        const Frame frame = m_fixture->draw(scene, size);
        int compared = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec3 lps = lpsOf(scene, x + 0.5, y + 0.5);
                const glm::dvec3 index = noise.geometry().toIndex(lps);
                const glm::dvec3 beside = glm::abs(index + 0.5 - glm::round(index + 0.5));
                if (noise.depthOf(lps) < edge || std::min(beside.x, beside.y) < edge)
                    continue;
                const glm::ivec3 voxel(glm::round(index));
                double greatest = 0.0;
                for (int k = 9; k <= 15; ++k)
                    greatest = std::max(greatest, noise.codeAt({voxel.x, voxel.y, k}));
                ++compared;
                QVERIFY(std::abs(test::pixel(frame, x, y).g - test::greyOf(greatest, scene.window))
                    < 0.65);
            }
        }
        QVERIFY(compared > 4000);
    }

    /// Where carving is a hole, what is carved away hides nothing; else it counts as ever.
    void carvedVoxelsDoNotCountInAHole()
    {
        const test::VoxelNoise noise(test::centredGeometry(voxels, {0.7, 1.1, 2.0}));
        m_fixture->open(noise.geometry(), noise.codes());
        SliceScene scene = axial(noise.geometry());
        scene.showCarved = false;
        scene.slab = {SlabMode::Maximum, 1, 2.0, 0.0};
        // So that the shader is the same one before and after.
        m_fixture->fill(VolumeField::Radiation, {{0, 0, 0}, {1, 1, 1}}, 255);
        const Frame before = m_fixture->draw(scene, size);
        // Slices 11 and 12 of the left half, and all three of the slab in a corner.
        m_fixture->fill(VolumeField::Radiation, {{0, 0, 11}, {20, 30, 13}}, 255);
        m_fixture->fill(VolumeField::Radiation, {{0, 0, 13}, {8, 8, 14}}, 255);
        QVERIFY(*m_fixture->draw(scene, size).rgba == *before.rgba);
        scene.carvedAsHole = true;
        const Frame hole = m_fixture->draw(scene, size);
        double worst = 0.0;
        int black = 0;
        int alone = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec3 lps = lpsOf(scene, x + 0.5, y + 0.5);
                const glm::dvec3 index = noise.geometry().toIndex(lps);
                // The coverage is interpolated, so its borders are left out.
                const bool atBorder = std::abs(index.x - 19.5) < 1.0
                    || (index.x < 9.0 && std::abs(index.y - 7.5) < 1.0)
                    || (index.y < 9.0 && std::abs(index.x - 7.5) < 1.0);
                if (noise.depthOf(lps) < edge || atBorder)
                    continue;
                const bool corner = index.x < 7.5 && index.y < 7.5;
                const auto value = slabOf(noise, scene, lps, [&](const glm::dvec3& at) {
                    const double k = noise.geometry().toIndex(at).z;
                    return !(index.x < 19.5 && k < 12.5) && !(corner && k > 12.5);
                });
                black += value ? 0 : 1;
                alone += value && index.x < 19.5 ? 1 : 0;
                const double grey = value ? test::greyOf(*value, scene.window) : 0.0;
                worst = std::max(worst, std::abs(test::pixel(hole, x, y).g - grey));
            }
        }
        QVERIFY(black > 100);
        QVERIFY(alone > 1000);
        QVERIFY2(worst < 0.65, qPrintable(QString::number(worst)));
        // Nothing is left there, in an inverted picture, too.
        scene.inverted = true;
        const glm::dvec3 corner = noise.geometry().toWorld({3.0, 3.0, 12.0}) - scene.centreLps;
        const glm::ivec2 there(glm::dvec2(corner) / scene.mmPerPixel + glm::dvec2(size) / 2.0);
        QCOMPARE(test::pixel(m_fixture->draw(scene, size), there.x, there.y), glm::ivec3(0));
    }

    /// A picture on the screen follows what is carved beside its slice, where it shows that.
    void carvingBesideTheSliceIsFollowed()
    {
        const test::VoxelNoise noise(test::centredGeometry(voxels, {0.7, 1.1, 2.0}));
        m_fixture->open(noise.geometry(), noise.codes());
        const auto framesAfterCarving = [&](const SliceScene& scene, int slice) {
            m_fixture->scheduler.request(
                {.view = 1, .sizePixels = size, .scene = scene, .segments = {}});
            (void)m_fixture->settle();
            m_fixture->fill(VolumeField::Radiation, {{5, 5, slice}, {9, 9, slice + 1}}, 255);
            return m_fixture->settle().size();
        };
        SliceScene scene = axial(noise.geometry());
        scene.carvedAsHole = true;
        QCOMPARE(framesAfterCarving(scene, 15), std::size_t(0));
        scene.slab = {SlabMode::Maximum, 3, 2.0, 0.0};
        QVERIFY(framesAfterCarving(scene, 9) > 0);
        QVERIFY(framesAfterCarving(scene, 14) > 0);
        QCOMPARE(framesAfterCarving(scene, 20), std::size_t(0));
        scene.carvedAsHole = false;
        QCOMPARE(framesAfterCarving(scene, 10), std::size_t(0));
    }

    /// Segments are those of the slice, which is what a brush changes.
    void segmentsAreThoseOfTheMiddle()
    {
        const test::VoxelNoise noise(test::centredGeometry(voxels, {0.7, 1.1, 2.0}));
        m_fixture->open(noise.geometry(), noise.codes());
        SliceScene scene = axial(noise.geometry());
        scene.slab = {SlabMode::Mean, 3, 2.0, 0.0};
        SegmentDisplay segments;
        segments.rgb[3] = 0x64C832;
        segments.visible[3] = true;
        // So that the shader is the same one before and after.
        m_fixture->fill(VolumeField::Labels, {{0, 0, 0}, {1, 1, 1}}, 3);
        const Frame before = m_fixture->draw(scene, size, segments);
        m_fixture->fill(VolumeField::Labels, {{5, 5, 14}, {15, 15, 15}}, 3);
        QVERIFY(*m_fixture->draw(scene, size, segments).rgba == *before.rgba);
        m_fixture->fill(VolumeField::Labels, {{5, 5, 12}, {15, 15, 13}}, 3);
        QVERIFY(*m_fixture->draw(scene, size, segments).rgba != *before.rgba);
    }
};

BURIN_TEST(SlabSliceGlTest)

} // namespace slabSliceGlTest

#include "SlabSliceGlTest.moc"
