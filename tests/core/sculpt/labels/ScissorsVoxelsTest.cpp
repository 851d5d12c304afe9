// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/labels/ScissorsVoxels.h"

#include "core/brick/LabelRuns.h"
#include "core/edits/kinds/filling/SegmentScissors.h"
#include "core/sculpt/labels/LabelScissors.h"
#include "tests/reference/sculpt/LayerWrites.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace scissorsVoxelsTest {

using namespace core;

namespace {

/// A ball of label 1 with a cavity, half a slab of it far behind, and specks of 1 and 2.
std::vector<std::uint8_t> someLabels(const glm::ivec3& size, test::Random& random)
{
    std::vector<std::uint8_t> labels;
    const glm::dvec3 middle = glm::dvec3(size) / 2.0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const double off = glm::length(glm::dvec3(x, y, z) - middle);
                const bool isMatter = (off < 9.0 && off > 3.0) || (z == size.z - 2 && x > 11);
                const bool isSpeck = random() % 41 == 0;
                labels.push_back(isMatter ? std::uint8_t(1)
                        : isSpeck         ? std::uint8_t(1 + random() % 2)
                                          : std::uint8_t(0));
            }
        }
    }
    return labels;
}

} // namespace

/// What is counted is what the engine's command erases.
class ScissorsVoxelsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void choosesWhatIsErased_data()
    {
        QTest::addColumn<int>("number");
        for (int number = 0; number < 60; ++number)
            QTest::addRow("%d", number) << number;
    }
    void choosesWhatIsErased()
    {
        QFETCH(const int, number);
        test::Random random(std::uint32_t(8100 + number));
        const glm::ivec3 size(37, 26, 30);
        Document scene = test::randomDocument(size, random, number % 2 == 1);
        scene.segments = {Segment()};
        scene.segments.front().label = 1;
        SegmentScissors edit = test::randomSegmentScissors(scene, random);
        edit.erase = true;
        edit.overwriteUnlocked = false;
        edit.lower.reset();
        edit.upper.reset();
        const Result<LabelScissors> scissors = labelScissors(edit, scene);
        QVERIFY(scissors);
        const std::vector<std::uint8_t> labels = someLabels(size, random);
        const VoxelRuns own = labelRuns(labels, 1);
        const Result<VoxelRuns> chosen = chosenOf(*scissors, own, size, {});
        QVERIFY(chosen);
        m_chosen += chosen->voxelCount() > 0;
        m_left += chosen->voxelCount() < own.voxelCount();

        reference::DenseFields fields(size);
        fields.labels(0).values = labels;
        const reference::DenseArray<std::uint16_t> codes{
            size, std::vector<std::uint16_t>(labels.size(), 500)};
        reference::labelScissors(codes, fields, *scissors);
        std::vector<std::uint8_t> meant = labels;
        for (const VoxelRun& run : chosen->runs()) {
            for (std::uint64_t voxel = run.first; voxel < run.first + run.count; ++voxel)
                meant[voxel] = 0;
        }
        QVERIFY(fields.labels(0).values == meant);
    }

    void cleanupTestCase()
    {
        QVERIFY(m_chosen > 20);
        QVERIFY(m_left > 20);
    }

    void nothingHasNothing()
    {
        test::Random random(5);
        Document scene = test::randomDocument({20, 20, 20}, random, false);
        scene.segments = {Segment()};
        scene.segments.front().label = 1;
        SegmentScissors edit = test::randomSegmentScissors(scene, random);
        edit.erase = true;
        edit.outside = false;
        edit.depthMm = 3.0;
        const Result<LabelScissors> scissors = labelScissors(edit, scene);
        QVERIFY(scissors);
        const Result<VoxelRuns> chosen = chosenOf(*scissors, {}, {20, 20, 20}, {});
        QVERIFY(chosen && chosen->empty());
    }

    void canBeCancelled()
    {
        test::Random random(6);
        const glm::ivec3 size(20, 20, 20);
        Document scene = test::randomDocument(size, random, false);
        scene.segments = {Segment()};
        scene.segments.front().label = 1;
        SegmentScissors edit = test::randomSegmentScissors(scene, random);
        edit.erase = true;
        const Result<LabelScissors> scissors = labelScissors(edit, scene);
        QVERIFY(scissors);
        Progress progress;
        progress.cancel();
        VoxelRuns own;
        own.append(20, 400);
        const Result<VoxelRuns> chosen = chosenOf(*scissors, own, size, progress);
        QVERIFY(!chosen && chosen.error().code == ErrorCode::Cancelled);
    }

private:
    int m_chosen = 0;
    int m_left = 0;
};

BURIN_TEST(ScissorsVoxelsTest)

} // namespace scissorsVoxelsTest

#include "ScissorsVoxelsTest.moc"
