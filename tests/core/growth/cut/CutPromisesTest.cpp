// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/growth/CutPromises.h"
#include "core/growth/cut/GrowthCut.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/EngineConformance.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <array>

namespace cutPromisesTest {

using namespace core;
using test::Random;
using test::randomInt;
using test::Words;

namespace {

glm::ivec3 randomSize(Random& random)
{
    return {randomInt(random, 6, 24), randomInt(random, 6, 24), randomInt(random, 5, 18)};
}

test::Codes randomShape(const glm::ivec3& size, Random& random)
{
    switch (random() % 5) {
    case 0:
        return test::constantVolume(size, test::tissueCode);
    case 1:
        return test::noiseVolume(size, test::tissueCode, random);
    case 2:
        return test::spiralCorridor(size);
    case 3:
        return test::shells(size);
    default:
        return test::balls(size, 7, random);
    }
}

/// Growths of up to three labels in several bursts, with what shrinking, locks, masks that were
/// there and other cuts make of them.
class RandomGrowth {
public:
    explicit RandomGrowth(int number)
        : m_random(std::uint32_t(number))
        , m_size(randomSize(m_random))
    {
        if (!m_engine.openVolume(m_size, randomShape(m_size, m_random).values))
            qFatal("the volume is not opened");
        if (m_random() % 4 == 0)
            m_engine.submit(SwapBricks{
                test::bricksOf(test::labelBoxes(m_size, 4, m_random), Field::Labels, 0)});
        for (int burst = randomInt(m_random, 1, 3); burst > 0; --burst)
            grow();
    }

    [[nodiscard]] Random& random() { return m_random; }
    [[nodiscard]] std::uint32_t generation() const { return m_generation; }
    EngineResult apply(const EngineEdit& edit, std::vector<EngineExtension> extensions = {})
    {
        submitWhole(m_engine, edit, std::move(extensions));
        const EngineResult result = test::lastResult(m_engine);
        if (!result.error)
            m_generation = result.generation;
        return result;
    }
    /// Whether the edit is refused where it begins.
    std::optional<Error> refusal(const EngineEdit& edit)
    {
        m_engine.submit(BeginEdit{edit});
        const EngineResult result = test::lastResult(m_engine);
        m_engine.submit(EndEdit{Ending::Rollback});
        (void)test::lastResult(m_engine);
        return result.error;
    }
    void swap(const EngineResult& done, bool back)
    {
        SwapBricks bricks;
        for (const BrickChange& change : done.changes)
            bricks.bricks.push_back({change.key, back ? change.before : change.after});
        m_engine.submit(bricks);
        (void)test::lastResult(m_engine);
    }
    [[nodiscard]] WordBricks wordBricks()
    {
        const BrickGrid grid{m_size};
        WordBricks words(grid, std::size_t(grid.brickCount()));
        for (const BrickChange& brick : bricks()) {
            if (!brick.after.empty())
                words.add(brick.key.brick, brick.after.read());
        }
        words.link();
        return words;
    }
    [[nodiscard]] Words words() { return test::seedWordsOf(m_engine, m_size); }

private:
    void grow()
    {
        for (int label = randomInt(m_random, 1, 3); label > 0; --label) {
            SeedPlacement seeds{.label = std::uint8_t(label)};
            for (int i = randomInt(m_random, 1, 3); i > 0; --i)
                seeds.voxels.push_back(test::randomVoxel(m_random, m_size));
            apply(seeds);
        }
        GrowBurst burst{.lowCode = randomInt(m_random, 0, 400),
            .highCode = randomInt(m_random, 800, int(test::tissueCode)),
            .connectivity = std::array<int, 4>{6, 6, 18, 26}[m_random() % 4],
            .generation = m_generation};
        if (m_random() % 3 == 0)
            burst.lowCode = 0;
        if (m_random() % 4 == 0)
            burst.limits.difference = randomInt(m_random, 100, 600);
        if (m_random() % 4 == 0)
            burst.limits.majority = randomInt(m_random, 1, 14);
        if (m_random() % 4 == 0)
            burst.overwritable.set(1).set(2).set(3).set(4);
        const bool some = m_random() % 3 == 0;
        apply(burst,
            {GrowAdvance{.steps = some ? randomInt(m_random, 1, 8) : GrowAdvance::toClosure}});
        if (m_random() % 4 == 0)
            apply(ShrinkGrowth{.generation = m_generation,
                .keep = m_generation / 2,
                .keepSeeds = m_random() % 2 == 0});
        if (m_random() % 4 == 0) {
            CutGrowth cut{.how = m_random() % 2 ? CutGrowth::How::Here : CutGrowth::How::Subtree,
                .barrier = m_random() % 2 == 0,
                .generation = m_generation};
            cut.voxels = test::strokeOverMembers(words(), randomInt(m_random, 1, 12), m_random);
            apply(cut);
        }
    }
    [[nodiscard]] std::vector<BrickChange> bricks()
    {
        ReadBricks read;
        for (int brick = 0; brick < BrickGrid{m_size}.brickCount(); ++brick)
            read.keys.push_back({Field::SeedWords, 0, std::uint32_t(brick)});
        m_engine.submit(read);
        return test::lastResult(m_engine).changes;
    }

    Random m_random;
    glm::ivec3 m_size;
    reference::ReferenceEngine m_engine;
    std::uint32_t m_generation = 0;
};

CutGrowth randomCut(RandomGrowth& growth, const Words& words, CutGrowth::How how)
{
    Random& random = growth.random();
    CutGrowth cut{.how = how,
        .barrier = random() % 2 == 0,
        .connectivity = std::array<int, 4>{26, 26, 18, 6}[random() % 4],
        .generation = growth.generation()};
    cut.voxels = test::strokeOverMembers(words, randomInt(random, 1, 40), random);
    if (random() % 4 == 0)
        cut.voxels.push_back(test::randomVoxel(random, words.size));
    if (random() % 6 == 0)
        cut.lockedLabels.set(std::size_t(randomInt(random, 1, 3)));
    if (how == CutGrowth::How::Backwards)
        cut.steps = std::uint32_t(randomInt(random, 1, 12));
    return cut;
}

} // namespace

/// A sketch in random growths: what GrowthCut.h promises holds, the oracle agrees word for word,
/// and undo and redo bring back what was.
class CutPromisesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void promisesAreKept()
    {
        const int growths = qEnvironmentVariableIsSet("BURIN_LONG") ? 1200 : 120;
        int cuts = 0;
        int refused = 0;
        int more = 0; // than the sketch
        int everything = 0;
        using How = CutGrowth::How;
        for (int number = 0; number < growths; ++number) {
            RandomGrowth growth(number);
            for (const How how : {How::Subtree, How::Neck, How::Here, How::Subtree, How::Backwards,
                     How::Backwards}) {
                const Words before = growth.words();
                const CutGrowth cut = randomCut(growth, before, how);
                const QByteArray which = "growth " + QByteArray::number(number) + ", how "
                    + QByteArray::number(int(how)) + ": ";
                const test::Sketched sketched = test::sketchedMembers(before, cut);
                const auto outcome = cutGrowth(growth.wordBricks(), cut);
                if (sketched.roots > 0 || sketched.members == 0) {
                    ++refused;
                    const ErrorCode why =
                        sketched.roots > 0 ? ErrorCode::SeedsStay : ErrorCode::NothingGrown;
                    QVERIFY2(!outcome && outcome.error().code == why, which.constData());
                    const std::optional<Error> refusal = growth.refusal(cut);
                    QVERIFY2(refusal && refusal->code == why
                            && refusal->arguments == outcome.error().arguments,
                        which.constData());
                    QVERIFY2(growth.words().values == before.values, which.constData());
                    continue;
                }
                if (!outcome && outcome.error().code == ErrorCode::EverythingGrown) {
                    ++everything;
                    const std::optional<Error> refusal = growth.refusal(cut);
                    QVERIFY2(how == How::Backwards && refusal
                            && refusal->code == ErrorCode::EverythingGrown,
                        which.constData());
                    QVERIFY2(growth.words().values == before.values, which.constData());
                    continue;
                }
                ++cuts;
                QVERIFY2(outcome, which.constData());
                Words after = before;
                for (const CutBrick& brick : outcome->bricks)
                    test::putBrick(after, brick.brick, brick.words);
                const QString broken = test::brokenPromise(before, after, cut);
                QVERIFY2(broken.isEmpty(), (which + broken.toUtf8()).constData());

                const EngineResult done = growth.apply(cut);
                QVERIFY2(growth.words().values == after.values, which.constData());
                QCOMPARE(done.generation, outcome->generation);
                more += done.statistics.voxelsChanged > sketched.members ? 1 : 0;
                growth.swap(done, true);
                QVERIFY2(growth.words().values == before.values, which.constData());
                growth.swap(done, false);
                QVERIFY2(growth.words().values == after.values, which.constData());
            }
        }
        qInfo("%d cuts (%d took more than the sketch), %d refused, %d more would have taken all",
            cuts, more, refused, everything);
        QVERIFY(everything > 0);
        QVERIFY(cuts > growths && more * 10 > cuts && refused * 20 > cuts);
    }
};

BURIN_TEST(CutPromisesTest)

} // namespace cutPromisesTest

#include "CutPromisesTest.moc"
