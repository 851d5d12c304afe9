// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/SketchedSeeds.h"
#include "core/session/StepFindings.h"

#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/session/EditSession.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/growth/LeakPhantoms.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTest>

namespace sketchedSeedsTest {

using namespace core;

namespace {

/// A session in memory on a bar of one value, with segments 1 and 2, 'A' and 'B'.
class Bench {
public:
    Bench()
    {
        test::LeakPhantom phantom;
        phantom.codes = test::constantVolume({40, 6, 5}, 0);
        LoadedVolume bar = test::loadedVolume(phantom);
        m_geometry = bar.volume.geometry;
        session = *EditSession::create(engine, std::move(bar), {});
        run(test::addSegment("A"));
        run(test::addSegment("B"));
    }
    void run(const Edit& edit)
    {
        const Result<void> applied = session->apply(edit);
        QVERIFY2(applied, qPrintable(applied ? QString() : applied.error().arguments.join(u' ')));
        QVERIFY(session->settle());
    }
    /// Along the bar.
    [[nodiscard]] SeedStroke seeds(int segment, int from, int to) const
    {
        SeedStroke stroke{segment, {}};
        for (int x = from; x <= to; ++x)
            stroke.pointsLps.push_back(place(x));
        return stroke;
    }
    [[nodiscard]] glm::dvec3 place(int x) const { return m_geometry.toWorld({x, 3, 2}); }
    /// Each seed and its neighbours.
    void grow() { run(test::growBetween(0.0, 10.0, 1)); }
    [[nodiscard]] std::size_t rows() const { return session->history().rows().size(); }
    [[nodiscard]] QString lastName() const { return session->history().rows().back().name; }
    [[nodiscard]] QString why() const
    {
        return canonicalName(
            whyNotTaken(*session->findings().sketchedSeeds(), session->document()));
    }

    reference::ReferenceEngine engine; ///< outlives the session
    std::unique_ptr<EditSession> session;

private:
    VolumeGeometry m_geometry;
};

} // namespace

/// Seeds that do not become any are told, and why.
class SketchedSeedsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void onFreeVoxelsAllAreTaken()
    {
        Bench bench;
        QVERIFY(!bench.session->findings().sketchedSeeds());
        bench.run(bench.seeds(1, 5, 9));
        QCOMPARE(bench.lastName(), QStringLiteral("Seed stroke for 'A', 5 voxels"));
        QCOMPARE(bench.session->findings().sketchedSeeds()->taken, std::int64_t(5));
        QCOMPARE(bench.why(), QString());
    }

    void whatHasGrownIsNotTaken()
    {
        Bench bench;
        bench.run(bench.seeds(1, 5, 5));
        bench.grow(); // 4, 5 and 6 along the bar
        bench.run(bench.seeds(1, 5, 9));
        QCOMPARE(bench.lastName(),
            QStringLiteral("Seed stroke for 'A', 3 of 5 voxels (2 belong to 'A' already)"));
        bench.run(bench.seeds(2, 6, 10)); // 7, 8 and 9 are seeds of a segment that comes first
        QCOMPARE(bench.lastName(),
            QStringLiteral("Seed stroke for 'B', 1 of 5 voxels (1 belongs to 'A'; 3 are seeds of "
                           "'A')"));
    }

    void withoutASeedThereIsNoRowButAReason()
    {
        Bench bench;
        bench.run(bench.seeds(1, 5, 5));
        bench.grow();
        const std::size_t rows = bench.rows();
        const QByteArray before = bench.session->stateHash();
        bench.run(bench.seeds(2, 4, 6));
        QCOMPARE(bench.rows(), rows);
        QCOMPARE(bench.session->stateHash(), before);
        QCOMPARE(bench.why(), QStringLiteral("3 belong to 'A'"));
        QCOMPARE(canonicalName(sketchedTitle(
                     *bench.session->findings().sketchedSeeds(), bench.session->document())),
            QStringLiteral("0 of 3 voxels (3 belong to 'A')"));
        // The next one does not repeat it.
        bench.run(bench.seeds(2, 20, 20));
        QCOMPARE(bench.why(), QString());
        QCOMPARE(bench.lastName(), QStringLiteral("Seed stroke for 'B', 1 voxel"));
        // Nor is what waits already set again.
        bench.run(bench.seeds(2, 20, 20));
        QCOMPARE(bench.rows(), rows + 1);
        QCOMPARE(bench.why(), QStringLiteral("1 is a seed already"));
    }

    void barriersAndSeedsOfOthers()
    {
        Bench bench;
        BarrierStroke barrier;
        barrier.path.radiusMm = 0.4;
        barrier.path.pointsLps = {bench.place(10)};
        bench.run(barrier);
        bench.run(bench.seeds(2, 9, 9));
        bench.run(bench.seeds(1, 9, 11));
        QCOMPARE(bench.lastName(),
            QStringLiteral("Seed stroke for 'A', 2 of 3 voxels (1 is shut by a barrier; 1 was a "
                           "seed of 'B')"));
        const SketchedSeeds& seeds = *bench.session->findings().sketchedSeeds();
        QCOMPARE(seeds.replaced.at(2), std::int64_t(1));
        QCOMPARE(seeds.barriers, std::int64_t(1));
    }

    void aSeedThatIsMovedIntoAGrowthIsTold()
    {
        Bench bench;
        bench.run(bench.seeds(1, 5, 5));
        bench.grow();
        bench.run(bench.seeds(2, 20, 20));
        SeedStroke move = bench.seeds(2, 25, 25);
        move.takenLps = {{bench.place(20)}};
        bench.run(move);
        QCOMPARE(bench.lastName(), QStringLiteral("Move 1 seed of 'B'"));
        move = bench.seeds(2, 5, 5);
        move.takenLps = {{bench.place(25)}};
        bench.run(move);
        QCOMPARE(bench.lastName(),
            QStringLiteral("Move 1 seed of 'B', 0 of 1 voxel (1 belongs to 'A')"));
    }

    /// Edits that follow each other at once are told apart.
    void strokesInALineAreToldEachByItself()
    {
        Bench bench;
        bench.run(bench.seeds(1, 5, 5));
        bench.grow();
        QVERIFY(bench.session->apply(bench.seeds(2, 6, 7)));
        QVERIFY(bench.session->apply(bench.seeds(2, 7, 8)));
        QVERIFY(bench.session->settle());
        const auto& rows = bench.session->history().rows();
        QCOMPARE(rows[rows.size() - 2].name,
            QStringLiteral("Seed stroke for 'B', 1 of 2 voxels (1 belongs to 'A')"));
        QCOMPARE(rows.back().name,
            QStringLiteral("Seed stroke for 'B', 1 of 2 voxels (1 is a seed already)"));
    }
};

BURIN_TEST(SketchedSeedsTest)

} // namespace sketchedSeedsTest

#include "SketchedSeedsTest.moc"
