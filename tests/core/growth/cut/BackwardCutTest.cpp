// SPDX-License-Identifier: Apache-2.0
#include "core/growth/cut/BackwardCut.h"

#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/EngineConformance.h"
#include "tests/support/cases/growth/BackwardScenes.h"
#include "tests/support/cases/growth/CutPromises.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <algorithm>
#include <set>

namespace backwardCutTest {

using namespace core;
using test::Words;
using Bound = BackwardProgress::Bound;

namespace {

/// A scene that has grown.
class Grown {
public:
    explicit Grown(const test::BackwardScene& scene, int connectivity = 6)
        : m_size(scene.codes.size)
    {
        if (!m_engine.openVolume(m_size, scene.codes.values))
            qFatal("the volume is not opened");
        apply(SeedPlacement{.label = 1, .voxels = scene.seeds});
        if (!scene.others.empty())
            apply(SeedPlacement{.label = 2, .voxels = scene.others});
        const EngineResult grown = apply(GrowBurst{.lowCode = test::tissueCode,
                                             .highCode = test::tissueCode,
                                             .connectivity = connectivity},
            {GrowAdvance{}});
        m_cut = {.how = CutGrowth::How::Backwards,
            .generation = grown.generation,
            .voxels = scene.sketch};
        m_words = test::seedWordsOf(m_engine, m_size);
    }

    [[nodiscard]] const Words& words() const { return m_words; }
    [[nodiscard]] CutGrowth cut(std::uint32_t steps) const
    {
        CutGrowth cut = m_cut;
        cut.steps = steps;
        return cut;
    }
    [[nodiscard]] WordBricks bricks()
    {
        const BrickGrid grid{m_size};
        ReadBricks read;
        for (int brick = 0; brick < grid.brickCount(); ++brick)
            read.keys.push_back({Field::SeedWords, 0, std::uint32_t(brick)});
        m_engine.submit(read);
        WordBricks bricks(grid, std::size_t(grid.brickCount()));
        for (const BrickChange& brick : test::lastResult(m_engine).changes) {
            if (!brick.after.empty())
                bricks.add(brick.key.brick, brick.after.read());
        }
        bricks.link();
        return bricks;
    }
    /// What stands in the words after a cut.
    [[nodiscard]] Words after(const GrowthCutOutcome& outcome) const
    {
        Words after = m_words;
        for (const CutBrick& brick : outcome.bricks)
            test::putBrick(after, brick.brick, brick.words);
        return after;
    }
    /// The members that a cut takes.
    [[nodiscard]] std::set<std::size_t> gone(const Words& after) const
    {
        std::set<std::size_t> gone;
        for (std::size_t voxel = 0; voxel < m_words.values.size(); ++voxel) {
            if (seedWord::isMember(m_words.values[voxel])
                && !seedWord::isMember(after.values[voxel]))
                gone.insert(voxel);
        }
        return gone;
    }
    /// How many members each number of steps takes, up to where they end.
    [[nodiscard]] std::vector<std::size_t> taken(Bound& bound)
    {
        const WordBricks words = bricks();
        const auto open = BackwardCut::begin(words, m_cut);
        std::vector<std::size_t> taken;
        if (!open)
            return taken;
        for (std::uint32_t steps = 1; steps < 1000; ++steps) {
            (*open)->advanceTo(steps);
            if ((*open)->progress().steps < steps)
                break;
            taken.push_back(gone(after((*open)->outcome())).size());
        }
        bound = (*open)->progress().bound;
        return taken;
    }
    [[nodiscard]] Words now() { return test::seedWordsOf(m_engine, m_size); }
    EngineResult apply(const EngineEdit& edit, std::vector<EngineExtension> extensions = {})
    {
        submitWhole(m_engine, edit, std::move(extensions));
        return test::lastResult(m_engine);
    }

private:
    reference::ReferenceEngine m_engine;
    glm::ivec3 m_size;
    Words m_words;
    CutGrowth m_cut;
};

using Taken = std::vector<std::size_t>;

} // namespace

/// Cuts backwards (GrowthCut.h, rule 12): known answers on shapes, and what holds on each.
class BackwardCutTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void firstWhatDescendsThenParents()
    {
        Bound bound = Bound::None;
        // 12 … 15, then one after the other, to the half-way at 6.
        QCOMPARE(Grown(test::lineScene()).taken(bound), (Taken{4, 5, 6, 7, 8, 9, 10}));
        QCOMPARE(bound, Bound::Seeds);
    }

    /// Of two arms that meet only that of the sketch goes, with the voxel where they meet.
    void aRingGoesOnOneSide()
    {
        Bound bound = Bound::None;
        Grown ring(test::ringScene());
        QCOMPARE(ring.taken(bound), (Taken{7, 8, 9, 10, 11, 12}));
        QCOMPARE(bound, Bound::Seeds);
        const Words after = ring.after(*cutGrowth(ring.bricks(), ring.cut(6)));
        QVERIFY(
            !seedWord::isMember(after.at({4, 8, 0})) && !seedWord::isMember(after.at({8, 1, 0})));
        QVERIFY(seedWord::isMember(after.at({3, 8, 0})) && seedWord::isMember(after.at({8, 0, 0})));
    }

    /// The other arm goes with the parent that it has in common with the sketch, not before.
    void aForkLosesItsOtherArmWithTheParent()
    {
        Bound bound = Bound::None;
        QCOMPARE(Grown(test::forkScene()).taken(bound), (Taken{4, 5, 6, 7, 15, 16}));
        QCOMPARE(bound, Bound::Seeds);
    }

    /// What came from the other seed stays, and what is as near to a seed as to the sketch goes.
    void ofTwoSeedsTheOtherKeepsItsOwn()
    {
        Bound bound = Bound::None;
        QCOMPARE(Grown(test::twoSeedsScene()).taken(bound), (Taken{3, 4, 5}));
        QCOMPARE(bound, Bound::Seeds);
    }

    void whatWouldTakeEverythingOrNothingIsRefused()
    {
        test::BackwardScene scene = test::lineScene();
        scene.sketch = {{1, 0, 0}};
        Grown beside(scene);
        const auto all = cutGrowth(beside.bricks(), beside.cut(1));
        QVERIFY(!all && all.error().code == ErrorCode::EverythingGrown);
        QVERIFY(!leavingVoxels(beside.bricks(), beside.cut(1)));

        // Two steps would take everything: an open cut stays at one, a whole one is refused.
        scene.sketch = {{2, 0, 0}};
        Grown near(scene);
        Bound bound = Bound::None;
        QCOMPARE(near.taken(bound), (Taken{14}));
        QCOMPARE(bound, Bound::Everything);
        QVERIFY(cutGrowth(near.bricks(), near.cut(1)));
        for (const std::uint32_t steps : {2u, 50u}) {
            const auto refused = cutGrowth(near.bricks(), near.cut(steps));
            QVERIFY(!refused && refused.error().code == ErrorCode::EverythingGrown);
        }

        scene.sketch = {{0, 0, 0}, {9, 0, 0}};
        Grown seeds(scene);
        QCOMPARE(cutGrowth(seeds.bricks(), seeds.cut(1)).error().code, ErrorCode::SeedsStay);
        scene.sketch = {};
        Grown nothing(scene);
        QCOMPARE(cutGrowth(nothing.bricks(), nothing.cut(1)).error().code, ErrorCode::NothingGrown);
    }

    /// On every shape each step takes what the one before took, an open cut stands where a whole
    /// one with as many steps does, and the oracle says the same, word for word.
    void eachStepTakesMore_data()
    {
        QTest::addColumn<int>("connectivity");
        for (const int connectivity : {6, 18, 26})
            QTest::addRow("%d neighbours", connectivity) << connectivity;
    }
    void eachStepTakesMore()
    {
        QFETCH(int, connectivity);
        for (const test::BackwardScene& scene : test::backwardScenes()) {
            Grown grown(scene, connectivity);
            const WordBricks bricks = grown.bricks();
            const auto open = BackwardCut::begin(bricks, grown.cut(1));
            QVERIFY2(open, scene.name.constData());
            std::set<std::size_t> before;
            std::uint32_t steps = 1;
            for (; steps < 40; ++steps) {
                (*open)->advanceTo(steps);
                if ((*open)->progress().steps < steps)
                    break;
                const GrowthCutOutcome stands = (*open)->outcome();
                const Words after = grown.after(stands);
                const auto whole = cutGrowth(bricks, grown.cut(steps));
                QVERIFY2(whole && grown.after(*whole).values == after.values
                        && whole->generation == stands.generation,
                    scene.name.constData());
                const QString broken = test::brokenPromise(grown.words(), after, grown.cut(steps));
                QVERIFY2(broken.isEmpty(), (scene.name + ": " + broken.toUtf8()).constData());
                const std::set<std::size_t> gone = grown.gone(after);
                QVERIFY(std::includes(gone.begin(), gone.end(), before.begin(), before.end()));
                QVERIFY2(steps == 1 || (*open)->progress().members >= std::int64_t(before.size()),
                    scene.name.constData());
                before = gone;

                if (steps > 3 && steps % 4 != 0)
                    continue; // the oracle takes its time
                Grown oracle(scene, connectivity);
                const EngineResult done = oracle.apply(oracle.cut(steps));
                QVERIFY2(!done.error, scene.name.constData());
                QCOMPARE(done.generation, stands.generation);
                QCOMPARE(done.statistics.generations, int(steps));
                QVERIFY2(oracle.now().values == after.values, scene.name.constData());
            }
            QVERIFY2(steps > 3 && steps < 40, scene.name.constData());
            // What ends before the seeds takes no more with more steps.
            const auto more = cutGrowth(bricks, grown.cut(steps + 20));
            if ((*open)->progress().bound == Bound::Seeds)
                QVERIFY(more && grown.gone(grown.after(*more)) == before);
            else
                QVERIFY(!more && more.error().code == ErrorCode::EverythingGrown);
        }
    }
};

BURIN_TEST(BackwardCutTest)

} // namespace backwardCutTest

#include "BackwardCutTest.moc"
