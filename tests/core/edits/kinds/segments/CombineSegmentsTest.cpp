// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/brick/VoxelRuns.h"
#include "core/edits/kinds/imports/ImportMask.h"
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

/// Three segments that lie about at random, in one label plane.
Edit randomMatter(std::mt19937& random, int plane)
{
    const glm::ivec3& size = test::smallStudy().volume.geometry.size;
    std::array<VoxelRuns, 3> runs;
    const auto voxels = std::uint64_t(size.x) * std::uint64_t(size.y) * std::uint64_t(size.z);
    for (std::uint64_t voxel = 0; voxel < voxels; ++voxel) {
        const std::size_t dice = random() % 4;
        if (dice < runs.size())
            runs.at(dice).append(voxel, 1);
    }
    Edit matter = test::matterImport(size, runs);
    if (plane != 0)
        matter.as<ImportMask>()->planes = std::vector<int>(runs.size(), plane);
    return matter;
}

/// "A" in one label plane, "B" and "C" in another, all at random.
Edit overlappingMatter(std::mt19937& random, const std::vector<int>& planes)
{
    const glm::ivec3& size = test::smallStudy().volume.geometry.size;
    std::vector<test::MaskPart> parts{
        {QStringLiteral("A"), {}}, {QStringLiteral("B"), {}}, {QStringLiteral("C"), {}}};
    const auto voxels = std::uint64_t(size.x) * std::uint64_t(size.y) * std::uint64_t(size.z);
    for (std::uint64_t voxel = 0; voxel < voxels; ++voxel) {
        if (random() % 2)
            parts[0].voxels.append(voxel, 1);
        const std::size_t dice = random() % 4;
        if (dice == 1 || dice == 2)
            parts[dice].voxels.append(voxel, 1);
    }
    return test::maskImport(QStringLiteral("overlaps.seg.nrrd"), size, parts, planes);
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
            const int plane = seed % 2 == 0 ? 2 : 0;
            const Edit matter = randomMatter(random, plane);
            Bench bench;
            bench.run(matter);
            const QByteArray beginning = bench.session->stateHash();
            std::vector<std::uint8_t> expected = bench.labels(plane);
            for (int step = 0; step < 8; ++step) {
                CombineSegments edit{.segment = 1 + int(random() % 3)};
                edit.with = 1 + (edit.segment + int(random() % 2)) % 3;
                edit.how = random() % 3 == 0 ? How::Merge : How::Swap;
                QVERIFY(edit.with != edit.segment);
                bench.run(edit);
                for (std::uint8_t& held : expected)
                    held = after(edit, held);
                QVERIFY(bench.labels(plane) == expected);
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

    /// Of two label planes, whichever comes first: the segment receives what is free in its plane,
    /// the other keeps the rest, voxel by voxel.
    void mergesAcrossPlanes_data()
    {
        QTest::addColumn<std::vector<int>>("planes"); // of A, B and C
        QTest::addColumn<int>("into");
        QTest::newRow("into a plane that is free") << std::vector<int>{0, 1, 1} << 1;
        QTest::newRow("into one where another lies") << std::vector<int>{0, 1, 1} << 2;
        QTest::newRow("from the upper plane") << std::vector<int>{3, 1, 1} << 2;
    }
    void mergesAcrossPlanes()
    {
        QFETCH(const std::vector<int>, planes);
        QFETCH(const int, into);
        const int from = 3 - into;
        const int own = planes[std::size_t(into - 1)];
        const int other = planes[std::size_t(from - 1)];
        std::mt19937 random(3);
        const Edit matter = overlappingMatter(random, planes);
        Bench bench;
        bench.run(matter);
        std::vector<std::uint8_t> mine = bench.labels(own);
        std::vector<std::uint8_t> theirs = bench.labels(other);
        const QByteArray hash = bench.session->stateHash();
        std::int64_t gained = 0;
        std::int64_t kept = 0;
        for (std::size_t i = 0; i < mine.size(); ++i) {
            if (theirs[i] != from)
                continue;
            gained += mine[i] == 0 ? 1 : 0;
            if (mine[i] == 0)
                mine[i] = std::uint8_t(into);
            if (mine[i] == into)
                theirs[i] = 0;
            else
                ++kept;
        }
        QVERIFY(gained > 1000 && (kept > 1000) == (into == 2));
        const CombineSegments edit{.segment = into, .with = from};
        bench.run(edit);
        QVERIFY(bench.labels(own) == mine);
        QVERIFY(bench.labels(other) == theirs);
        const Document& document = bench.session->document();
        QCOMPARE(document.segment(into)->voxels, bench.voxels(into, own));
        QCOMPARE(document.segment(from)->voxels, kept);
        QString name = (into == 1 ? QStringLiteral("Merge segment 'B' into 'A', +%1 voxels")
                                  : QStringLiteral("Merge segment 'A' into 'B', +%1 voxels"))
                           .arg(spaced(gained));
        if (kept > 0)
            name += QStringLiteral(", %1 voxels stay").arg(spaced(kept));
        QCOMPARE(bench.rows().back().name, name);

        const QByteArray merged = bench.session->stateHash();
        QVERIFY(bench.session->undo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), hash);
        QVERIFY(bench.session->redo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), merged);
        Bench anew(true);
        anew.run(matter);
        anew.run(edit);
        QCOMPARE(anew.session->stateHash(), merged);
        // What is left of it cannot be given now either: no step.
        const std::size_t rows = bench.rows().size();
        bench.run(edit);
        QCOMPARE(bench.rows().size(), rows);
    }

    /// What lies outside the range stays with the other one.
    void aMergeAcrossPlanesKeepsToTheRange()
    {
        std::mt19937 random(8);
        Bench bench;
        bench.run(overlappingMatter(random, {0, 1, 1}));
        const std::vector<std::uint8_t> mine = bench.labels(0);
        const std::vector<std::uint8_t> theirs = bench.labels(1);
        CombineSegments edit{.segment = 1, .with = 2};
        edit.editable.emplace().upper = 100.0; // not the bone
        bench.run(edit);
        const LoadedVolume study = test::smallStudy();
        const std::vector<std::uint8_t> mineNow = bench.labels(0);
        const std::vector<std::uint8_t> theirsNow = bench.labels(1);
        int spared = 0;
        for (std::size_t i = 0; i < mine.size(); ++i) {
            const bool isMeant =
                theirs[i] == 2 && study.volume.encoding.value(study.codes[i]) < 100;
            QCOMPARE(int(mineNow[i]), isMeant ? 1 : int(mine[i]));
            QCOMPARE(int(theirsNow[i]), isMeant ? 0 : int(theirs[i]));
            spared += theirsNow[i] == 2 ? 1 : 0;
        }
        QVERIFY(spared > 100);
    }
};

BURIN_TEST(CombineSegmentsTest)

} // namespace combineSegmentsTest

#include "CombineSegmentsTest.moc"
