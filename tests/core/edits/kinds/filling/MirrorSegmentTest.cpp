// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/MirrorSegment.h"

#include "core/brick/VoxelRuns.h"
#include "core/session/EditSession.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/PlainMasks.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/sessions/SessionBench.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>

namespace mirrorSegmentTest {

using namespace core;

namespace {

using Labels = std::vector<std::uint8_t>;
using test::smallGrid;
using test::smallIndexOf;

/// Specks and blocks of two segments.
Edit anyMatter(std::mt19937& random)
{
    Labels labels(smallGrid().voxelCount(), 0);
    for (const int label : {1, 1, 2}) {
        const glm::ivec3 from{int(random() % 20), int(random() % 20), int(random() % 15)};
        for (int z = from.z; z < from.z + 6; ++z) {
            for (int y = from.y; y < from.y + 7; ++y) {
                for (int x = from.x; x < from.x + 8; ++x)
                    labels[smallIndexOf({x, y, z})] = std::uint8_t(label);
            }
        }
    }
    std::array<VoxelRuns, 2> runs;
    for (std::size_t voxel = 0; voxel < labels.size(); ++voxel) {
        const auto dice = int(random() % 100);
        const int label = dice < 2 ? dice + 1 : labels[voxel];
        if (label > 0)
            runs.at(std::size_t(label) - 1).append(voxel, 1);
    }
    return test::matterImport(smallGrid().size, runs);
}

struct Bench : test::SessionBench {
    Bench(bool delayed, const Edit& matter)
        : SessionBench(delayed)
    {
        run(matter);
    }
};

/// Each voxel of the segment is sent to its image first, and then it is looked who is there. The
/// small study's axes are the patient's.
Labels mirrored(const Labels& before, const MirrorSegment& edit)
{
    const glm::ivec3& size = smallGrid().size;
    const auto axis = int(edit.sides);
    const double middle = edit.placeLps
        ? std::floor(2.0 * smallGrid().toIndex(*edit.placeLps)[axis] + 0.5) / 2.0
        : double(size[axis] - 1) / 2.0;
    Labels images(before.size(), 0);
    Labels after = before;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                if (before[smallIndexOf({x, y, z})] != edit.segment)
                    continue;
                if (!edit.keep)
                    after[smallIndexOf({x, y, z})] = 0;
                glm::dvec3 image(x, y, z);
                image[axis] += 2.0 * (middle - image[axis]);
                const glm::ivec3 voxel(image + 0.25);
                if (image[axis] > -0.5 && smallGrid().contains(voxel))
                    images[smallIndexOf(voxel)] = 1;
            }
        }
    }
    for (std::size_t voxel = 0; voxel < before.size(); ++voxel) {
        if (images[voxel] != 0 && (before[voxel] == 0 || before[voxel] == edit.segment))
            after[voxel] = std::uint8_t(edit.segment);
    }
    return after;
}

} // namespace

class MirrorSegmentTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// About any plane: the voxels are the images of those that were there, others keep theirs, and
    /// undo brings all back. The rows come to the same from scratch.
    void anyMatterIsMirrored_data()
    {
        QTest::addColumn<uint>("seed");
        for (uint seed = 1; seed <= 4; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void anyMatterIsMirrored()
    {
        QFETCH(const uint, seed);
        std::mt19937 random(seed);
        const Edit matter = anyMatter(random);
        Bench bench(false, matter);
        for (int step = 0; step < 9; ++step) {
            MirrorSegment edit{.segment = 1 + int(random() % 2)};
            edit.sides = MirroredSides(step % 3);
            edit.keep = random() % 2 == 0;
            if (step >= 3) {
                const glm::dvec3 half{double(10 + random() % 30), double(10 + random() % 30),
                    double(6 + random() % 20)};
                edit.placeLps = smallGrid().toWorld(0.5 * half + 0.1);
            }
            const Labels before = bench.labels();
            const QByteArray hash = bench.session->stateHash();
            QCOMPARE(bench.tried(edit), QString());
            const Labels after = bench.labels();
            QVERIFY(after == mirrored(before, edit));
            if (before == after)
                continue;
            const QByteArray changed = bench.session->stateHash();
            QVERIFY(bench.session->undo() && bench.session->settle());
            QCOMPARE(bench.session->stateHash(), hash);
            QVERIFY(bench.session->redo() && bench.session->settle());
            QCOMPARE(bench.session->stateHash(), changed);
        }
        const std::vector<HistoryRow>& rows = bench.session->history().rows();
        QVERIFY(rows.size() > 4);
        QVERIFY(rows.back().name.startsWith(QStringLiteral("Mirror 'Matter ")));
        Bench anew(true, matter);
        for (std::size_t row = 1; row < rows.size(); ++row)
            QCOMPARE(anew.tried(rows[row].edit), QString());
        QCOMPARE(anew.session->stateHash(), bench.session->stateHash());
    }

    void whatCannotBe()
    {
        std::mt19937 random(1);
        Bench bench(false, anyMatter(random));
        const QString outside = bench.tried(
            MirrorSegment{.segment = 1, .placeLps = smallGrid().toWorld({-3.0, 5.0, 5.0})});
        QVERIFY2(
            outside.startsWith(QStringLiteral("mirrorSegment.placeLps: ")), qPrintable(outside));
        QVERIFY(!bench.tried(MirrorSegment{.segment = 7}).isEmpty());
        QCOMPARE(bench.tried(test::lockSegment(1)), QString());
        QVERIFY(!bench.tried(MirrorSegment{.segment = 1}).isEmpty());
        QCOMPARE(bench.tried(MirrorSegment{.segment = 2}), QString());
    }
};

BURIN_TEST(MirrorSegmentTest)

} // namespace mirrorSegmentTest

#include "MirrorSegmentTest.moc"
