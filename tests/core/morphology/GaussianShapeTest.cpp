// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/GaussianShape.h"

#include "core/morphology/GridGaussian.h"
#include "core/volume/VolumeGeometry.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace gaussianShapeTest {

namespace {

using Labels = std::vector<std::uint8_t>;

core::VolumeGeometry plainGrid(const glm::ivec3& size, const glm::dvec3& spacing)
{
    core::VolumeGeometry geometry;
    geometry.size = size;
    geometry.indexToWorld = glm::dmat4(glm::dmat3(glm::dvec3(spacing.x, 0.0, 0.0),
        glm::dvec3(0.0, spacing.y, 0.0), glm::dvec3(0.0, 0.0, spacing.z)));
    return geometry;
}

std::size_t indexOf(const glm::ivec3& at, const glm::ivec3& size)
{
    return (std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x)
        + std::size_t(at.x);
}

template <class Visit> void forEachVoxel(const glm::ivec3& size, const Visit& visit)
{
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x)
                visit(glm::ivec3(x, y, z));
        }
    }
}

/// Blocks of the segment 1, some at the image's border, with specks, and a block of another one.
Labels anyMatter(const glm::ivec3& size, std::mt19937& random)
{
    Labels labels(std::size_t(size.x * size.y * size.z), 0);
    for (const int label : {1, 1, 1, 2}) {
        const glm::ivec3 one{int(random() & 31), int(random() & 31), int(random() & 31)};
        const glm::ivec3 other{int(random() & 31), int(random() & 31), int(random() & 31)};
        const glm::ivec3 from = glm::min(one % size, other % size);
        const glm::ivec3 to = glm::max(one % size, other % size);
        forEachVoxel(to - from + 1, [&](const glm::ivec3& within) {
            labels[indexOf(from + within, size)] = std::uint8_t(label);
        });
    }
    for (std::uint8_t& label : labels) {
        if (random() % 25 == 0)
            label = label == 1 ? 0 : 1;
    }
    return labels;
}

/// Of the whole volume, voxel by voxel and axis by axis, as GaussianFilter.h words it.
std::vector<std::uint32_t> blurredPlainly(const Labels& labels, const glm::ivec3& size,
    const core::GridGaussian& gaussian, std::uint8_t of = 1)
{
    std::vector<std::uint32_t> values(labels.size());
    std::transform(labels.begin(), labels.end(), values.begin(),
        [of](std::uint8_t label) { return label == of ? 1U : 0U; });
    for (int axis = 0; axis < 3; ++axis) {
        const std::vector<std::uint32_t>& weights = gaussian.weights.at(std::size_t(axis));
        const std::vector<std::uint32_t> before = values;
        const auto far = int(weights.size()) - 1;
        forEachVoxel(size, [&](const glm::ivec3& at) {
            std::uint64_t sum = 0;
            for (int step = -far; step <= far; ++step) {
                glm::ivec3 other = at;
                other[axis] = std::clamp(at[axis] + step, 0, size[axis] - 1);
                sum += std::uint64_t(weights[std::size_t(std::abs(step))])
                    * before[indexOf(other, size)];
            }
            values[indexOf(at, size)] =
                std::uint32_t(axis == 0 ? (sum + 1) / 2 : (sum + 32768) / 65536);
        });
    }
    return values;
}

/// The segment's part of the Gaussian around a voxel, in floating point and much farther.
double realPart(const Labels& labels, const core::VolumeGeometry& geometry, double sigmaMm,
    const glm::ivec3& at)
{
    const glm::ivec3 far(glm::ceil(6.0 * sigmaMm / geometry.spacingMm()));
    double sum = 0.0;
    double own = 0.0;
    forEachVoxel(2 * far + 1, [&](const glm::ivec3& within) {
        const glm::ivec3 step = within - far;
        const double mm = glm::length(glm::dvec3(step) * geometry.spacingMm());
        const double weight = std::exp(-mm * mm / (2.0 * sigmaMm * sigmaMm));
        const glm::ivec3 other = glm::clamp(at + step, glm::ivec3(0), geometry.size - 1);
        sum += weight;
        own += labels[indexOf(other, geometry.size)] == 1 ? weight : 0.0;
    });
    return own / sum;
}

Labels after(const Labels& labels, const core::ShapeChange& change)
{
    Labels now = labels;
    for (const core::VoxelRun& run : change.given.runs())
        std::fill_n(now.begin() + std::ptrdiff_t(run.first), run.count, std::uint8_t(1));
    for (const core::VoxelRun& run : change.taken.runs())
        std::fill_n(now.begin() + std::ptrdiff_t(run.first), run.count, std::uint8_t(0));
    return now;
}

core::Result<core::ShapeChange> smoothed(const core::VolumeGeometry& geometry, const Labels& labels,
    double sigmaMm, const core::Progress& progress = core::Progress())
{
    return core::gaussianChange(
        labels, geometry.size, 1, core::gaussianOf(geometry, sigmaMm), progress);
}

} // namespace

class GaussianShapeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// They are those of the formula, to one unit of 65536, and add up.
    void weights_data()
    {
        QTest::addColumn<double>("spacing");
        QTest::addColumn<double>("sigma");
        QTest::newRow("a voxel") << 1.0 << 1.0;
        QTest::newRow("half a voxel") << 1.0 << 0.5;
        QTest::newRow("fine") << 0.3 << 1.7;
        QTest::newRow("thick") << 5.0 << 1.9;
        QTest::newRow("hundreds") << 0.25 << 90.0;
    }
    void weights()
    {
        QFETCH(const double, spacing);
        QFETCH(const double, sigma);
        const core::GridGaussian gaussian =
            core::gaussianOf(plainGrid({9, 9, 9}, {spacing, 2.0 * spacing, 1e3}), sigma);
        QCOMPARE(gaussian.weights[2], std::vector<std::uint32_t>{core::GridGaussian::whole});
        for (const int axis : {0, 1}) {
            const std::vector<std::uint32_t>& weights = gaussian.weights.at(std::size_t(axis));
            const double step = (axis == 0 ? 1.0 : 2.0) * spacing / sigma;
            QCOMPARE(int(weights.size()) - 1, int(std::floor(3.0 / step + 1e-9)));
            double total = 1.0;
            std::uint32_t sum = weights[0];
            for (std::size_t k = 1; k < weights.size(); ++k) {
                total += 2.0 * std::exp(-0.5 * double(k * k) * step * step);
                sum += 2 * weights[k];
            }
            QCOMPARE(sum, core::GridGaussian::whole);
            for (std::size_t k = 0; k < weights.size(); ++k) {
                const double real = 65536.0 * std::exp(-0.5 * double(k * k) * step * step) / total;
                QVERIFY2(std::abs(double(weights[k]) - real) < 1.5,
                    qPrintable(QStringLiteral("%1: %2, %3").arg(k).arg(weights[k]).arg(real)));
            }
        }
    }

    /// Voxel for voxel what the rule says of the whole volume, though only a box is looked at.
    void anyMatter_data()
    {
        QTest::addColumn<uint>("seed");
        for (uint seed = 1; seed <= 12; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void anyMatter()
    {
        QFETCH(const uint, seed);
        std::mt19937 random(seed);
        std::uint64_t changed = 0;
        for (int round = 0; round < 4; ++round) {
            const glm::ivec3 size{
                8 + int(random() % 14), 8 + int(random() % 12), 5 + int(random() % 12)};
            const glm::dvec3 spacing{0.5 + 0.1 * double(random() % 12),
                0.5 + 0.1 * double(random() % 12), 0.7 + 0.1 * double(random() % 24)};
            const core::VolumeGeometry geometry = plainGrid(size, spacing);
            const Labels labels = gaussianShapeTest::anyMatter(size, random);
            const double sigma = 0.4 + 0.05 * double(random() % 60);
            const auto change = smoothed(geometry, labels, sigma);
            QVERIFY(change);
            const std::vector<std::uint32_t> values =
                blurredPlainly(labels, size, core::gaussianOf(geometry, sigma));
            Labels expected = labels;
            for (std::size_t voxel = 0; voxel < labels.size(); ++voxel) {
                if (labels[voxel] == 0 && values[voxel] > 16384)
                    expected[voxel] = 1;
                else if (labels[voxel] == 1 && values[voxel] < 16384)
                    expected[voxel] = 0;
            }
            QVERIFY(after(labels, *change) == expected);
            changed += change->given.voxelCount() + change->taken.voxelCount();
        }
        QVERIFY2(changed > 40, qPrintable(QString::number(changed)));
    }

    /// Together: the greatest value of those that take part, and of nobody, over the whole volume.
    void together_data()
    {
        QTest::addColumn<uint>("seed");
        for (uint seed = 1; seed <= 12; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void together()
    {
        QFETCH(const uint, seed);
        std::mt19937 random(seed);
        std::uint64_t changed = 0;
        for (int round = 0; round < 3; ++round) {
            const glm::ivec3 size{
                8 + int(random() % 14), 8 + int(random() % 12), 5 + int(random() % 12)};
            const core::VolumeGeometry geometry =
                plainGrid(size, {1.0, 0.8, 0.7 + 0.1 * double(random() % 24)});
            Labels labels = gaussianShapeTest::anyMatter(size, random);
            for (std::uint8_t& label : labels) {
                if (label == 1 && random() % 3 == 0)
                    label = 5;
                else if (random() % 50 == 0)
                    label = 9;
            }
            const double sigma = 0.5 + 0.05 * double(random() % 50);
            const core::GridGaussian gaussian = core::gaussianOf(geometry, sigma);
            const std::vector<std::uint8_t> segments{1, 2, 5}; // 9 takes no part, 2 may be nowhere
            const auto change =
                core::jointGaussianChange(labels, size, segments, gaussian, core::Progress());
            QVERIFY(change && change->given.size() == segments.size());
            Labels now = labels;
            const auto become = [&](const core::VoxelRuns& runs, std::uint8_t label) {
                for (const core::VoxelRun& run : runs.runs())
                    std::fill_n(now.begin() + std::ptrdiff_t(run.first), run.count, label);
                changed += runs.voxelCount();
            };
            for (std::size_t place = 0; place < segments.size(); ++place)
                become(change->given[place], segments[place]);
            become(change->freed, 0);
            std::vector<std::vector<std::uint32_t>> values;
            for (const int label : {0, 1, 2, 5})
                values.push_back(blurredPlainly(labels, size, gaussian, std::uint8_t(label)));
            for (std::size_t voxel = 0; voxel < labels.size(); ++voxel) {
                std::uint8_t expected = labels[voxel];
                std::uint32_t most = 0;
                for (std::size_t place = 0; place < values.size() && labels[voxel] != 9; ++place) {
                    if (values[place][voxel] > most) {
                        most = values[place][voxel];
                        expected = std::uint8_t(place == 0 ? 0 : segments[place - 1]);
                    }
                }
                QCOMPARE(int(now[voxel]), int(expected));
            }
        }
        QVERIFY2(changed > 40, qPrintable(QString::number(changed)));
    }

    /// And what the Gaussian of the books says, but for voxels that are half of either.
    void theRealGaussian()
    {
        std::mt19937 random(5);
        const glm::ivec3 size(18, 16, 12);
        const core::VolumeGeometry geometry = plainGrid(size, {0.8, 1.1, 2.0});
        const Labels labels = gaussianShapeTest::anyMatter(size, random);
        const double sigma = 1.6;
        const auto change = smoothed(geometry, labels, sigma);
        QVERIFY(change);
        const Labels now = after(labels, *change);
        int clear = 0;
        forEachVoxel(size, [&](const glm::ivec3& at) {
            const double part = realPart(labels, geometry, sigma, at);
            // What lies beyond three standard deviations is three thousandths along each axis.
            if (labels[indexOf(at, size)] == 2 || std::abs(part - 0.5) < 0.01)
                return;
            ++clear;
            QCOMPARE(int(now[indexOf(at, size)]), part > 0.5 ? 1 : 0);
        });
        QVERIFY2(clear > 1500, qPrintable(QString::number(clear)));
    }

    /// A slab that the image cuts off keeps its voxels there, and a flat face stays where it is.
    void theBorderOfTheImage()
    {
        const glm::ivec3 size(12, 10, 10);
        const core::VolumeGeometry geometry = plainGrid(size, glm::dvec3(1.0));
        Labels slab(std::size_t(size.x * size.y * size.z), 0);
        forEachVoxel(
            {6, size.y, size.z}, [&](const glm::ivec3& at) { slab[indexOf(at, size)] = 1; });
        const auto change = smoothed(geometry, slab, 3.0);
        QVERIFY(change && change->given.empty() && change->taken.empty());
    }

    void nothingIsNothing()
    {
        const glm::ivec3 size(5, 4, 3);
        const core::VolumeGeometry geometry = plainGrid(size, glm::dvec3(1.0));
        const auto none = smoothed(geometry, Labels(60, 2), 2.0);
        QVERIFY(none && none->given.empty() && none->taken.empty());
        // A single voxel goes, unless the Gaussian does not reach the next one.
        Labels speck(60, 0);
        speck[indexOf({2, 2, 1}, size)] = 1;
        const auto gone = smoothed(geometry, speck, 1.0);
        QVERIFY(gone && gone->taken.voxelCount() == 1);
        const auto still = smoothed(geometry, speck, 0.3);
        QVERIFY(still && still->taken.empty());
    }

    void progressAndCancelling()
    {
        std::mt19937 random(7);
        const core::VolumeGeometry geometry = plainGrid({40, 40, 40}, glm::dvec3(1.0));
        const Labels labels = gaussianShapeTest::anyMatter(geometry.size, random);
        int last = 0;
        bool ordered = true;
        const core::Progress progress([&](core::ProgressStep step, int done, int total) {
            ordered = ordered && step == core::ProgressStep::ReshapingSegment && done > last
                && done <= total;
            last = done == total ? -1 : done;
        });
        QVERIFY(smoothed(geometry, labels, 2.0, progress));
        QVERIFY(ordered);
        QCOMPARE(last, -1);

        core::Progress* mine = nullptr;
        core::Progress stopped([&](core::ProgressStep, int, int) { mine->cancel(); });
        mine = &stopped;
        const auto given = smoothed(geometry, labels, 2.0, stopped);
        QVERIFY(!given);
        QVERIFY(given.error().code == core::ErrorCode::Cancelled);
    }
};

BURIN_TEST(GaussianShapeTest)

} // namespace gaussianShapeTest

#include "GaussianShapeTest.moc"
