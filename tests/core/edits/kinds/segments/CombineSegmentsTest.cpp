// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/brick/VoxelRuns.h"
#include "core/growth/SeedWord.h"
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
#include <random>

namespace combineSegmentsTest {

using namespace core;

namespace {

using How = CombineSegments::How;

struct Bench : test::SessionBench {
    explicit Bench(bool delayed = false)
        : SessionBench(delayed)
    {
    }
    /// Brain (1) and bone (2), both grown, and an empty segment (3).
    void grow()
    {
        for (const Edit& edit : {test::addSegment("Brain"), test::addSegment("Bone"),
                 test::seedInBrain(1), test::growBrain(), test::seedInBone(2), test::growBone(6),
                 test::addSegment("None")})
            run(edit);
    }
    [[nodiscard]] std::vector<std::uint32_t> words() const
    {
        reference::DenseFields fields = inner.fields();
        return fields.seedWords(0).values;
    }
};

QString spaced(std::int64_t count)
{
    QString digits = QString::number(count);
    for (qsizetype place = digits.size() - 3; place > 0; place -= 3)
        digits.insert(place, u' ');
    return digits;
}

/// Said of each voxel: what it holds afterwards.
std::uint8_t after(const CombineSegments& edit, std::uint8_t held)
{
    if (held == edit.with)
        return std::uint8_t(edit.segment);
    return held == edit.segment && edit.how == How::Swap ? std::uint8_t(edit.with) : held;
}

/// Three segments that lie about at random.
Edit randomMatter(std::mt19937& random)
{
    const glm::ivec3& size = test::smallStudy().volume.geometry.size;
    std::array<VoxelRuns, 3> runs;
    const auto voxels = std::uint64_t(size.x) * std::uint64_t(size.y) * std::uint64_t(size.z);
    for (std::uint64_t voxel = 0; voxel < voxels; ++voxel) {
        const std::size_t dice = random() % 4;
        if (dice < runs.size())
            runs.at(dice).append(voxel, 1);
    }
    return test::matterImport(size, runs);
}

} // namespace

class CombineSegmentsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void mergesAndSwaps_data()
    {
        QTest::addColumn<int>("how");
        QTest::addColumn<bool>("delayed");
        QTest::newRow("merge") << int(How::Merge) << false;
        QTest::newRow("merge, late and in bursts") << int(How::Merge) << true;
        QTest::newRow("swap") << int(How::Swap) << false;
        QTest::newRow("swap, late and in bursts") << int(How::Swap) << true;
    }
    void mergesAndSwaps()
    {
        QFETCH(const int, how);
        QFETCH(const bool, delayed);
        const CombineSegments edit{.segment = 1, .with = 2, .how = How(how)};
        const bool swaps = edit.how == How::Swap;
        Bench bench(delayed);
        bench.grow();
        const std::vector<std::uint8_t> before = bench.labels();
        const std::vector<std::uint32_t> words = bench.words();
        const QByteArray hash = bench.session->stateHash();
        const std::int64_t brain = bench.voxels(1);
        const std::int64_t bone = bench.voxels(2);
        QVERIFY(brain > 1000 && bone > 10);

        bench.run(edit);
        const std::vector<std::uint8_t> labels = bench.labels();
        for (std::size_t i = 0; i < before.size(); ++i)
            QCOMPARE(int(labels[i]), int(after(edit, before[i])));
        const Document& document = bench.session->document();
        QCOMPARE(document.segments.size(), std::size_t(3)); // the other stays in the list
        QCOMPARE(document.segment(1)->voxels, swaps ? bone : brain + bone);
        QCOMPARE(document.segment(2)->voxels, swaps ? brain : std::int64_t(0));
        QCOMPARE(bench.rows().back().name,
            swaps ? QStringLiteral("Swap segments 'Brain' and 'Bone', +%1 −%2 voxels")
                        .arg(spaced(bone), spaced(brain))
                  : QStringLiteral("Merge segment 'Bone' into 'Brain', +%1 voxels")
                        .arg(spaced(bone)));
        // No growth goes on from what changed hands; everything else it may go on from is there.
        const std::vector<std::uint32_t> wordsNow = bench.words();
        std::array<int, 3> gone{}; // by label
        for (std::size_t i = 0; i < words.size(); ++i) {
            const std::uint32_t word = words[i];
            const bool bears = seedWord::isMember(word) || seedWord::isPendingSeed(word);
            const std::uint32_t label = bears ? seedWord::label(word) : 0;
            const bool goes = bears && labels[i] != before[i] && label != labels[i];
            QCOMPARE(wordsNow[i], goes ? seedWord::unvisited : word);
            gone.at(label) += goes ? 1 : 0;
        }
        QVERIFY(gone[2] > 0 && (gone[1] > 0) == swaps);

        const QByteArray combined = bench.session->stateHash();
        QVERIFY(bench.session->undo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), hash);
        QCOMPARE(bench.words(), words);
        QVERIFY(bench.session->redo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), combined);
        if (swaps) {
            bench.run(edit);
            QCOMPARE(bench.labels(), before);
        }
    }

    /// Merging a segment that holds nothing is no step; swapping with it is a move.
    void withAnEmptyOne()
    {
        Bench bench;
        bench.grow();
        const std::int64_t brain = bench.voxels(1);
        const std::size_t rows = bench.rows().size();
        bench.run(CombineSegments{.segment = 1, .with = 3});
        QCOMPARE(bench.rows().size(), rows);
        bench.run(CombineSegments{.segment = 1, .with = 3, .how = How::Swap});
        QCOMPARE(bench.rows().size(), rows + 1);
        QCOMPARE(bench.voxels(1), std::int64_t(0));
        QCOMPARE(bench.voxels(3), brain);
        QCOMPARE(bench.rows().back().name,
            QStringLiteral("Swap segments 'Brain' and 'None', −%1 voxels").arg(spaced(brain)));
    }

    void whatCannotBe()
    {
        Bench bench;
        bench.grow();
        const auto code = [&](const CombineSegments& edit) {
            const Result<void> applied = bench.session->apply(edit);
            return applied ? ErrorCode::Internal : applied.error().code;
        };
        for (const How how : {How::Merge, How::Swap}) {
            QCOMPARE(code({.segment = 9, .with = 1, .how = how}), ErrorCode::UnknownSegment);
            QCOMPARE(code({.segment = 1, .with = 9, .how = how}), ErrorCode::UnknownSegment);
            QCOMPARE(code({.segment = 1, .with = 1, .how = how}), ErrorCode::InvalidField);
        }
        const std::vector<std::uint8_t> before = bench.labels();
        bench.run(test::lockSegment(2));
        for (const How how : {How::Merge, How::Swap}) {
            QCOMPARE(code({.segment = 1, .with = 2, .how = how}), ErrorCode::SegmentLocked);
            QCOMPARE(code({.segment = 2, .with = 1, .how = how}), ErrorCode::SegmentLocked);
        }
        QVERIFY(bench.labels() == before);
        // One that is locked but not meant keeps what it has.
        bench.run(CombineSegments{.segment = 3, .with = 1});
        const std::vector<std::uint8_t> labels = bench.labels();
        for (std::size_t i = 0; i < before.size(); ++i)
            QCOMPARE(labels[i] == 2, before[i] == 2);
    }

    /// Any merges and swaps of random matter, one after the other, voxel by voxel; the way back,
    /// and the same from scratch.
    void inAnyOrder()
    {
        for (std::uint32_t seed = 1; seed <= 4; ++seed) {
            std::mt19937 random(seed);
            const Edit matter = randomMatter(random);
            Bench bench;
            bench.run(matter);
            const QByteArray beginning = bench.session->stateHash();
            std::vector<std::uint8_t> expected = bench.labels();
            for (int step = 0; step < 8; ++step) {
                CombineSegments edit{.segment = 1 + int(random() % 3)};
                edit.with = 1 + (edit.segment + int(random() % 2)) % 3;
                edit.how = random() % 3 == 0 ? How::Merge : How::Swap;
                QVERIFY(edit.with != edit.segment);
                bench.run(edit);
                for (std::uint8_t& held : expected)
                    held = after(edit, held);
                QVERIFY(bench.labels() == expected);
                for (const int label : {1, 2, 3})
                    QCOMPARE(bench.session->document().segment(label)->voxels,
                        std::int64_t(std::count(expected.begin(), expected.end(), label)));
            }
            const QByteArray end = bench.session->stateHash();
            QVERIFY(bench.rows().size() > 1);
            Bench anew;
            for (const HistoryRow& row : bench.rows())
                anew.run(row.edit);
            QCOMPARE(anew.session->stateHash(), end);
            QVERIFY(bench.session->goTo(1) && bench.session->settle());
            QCOMPARE(bench.session->stateHash(), beginning);
        }
    }
};

BURIN_TEST(CombineSegmentsTest)

} // namespace combineSegmentsTest

#include "CombineSegmentsTest.moc"
