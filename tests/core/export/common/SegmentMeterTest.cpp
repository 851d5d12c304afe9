// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/SegmentMeter.h"

#include "core/brick/LabelBox.h"
#include "core/export/common/StatisticsText.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QByteArray>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace segmentMeterTest {

using namespace core;

namespace {

/// 20 × 18 × 16 voxels of 0.5 × 0.75 × 2 mm. Segment 1 is a ball that 2 has bitten into.
struct Scene {
    VolumeGeometry geometry;
    VoxelEncoding encoding;
    std::vector<std::uint8_t> labels;
    std::vector<std::uint16_t> codes;

    Scene()
    {
        geometry.size = {20, 18, 16};
        geometry.indexToWorld[0][0] = 0.5;
        geometry.indexToWorld[1][1] = 0.75;
        geometry.indexToWorld[2][2] = 2.0;
        geometry.indexToWorld[3] = {-40.0, 25.0, 10.0, 1.0};
        encoding.rescaleSlope = 0.25;
        encoding.rescaleIntercept = -100.0;
        for (int z = 0; z < geometry.size.z; ++z) {
            for (int y = 0; y < geometry.size.y; ++y) {
                for (int x = 0; x < geometry.size.x; ++x) {
                    const glm::dvec3 from(x - 9.0, y - 8.0, z - 7.0);
                    const bool isBall = glm::length(from) < 5.5;
                    const bool isBite = glm::length(from - glm::dvec3(4.0, 2.0, 3.0)) < 3.0;
                    labels.push_back(isBite ? 2 : isBall ? 1 : 0);
                    codes.push_back(std::uint16_t((x * 37 + y * 101 + z * 1009) % 4001));
                }
            }
        }
    }
    [[nodiscard]] std::vector<std::uint16_t> codesOf(const VoxelBox& box) const
    {
        std::vector<std::uint16_t> portion;
        for (int z = box.minimum.z; z < box.maximum.z; ++z) {
            for (int y = box.minimum.y; y < box.maximum.y; ++y) {
                for (int x = box.minimum.x; x < box.maximum.x; ++x)
                    portion.push_back(
                        codes[std::size_t((z * geometry.size.y + y) * geometry.size.x + x)]);
            }
        }
        return portion;
    }
    [[nodiscard]] SegmentMeter meterOf(int label) const
    {
        Segment segment;
        segment.label = std::uint8_t(label);
        segment.name = QStringLiteral("One");
        return {geometry, encoding, segment, labels};
    }
};

/// All numbers, to the bit.
QByteArray textOf(const SegmentStatistics& statistics)
{
    Volume volume;
    volume.unit = QStringLiteral("HU");
    return statisticsCsv({statistics}, volume);
}

} // namespace

/// One segment is measured from portions of its values.
class SegmentMeterTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// In whatever boxes the values come, nothing differs from the whole volume at once.
    void portionsAreAsTheWhole()
    {
        const Scene scene;
        for (const int label : {1, 2}) {
            SegmentMeter whole = scene.meterOf(label);
            whole.count({.maximum = scene.geometry.size}, scene.codes);
            const QByteArray expected = textOf(whole.statistics());

            const VoxelBox box = boxOfLabel(scene.labels, scene.geometry.size, std::uint8_t(label));
            QVERIFY(!box.empty());
            SegmentMeter slices = scene.meterOf(label);
            for (int z = box.minimum.z; z < box.maximum.z; z += 3) {
                VoxelBox part = box;
                part.minimum.z = z;
                part.maximum.z = std::min(z + 3, box.maximum.z);
                slices.count(part, scene.codesOf(part));
            }
            QCOMPARE(textOf(slices.statistics()), expected);

            // The other way round, and in other boxes.
            SegmentMeter blocks = scene.meterOf(label);
            for (int x = box.maximum.x; x > box.minimum.x; x -= 4) {
                VoxelBox part = box;
                part.minimum.x = std::max(x - 4, box.minimum.x);
                part.maximum.x = x;
                blocks.count(part, scene.codesOf(part));
            }
            QCOMPARE(textOf(blocks.statistics()), expected);
        }
    }

    /// Of a block, by hand: voxels of other labels in the box do not count.
    void aBlockByHand()
    {
        Scene scene;
        std::fill(scene.labels.begin(), scene.labels.end(), std::uint8_t(0));
        const auto at = [&scene](int x, int y, int z) {
            return std::size_t((z * scene.geometry.size.y + y) * scene.geometry.size.x + x);
        };
        // Columns 3, 4 and 6 of a row; 5 is another segment's.
        for (const int x : {3, 4, 6})
            scene.labels[at(x, 2, 1)] = 1;
        scene.labels[at(5, 2, 1)] = 2;
        for (const int x : {3, 4, 5, 6})
            scene.codes[at(x, 2, 1)] = std::uint16_t(400 + 4 * x);
        SegmentMeter meter = scene.meterOf(1);
        const VoxelBox box = boxOfLabel(scene.labels, scene.geometry.size, 1);
        QCOMPARE(box.minimum, glm::ivec3(3, 2, 1));
        QCOMPARE(box.maximum, glm::ivec3(7, 3, 2));
        meter.count(box, scene.codesOf(box));
        const SegmentStatistics found = meter.statistics();
        QCOMPARE(found.voxels, std::int64_t(3));
        QCOMPARE(found.millilitres, 3 * 0.5 * 0.75 * 2.0 / 1000.0);
        // 0.25 · (400 + 4 x) − 100 is x.
        QCOMPARE(found.minimum, 3.0);
        QCOMPARE(found.maximum, 6.0);
        QCOMPARE(found.mean, 13.0 / 3.0);
        QCOMPARE(found.median, 4.0);
        QVERIFY(std::abs(found.deviation - std::sqrt(14.0 / 9.0)) < 1e-12);
        QCOMPARE(found.first, glm::ivec3(3, 2, 1));
        QCOMPARE(found.last, glm::ivec3(6, 2, 1));
        QVERIFY(std::abs(found.centroidLps.x - (-40.0 + 0.5 * 13.0 / 3.0)) < 1e-12);
        QVERIFY(found.surfaceMm2 > 0.0 && found.longestMm > 1.0);
        QVERIFY(!found.sinceImport);
    }
};

BURIN_TEST(SegmentMeterTest)

} // namespace segmentMeterTest

#include "SegmentMeterTest.moc"
