// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/growth/SeedWord.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/DelayedEngine.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace removeSegmentTest {

using namespace core;

namespace {

struct Bench {
    explicit Bench(bool delayed = false, const QString& file = {})
        : late(inner, 11)
    {
        EditEngine& engine = delayed ? static_cast<EditEngine&>(late) : inner;
        session = *EditSession::create(engine, test::smallStudy(), {.file = file});
    }
    void run(const Edit& edit)
    {
        const Result<void> applied = session->apply(edit);
        QVERIFY2(applied, qPrintable(applied ? QString() : applied.error().arguments.join(u' ')));
        QVERIFY(session->settle());
    }
    [[nodiscard]] QByteArray undone()
    {
        if (!session->undo() || !session->settle())
            return "refused";
        return session->stateHash();
    }
    [[nodiscard]] const HistoryRow& lastRow() const { return session->history().rows().back(); }
    [[nodiscard]] std::int64_t voxels(int label)
    {
        const std::vector<std::uint8_t> labels = *session->questions().labels(0);
        return std::count(labels.begin(), labels.end(), label);
    }
    [[nodiscard]] std::int64_t words(std::uint32_t label)
    {
        reference::DenseFields fields = inner.fields();
        const std::vector<std::uint32_t>& all = fields.seedWords(0).values;
        return std::count_if(all.begin(), all.end(), [label](std::uint32_t word) {
            return (seedWord::isMember(word) || seedWord::isPendingSeed(word))
                && seedWord::label(word) == label;
        });
    }

    reference::ReferenceEngine inner;
    reference::DelayedEngine late;
    std::unique_ptr<EditSession> session;
};

/// In the air, where nothing has grown.
Edit seedInCorner(int segment, const glm::dvec3& voxel)
{
    return test::seedAt(segment, {test::smallStudy().volume.geometry.toWorld(voxel)});
}

/// Brain (1) and bone (2), both grown, with seeds of both pending.
std::vector<Edit> twoGrown()
{
    return {test::addSegment("Brain"), test::addSegment("Bone"), test::seedInBrain(1),
        test::growBrain(), test::seedInBone(2), test::growBone(6),
        seedInCorner(1, {39.0, 35.0, 33.0}), seedInCorner(2, {0.0, 0.0, 0.0})};
}

} // namespace

class RemoveSegmentTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void takesVoxelsAndSeedsAndBringsThemBack_data()
    {
        QTest::addColumn<bool>("delayed");
        QTest::newRow("at once") << false;
        QTest::newRow("late and in bursts") << true;
    }
    void takesVoxelsAndSeedsAndBringsThemBack()
    {
        QFETCH(bool, delayed);
        Bench bench(delayed);
        for (const Edit& edit : twoGrown())
            bench.run(edit);
        bench.run(ChangeSegment{.segment = 1,
            .name = QStringLiteral("Cerebrum"),
            .rgb = 0x123456,
            .code = CodedConcept{
                QStringLiteral("SCT"), QStringLiteral("12738006"), QStringLiteral("Brain")}});
        const QByteArray before = bench.session->stateHash();
        const std::int64_t brain = bench.voxels(1);
        const std::int64_t bone = bench.voxels(2);
        QVERIFY(brain > 1000 && bone > 10 && bench.words(1) > brain);

        bench.run(RemoveSegment{.segment = 1});
        QCOMPARE(bench.voxels(1), 0);
        QCOMPARE(bench.words(1), 0);
        QCOMPARE(bench.voxels(2), bone);
        QVERIFY(bench.words(2) > bone);
        QCOMPARE(bench.session->document().segments.size(), std::size_t(1));
        QCOMPARE(bench.session->document().segments.front().name, QStringLiteral("Bone"));
        QCOMPARE(bench.session->document().segments.front().voxels, bone);
        QString digits = QString::number(brain);
        digits.insert(digits.size() - 3, QLatin1Char(' '));
        QCOMPARE(bench.lastRow().name,
            QStringLiteral("Delete segment 'Cerebrum', −%1 voxels").arg(digits));
        const QByteArray removed = bench.session->stateHash();

        QCOMPARE(bench.undone(), before);
        const Segment& back = bench.session->document().segments.front();
        QCOMPARE(back.name, QStringLiteral("Cerebrum"));
        QCOMPARE(back.rgb, 0x123456u);
        QCOMPARE(back.code.value, QStringLiteral("12738006"));
        QCOMPARE(back.voxels, brain);
        QVERIFY(bench.session->redo());
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.session->stateHash(), removed);
    }

    void isNeverGrownAgain()
    {
        Bench bench;
        for (const Edit& edit : twoGrown())
            bench.run(edit);
        bench.run(RemoveSegment{.segment = 1});
        bench.run(test::growBetween(-1100, 3000));
        QCOMPARE(bench.voxels(1), 0);
        QCOMPARE(bench.words(1), 0);
        QVERIFY(bench.voxels(2) > 1000);
        bench.run(test::addSegment("Brain again"));
        QCOMPARE(int(bench.session->document().segments.back().label), 3);
    }

    void anEmptyOneLeavesARowToo()
    {
        Bench bench;
        bench.run(test::addSegment("Brain"));
        const QByteArray before = bench.session->stateHash();
        bench.run(RemoveSegment{.segment = 1});
        QCOMPARE(bench.lastRow().name, QStringLiteral("Delete segment 'Brain', empty"));
        QVERIFY(bench.session->document().segments.empty());
        QCOMPARE(bench.undone(), before);
        bench.run(test::seedInBrain(1));
        bench.run(RemoveSegment{.segment = 1});
        QCOMPARE(bench.lastRow().name, QStringLiteral("Delete segment 'Brain', −2 seed voxels"));
        QCOMPARE(bench.words(1), 0);
    }

    void isRefused()
    {
        Bench bench;
        bench.run(test::addSegment("Brain"));
        bench.run(ChangeSegment{.segment = 1, .locked = true});
        const Result<void> locked = bench.session->apply(RemoveSegment{.segment = 1});
        QVERIFY(!locked);
        QCOMPARE(locked.error().code, ErrorCode::SegmentLocked);
        QCOMPARE(locked.error().arguments.value(0), QStringLiteral("Brain"));
        const Result<void> unknown = bench.session->apply(RemoveSegment{.segment = 2});
        QVERIFY(!unknown);
        QCOMPARE(unknown.error().code, ErrorCode::UnknownSegment);
        QCOMPARE(bench.session->history().rows().size(), std::size_t(2));
    }

    /// What waits in line is foreseen: nothing may be done to a segment that is about to go.
    void thoseWhoCannotWaitAreToldAtOnce()
    {
        Bench bench(true);
        for (const Edit& edit : twoGrown())
            QVERIFY(bench.session->apply(edit));
        QVERIFY(bench.session->apply(RemoveSegment{.segment = 1}));
        const Result<void> seeds = bench.session->apply(test::seedInBrain(1));
        QVERIFY(!seeds);
        QCOMPARE(seeds.error().code, ErrorCode::UnknownSegment);
        QVERIFY(!bench.session->apply(RemoveSegment{.segment = 1}));
        QVERIFY(bench.session->apply(test::addSegment("Third")));
        QCOMPARE(int(bench.session->foreseenDocument().segments.back().label), 3);
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.voxels(1), 0);
        QCOMPARE(int(bench.session->document().segments.back().label), 3);
    }

    void standsInTheFile()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("removed.burin"));
        QByteArray hash;
        QByteArray before;
        {
            Bench bench(false, file);
            for (const Edit& edit : twoGrown())
                bench.run(edit);
            before = bench.session->stateHash();
            bench.run(RemoveSegment{.segment = 1});
            hash = bench.session->stateHash();
        }
        reference::ReferenceEngine engine;
        auto session = EditSession::open(engine, test::smallStudy(), file);
        QVERIFY(session);
        QCOMPARE((*session)->stateHash(), hash);
        QVERIFY((*session)->apply(test::addSegment("Third")));
        QVERIFY((*session)->settle());
        QCOMPARE(int((*session)->document().segments.back().label), 3);
        QVERIFY((*session)->undo());
        QVERIFY((*session)->undo());
        QVERIFY((*session)->settle());
        QCOMPARE((*session)->stateHash(), before);
    }

    /// Its label could come back without it.
    void holdsWhatCameBefore()
    {
        Bench bench;
        for (const Edit& edit : twoGrown())
            bench.run(edit);
        bench.run(test::drillAt(0));
        bench.run(RemoveSegment{.segment = 1});
        const QByteArray before = bench.session->stateHash();
        const auto refusal = [&bench](const Edit& edit) {
            Result<void> done = bench.session->apply(edit);
            if (done)
                done = bench.session->settle();
            return done ? ErrorCode::Internal : done.error().code;
        };
        QVERIFY(refusal(test::revertRows({6})) == ErrorCode::StepsEntangled); // growth
        QVERIFY(refusal(test::revertRows({7}))
            == ErrorCode::StepsEntangled); // seeds of the one deleted
        QVERIFY(
            refusal(test::revertRows({10})) == ErrorCode::StepsEntangled); // the deletion itself
        QCOMPARE(bench.session->stateHash(), before);
        bench.run(test::revertRows({9})); // a cut has nothing to do with it
        QVERIFY(bench.session->stateHash() != before);
    }
};

BURIN_TEST(RemoveSegmentTest)

} // namespace removeSegmentTest

#include "RemoveSegmentTest.moc"
