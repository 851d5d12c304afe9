// SPDX-License-Identifier: Apache-2.0
#include "core/session/questions/VoxelQuestions.h"

#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/criteria/ToleranceEdits.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/session/EditSession.h"
#include "core/session/past/LabelReader.h"
#include "tests/reference/DelayedEngine.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTest>

#include <algorithm>
#include <numeric>

namespace voxelQuestionsTest {

using namespace core;

namespace {

constexpr glm::ivec3 inBrain{20, 18, 17};

/// A session on the oracle, whose answers come late.
struct Bench {
    explicit Bench(const std::vector<Edit>& edits = {})
        : late(inner, 5)
        , study(test::smallStudy())
    {
        session = *EditSession::create(late, study, {});
        for (const Edit& edit : edits) {
            [&] { QVERIFY(session->apply(edit) && session->settle()); }();
        }
    }
    [[nodiscard]] VoxelQuestions& questions() const { return session->questions(); }
    [[nodiscard]] std::uint16_t codeAt(const glm::ivec3& voxel) const
    {
        const glm::ivec3 size = study.volume.geometry.size;
        return study.codes[std::size_t(voxel.x)
            + std::size_t(size.x)
                * (std::size_t(voxel.y) + std::size_t(size.y) * std::size_t(voxel.z))];
    }
    /// Asks, and waits for the answer.
    template <class T, class Ask> [[nodiscard]] Result<T> answerTo(Ask&& ask) const
    {
        std::optional<Result<T>> told;
        ask([&told](Result<T> answer) { told = std::move(answer); });
        [&] { QVERIFY(!told); }(); // never before poll()
        [&] { QVERIFY(session->settle()); }();
        return told ? *std::move(told) : failure(ErrorCode::Internal, QStringLiteral("no answer"));
    }

    reference::ReferenceEngine inner;
    reference::DelayedEngine late;
    LoadedVolume study;
    std::unique_ptr<EditSession> session;
};

} // namespace

class VoxelQuestionsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void codesAreThoseOfTheVolume()
    {
        const Bench bench;
        const VoxelBox box{.minimum = {2, 3, 4}, .maximum = {6, 5, 7}};
        const auto codes = bench.answerTo<std::vector<std::uint16_t>>(
            [&](auto take) { bench.questions().codes(box, take); });
        QVERIFY(codes);
        std::vector<std::uint16_t> expected;
        for (int z = box.minimum.z; z < box.maximum.z; ++z)
            for (int y = box.minimum.y; y < box.maximum.y; ++y)
                for (int x = box.minimum.x; x < box.maximum.x; ++x)
                    expected.push_back(bench.codeAt({x, y, z}));
        QCOMPARE(*codes, expected);
        const auto nothing = bench.answerTo<std::vector<std::uint16_t>>(
            [&](auto take) { bench.questions().codes({}, take); });
        QVERIFY(!nothing && nothing.error().code == ErrorCode::InvalidField);
    }

    void voxelsAreTold()
    {
        const Bench bench({test::addSegment("Brain"), test::seedInBrain(1), test::growBrain(2)});
        using Probes = std::vector<ProbedVoxel>;
        const auto probes = bench.answerTo<Probes>([&](auto take) {
            bench.questions().probe({inBrain, {0, 0, 0}}, take);
        });
        QVERIFY(probes && probes->size() == 2);
        QCOMPARE(probes->front().code, int(bench.codeAt(inBrain)));
        QCOMPARE(int(probes->front().label), 1);
        QCOMPARE(int(probes->back().label), 0);
        const auto outside = bench.answerTo<Probes>([&](auto take) {
            bench.questions().probe({{-1, 0, 0}}, take);
        });
        QVERIFY(!outside && outside.error().code == ErrorCode::InvalidField);
    }

    /// What is asked behind a preview is answered while it stands open, of what it shows, also if
    /// the preview has to wait until another one is taken back.
    void previewsAreAskedAbout()
    {
        const Bench bench({test::addSegment("Brain")});
        const double most = bench.study.volume.maximum;
        const ThresholdSegment little{.segment = 1, .lower = most, .upper = most};
        const ThresholdSegment all{
            .segment = 1, .lower = bench.study.volume.minimum, .upper = most};
        using Probes = std::vector<ProbedVoxel>;
        for (const auto& [edit, label] : {std::pair(little, 0), {all, 1}, {little, 0}, {all, 1}}) {
            QVERIFY(bench.session->begin(edit));
            std::optional<Result<Probes>> told;
            bench.questions().probe(
                {inBrain}, [&told](Result<Probes> answer) { told = std::move(answer); });
            for (int i = 0; i < 1000 && !told; ++i)
                bench.session->poll();
            QVERIFY(bench.session->isOpen<ThresholdSegment>());
            QVERIFY(told && *told);
            QCOMPARE(int((*told)->front().label), label);
        }
        bench.session->end(Ending::Rollback);
        QVERIFY(bench.session->settle());
    }

    void raysAreToldOneByOne()
    {
        const Bench bench;
        using Picked = std::vector<std::optional<glm::ivec3>>;
        const auto picked = bench.answerTo<Picked>([&](auto take) {
            bench.questions().pick({.rays = {PickRay{}, PickRay{}}}, take);
        });
        QVERIFY(picked);
        QCOMPARE(picked->size(), std::size_t(2)); // without samples nothing is seen
        QVERIFY(!picked->front() && !picked->back());
        const auto unsound = bench.answerTo<Picked>(
            [&](auto take) { bench.questions().pick({.seenBy = SeenBy::Opacity}, take); });
        QVERIFY(!unsound && unsound.error().code == ErrorCode::InvalidField);
    }

    /// A plane at once, in portions, and by bricks.
    void planesAreReadInThreeWays()
    {
        const Bench bench({test::addSegment("Brain"), test::seedInBrain(1), test::growBrain(3)});
        const std::vector<std::uint8_t> labels = *bench.questions().labels(0);
        QCOMPARE(std::int64_t(std::count(labels.begin(), labels.end(), 1)),
            std::int64_t(bench.session->document().segment(1)->voxels));
        const glm::ivec3 size = bench.study.volume.geometry.size;
        const auto reader = std::make_shared<LabelReader>(size, std::uint8_t(0));
        int portions = 0;
        while (bench.questions().readOn(reader, [&portions](const Result<void>& portion) {
            QVERIFY(portion);
            ++portions;
        }))
            QVERIFY(bench.session->settle());
        QVERIFY(portions > 0);
        QVERIFY(reader->takeLabels() == labels);

        const BrickGrid grid{size};
        const BrickKey key{Field::Labels, 0, std::uint32_t(grid.brickOf(inBrain))};
        const auto bricks = bench.answerTo<std::vector<BrickImage>>(
            [&](auto take) { bench.questions().bricks({key}, take); });
        QVERIFY(bricks && bricks->size() == 1);
        QCOMPARE(bricks->front().key, key);
        QCOMPARE(
            int(bricks->front().bytes.read().at(std::size_t(BrickGrid::offsetInBrick(inBrain)))),
            1);
        const std::vector<std::uint8_t> coverage = *bench.questions().coverage(1);
        QVERIFY(coverage == std::vector<std::uint8_t>(labels.size(), 0));
    }

    void seedsAndGenerationsAreCounted()
    {
        const Bench bench({test::addSegment("Brain"), test::seedInBrain(1)});
        const auto seeds = bench.answerTo<std::vector<ProbedSeeds>>(
            [&](auto take) { bench.questions().seedSums(0, {.low = 0, .high = 65535}, {}, take); });
        QVERIFY(seeds && seeds->size() == 1);
        QCOMPARE(int(seeds->front().label), 1);
        QVERIFY(seeds->front().sums.voxels > 0 && !seeds->front().group);

        QVERIFY(bench.session->apply(test::growBrain(2)));
        const auto sizes = bench.answerTo<std::vector<std::uint32_t>>(
            [&](auto take) { bench.questions().generationSizes(0, take); });
        QVERIFY(sizes);
        QCOMPARE(std::accumulate(sizes->begin(), sizes->end(), std::int64_t(0)),
            std::int64_t(bench.session->document().segment(1)->voxels));
    }

    void aToleranceStandsUntilItIsDropped()
    {
        const Bench bench({test::addSegment("Brain"), test::seedInBrain(1)});
        const auto rule = toleranceRule(1, {}, bench.session->document());
        QVERIFY(rule);
        using Curve = std::optional<ToleranceCurve>;
        Result<Curve> curve = Curve();
        for (int i = 0; i < 1000 && curve && !*curve; ++i)
            curve = bench.answerTo<Curve>(
                [&](auto take) { bench.questions().traceTolerance(*rule, take); });
        QVERIFY(curve && *curve);
        const auto toleranceInBrain = [&] {
            return bench
                .answerTo<std::vector<ProbedVoxel>>(
                    [&](auto take) { bench.questions().probe({inBrain}, take); })
                ->front()
                .tolerance;
        };
        QVERIFY(toleranceInBrain());
        bench.questions().dropTolerance();
        QVERIFY(!toleranceInBrain());
    }

    void aCutIsRefusedAtOnceOrInItsAnswer()
    {
        const Bench bench({test::addSegment("Brain")});
        bool answered = false;
        const Result<void> asked = bench.questions().previewCut(
            ShrinkAt{}, [&answered](const Result<std::optional<CutPreview>>&) { answered = true; });
        QVERIFY(!asked && asked.error().code == ErrorCode::InvalidField);
        QVERIFY(bench.session->settle());
        QVERIFY(!answered);
        const ShrinkAt shrink{
            .pointsLps = {bench.study.volume.geometry.toWorld(glm::dvec3(inBrain))}};
        const auto foreseen = bench.answerTo<std::optional<CutPreview>>([&](auto take) {
            const Result<void> question = bench.questions().previewCut(shrink, take);
            QVERIFY(question);
        });
        QVERIFY(!foreseen && foreseen.error().code == ErrorCode::NothingGrown);
        bench.questions().dropCutPreview();
        QVERIFY(bench.session->settle());
    }

    void anOpenGrowthIsComparedWithItsBeginning()
    {
        const Bench bench({test::addSegment("Brain"), test::seedInBrain(1), test::growBrain()});
        const auto compare = [&](auto take) { bench.questions().compareGrowth(take); };
        const auto none = bench.answerTo<std::optional<GrowthComparison>>(compare);
        QVERIFY(!none && none.error().code == ErrorCode::InvalidField);
        const std::int64_t grown = bench.session->document().segment(1)->voxels;
        QVERIFY(grown > 0);

        ChangeInterval change; // to values that nothing has
        change.criteria.lower = 500.0;
        change.criteria.upper = 600.0;
        QVERIFY(bench.session->begin(change));
        bench.session->extend(GrowAdvance{});
        const auto compared = bench.answerTo<std::optional<GrowthComparison>>(compare);
        QVERIFY(compared && *compared);
        QCOMPARE((*compared)->suspended, grown);
        QCOMPARE((*compared)->reached, std::int64_t(0));
        QCOMPARE(bench.session->document().segment(1)->voxels, std::int64_t(0));
        QVERIFY(!bench.answerTo<std::optional<GrowthComparison>>(compare)); // it has ended
    }

    void answersComeBehindWhatWasAskedBefore()
    {
        const Bench bench;
        std::size_t rows = 0;
        QVERIFY(bench.session->apply(test::addSegment("Brain")));
        QVERIFY(bench.session->apply(test::seedInBrain(1)));
        bench.questions().afterAll([&] { rows = bench.session->history().rows().size(); });
        QVERIFY(bench.session->apply(test::growBrain(1)));
        QVERIFY(bench.session->settle());
        QCOMPARE(rows, std::size_t(2));
    }

    void whoClosesTheSessionHearsNothing()
    {
        Bench bench;
        int answers = 0;
        const auto count = [&answers] { ++answers; };
        bench.questions().afterAll(count); // it is with the engine, and the next one waits in line
        QVERIFY(bench.session->apply(test::addSegment("Brain")));
        QVERIFY(bench.session->apply(test::seedInBrain(1)));
        bench.questions().afterAll(count);
        bench.session.reset();
        QCOMPARE(answers, 0);
    }
};

BURIN_TEST(VoxelQuestionsTest)

} // namespace voxelQuestionsTest

#include "VoxelQuestionsTest.moc"
