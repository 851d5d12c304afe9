// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/growth/SeedWord.h"
#include "core/session/EditSession.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/sessions/SessionBench.h"

#include <QTest>

#include <algorithm>
#include <array>

namespace invertSegmentTest {

using namespace core;

namespace {

struct Bench : test::SessionBench {
    explicit Bench(bool delayed = false)
        : SessionBench(delayed)
    {
        // Brain (1) and bone (2), both grown, and a seed of each that waits in the air.
        for (const Edit& edit : {test::addSegment("Brain"), test::addSegment("Bone"),
                 test::seedInBrain(1), test::growBrain(), test::seedInBone(2), test::growBone(6),
                 test::seedAt(1, {placeOf({39.0, 35.0, 33.0})}),
                 test::seedAt(2, {placeOf({0.0, 0.0, 0.0})})})
            run(edit);
    }
    static glm::dvec3 placeOf(const glm::dvec3& voxel)
    {
        return test::smallStudy().volume.geometry.toWorld(voxel);
    }
    [[nodiscard]] std::vector<std::uint32_t> words() const
    {
        reference::DenseFields fields = inner.fields();
        return fields.seedWords(0).values;
    }
    [[nodiscard]] const HistoryRow& lastRow() const { return session->history().rows().back(); }
};

QString spaced(std::int64_t count)
{
    QString digits = QString::number(count);
    for (qsizetype place = digits.size() - 3; place > 0; place -= 3)
        digits.insert(place, u' ');
    return digits;
}

} // namespace

class InvertSegmentTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void givesWhatIsFreeAndFreesTheRest_data()
    {
        QTest::addColumn<bool>("delayed");
        QTest::newRow("at once") << false;
        QTest::newRow("late and in bursts") << true;
    }
    void givesWhatIsFreeAndFreesTheRest()
    {
        QFETCH(bool, delayed);
        Bench bench(delayed);
        const std::vector<std::uint8_t> before = bench.labels();
        const QByteArray hash = bench.session->stateHash();
        const std::int64_t brain = bench.voxels(1);
        const std::int64_t free = bench.voxels(0);
        const std::vector<std::uint32_t> words = bench.words();
        QVERIFY(brain > 1000 && free > 1000 && bench.voxels(2) > 10);

        bench.run(InvertSegment{.segment = 1});
        const std::vector<std::uint8_t> after = bench.labels();
        for (std::size_t i = 0; i < before.size(); ++i)
            QCOMPARE(int(after[i]), before[i] == 0 ? 1 : before[i] == 1 ? 0 : int(before[i]));
        QCOMPARE(bench.session->document().segment(1)->voxels, free);
        QCOMPARE(bench.lastRow().name,
            QStringLiteral("Invert segment 'Brain', +%1 −%2 voxels")
                .arg(spaced(free), spaced(brain)));
        // No growth goes on from what was freed, nor seeds of others from what was taken.
        const std::vector<std::uint32_t> wordsAfter = bench.words();
        std::array<int, 3> gone{}; // by label
        for (std::size_t i = 0; i < words.size(); ++i) {
            const std::uint32_t word = words[i];
            const bool bears = seedWord::isMember(word) || seedWord::isPendingSeed(word);
            const std::uint32_t label = bears ? seedWord::label(word) : 0;
            const bool goes = before[i] == 0 ? label > 1 : before[i] == 1 && label == 1;
            QCOMPARE(wordsAfter[i], goes ? seedWord::unvisited : word);
            gone.at(label) += goes ? 1 : 0;
        }
        QVERIFY(gone[1] > 1000 && gone[2] > 0);
        const QByteArray inverted = bench.session->stateHash();

        QVERIFY(bench.session->undo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), hash);
        QCOMPARE(bench.words(), words);
        QVERIFY(bench.session->redo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), inverted);

        bench.run(InvertSegment{.segment = 1});
        QCOMPARE(bench.labels(), before);
    }

    void anEmptySegmentTakesAllThatIsFree()
    {
        Bench bench;
        bench.run(test::addSegment("Air"));
        const std::int64_t free = bench.voxels(0);
        bench.run(InvertSegment{.segment = 3});
        QCOMPARE(bench.voxels(0), 0);
        QCOMPARE(bench.voxels(3), free);
        QCOMPARE(bench.lastRow().name,
            QStringLiteral("Invert segment 'Air', +%1 voxels").arg(spaced(free)));
        // Where nothing is free and nothing held, nothing happens, and no row tells of it.
        bench.run(test::addSegment("None"));
        const std::size_t rows = bench.session->history().rows().size();
        bench.run(InvertSegment{.segment = 4});
        QCOMPARE(bench.session->history().rows().size(), rows);
        bench.run(InvertSegment{.segment = 3});
        QCOMPARE(bench.lastRow().name,
            QStringLiteral("Invert segment 'Air', −%1 voxels").arg(spaced(free)));
    }

    void aLockedOneIsRefusedAndOthersStay()
    {
        Bench bench;
        bench.run(test::lockSegment(2));
        const Result<void> refused = bench.session->apply(InvertSegment{.segment = 2});
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::SegmentLocked);
        QCOMPARE(bench.session->apply(InvertSegment{.segment = 9}).error().code,
            ErrorCode::UnknownSegment);
        const std::int64_t bone = bench.voxels(2);
        bench.run(InvertSegment{.segment = 1});
        QCOMPARE(bench.voxels(2), bone);
    }
};

BURIN_TEST(InvertSegmentTest)

} // namespace invertSegmentTest

#include "InvertSegmentTest.moc"
