// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditJson.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowFromSeeds.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/PlugLeak.h"
#include "core/edits/kinds/growth/ResumeGrowth.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/history/RevertRows.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/SurfaceBarrier.h"
#include "core/session/EditSession.h"
#include "core/session/past/RecentGrowth.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/cases/BoxedMasks.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/sessions/SessionBench.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <numeric>

namespace growthPlanesTest {

using namespace core;

namespace {

constexpr int below = 1; ///< the segment of the first plane
constexpr int above = 2; ///< that of the second one

/// Two small boxes in the brain that overlap, each in a plane of its own. @param only of them
ImportMask overlapping()
{
    const glm::ivec3 size = test::smallStudy().volume.geometry.size;
    const glm::ivec3 middle = size / 2;
    ImportMask mask =
        test::importOfBoxes({{middle - 2, middle + 1}, {middle - 1, middle + 2}}, size);
    mask.planes = std::vector<int>{0, 1};
    return mask;
}

GrowCriteria ofBrain(std::optional<int> plane)
{
    GrowCriteria criteria;
    criteria.lower = 0.0;
    criteria.upper = 100.0;
    criteria.plane = plane;
    return criteria;
}

Edit growth(std::optional<int> plane, std::optional<int> steps = {})
{
    return test::growBy(ofBrain(plane), steps);
}

/// Seeds in both segments.
struct Bench : test::SessionBench {
    explicit Bench(const QString& file = {})
        : SessionBench(false, test::smallStudy(), file)
    {
        run(overlapping());
        run(test::seedAt(below, {middle()}));
        run(test::seedAt(above, {middle()}));
    }
    [[nodiscard]] glm::dvec3 middle(double aside = 0.0) const
    {
        return geometry().toWorld(glm::dvec3(geometry().size / 2) + glm::dvec3(aside, 0.0, 0.0));
    }
    [[nodiscard]] std::uint32_t generation(int plane) const
    {
        return session->document().generation(plane);
    }
    [[nodiscard]] std::int64_t members(int plane) const
    {
        std::int64_t count = 0;
        session->questions().generationSizes(
            std::uint8_t(plane), [&](const Result<std::vector<std::uint32_t>>& sizes) {
                count = std::accumulate(sizes->begin(), sizes->end(), std::int64_t(0));
            });
        static_cast<void>(session->settle());
        return count;
    }
    void undo() const
    {
        QVERIFY(session->undo());
        QVERIFY(session->settle());
    }
};

} // namespace

/// Growths in several label planes, each with seeds, barriers and generations of its own.
class GrowthPlanesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void eachGrowsInItsPlane()
    {
        const Bench bench;
        const std::vector<std::uint8_t> first = bench.labels(0);
        const std::vector<std::uint8_t> second = bench.labels(1);
        const QByteArray before = bench.session->stateHash();
        bench.run(growth(1, 3));
        QCOMPARE(bench.labels(0), first);
        QVERIFY(bench.voxels(above, 1) > 27);
        QCOMPARE(bench.generation(0), 0u);
        QCOMPARE(bench.generation(1), 4u);
        QCOMPARE(bench.rows().back().growthGeneration, 4u);
        QCOMPARE(bench.members(0), std::int64_t(0));
        QVERIFY(bench.members(1) > 27);
        QVERIFY(bench.rows().back().name.startsWith(QStringLiteral("Grow 'S2' 3 steps")));
        const QByteArray after = bench.session->stateHash();
        bench.undo();
        QCOMPARE(bench.session->stateHash(), before);
        QCOMPARE(bench.labels(1), second);
        QCOMPARE(bench.generation(1), 0u);
        QVERIFY(bench.session->redo());
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.session->stateHash(), after);
        QCOMPARE(bench.generation(1), 4u);

        // Two that overlap grow through each other.
        bench.run(growth({}));
        bench.run(growth(1));
        std::vector<std::uint8_t> grown = bench.labels(0);
        std::replace(grown.begin(), grown.end(), std::uint8_t(below), std::uint8_t(above));
        QCOMPARE(bench.labels(1), grown);
    }

    /// What goes on with a growth goes on with the last one, or with that of the plane it names.
    void eachIsContinuedAndTakenBackByItself()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("a.burin"));
        std::vector<std::pair<std::uint32_t, std::uint32_t>> generations;
        std::vector<QByteArray> hashes;
        {
            const Bench bench(file);
            const auto then = [&](const Edit& edit, std::uint32_t first, std::uint32_t second) {
                bench.run(edit);
                QCOMPARE(bench.generation(0), first);
                QCOMPARE(bench.generation(1), second);
                generations.emplace_back(first, second);
                hashes.push_back(bench.session->stateHash());
            };
            then(growth({}, 4), 5, 0);
            then(growth(1, 2), 5, 3);
            then(ResumeGrowth{.steps = 1}, 5, 4);
            then(ResumeGrowth{.steps = 2, .plane = 0}, 7, 4);
            then(ShrinkSteps{.steps = 3}, 4, 4);
            then(ShrinkSteps{.steps = 1, .plane = 1}, 4, 3);
            ChangeInterval anew;
            anew.criteria = ofBrain(1);
            anew.criteria.upper = 50.0;
            anew.steps = 1;
            then(anew, 4, 4);
            QCOMPARE(bench.rows().back().edit.get<ChangeInterval>().criteria.plane, 1);
            then(ResumeGrowth{.steps = 1, .plane = 0}, 5, 4);
            QCOMPARE(bench.rows().back().edit.get<GrowSteps>().criteria.upper, 100.0);
            then(test::paintAt(below, {bench.middle(6.0)}, 1.0), 5, 4);
            QCOMPARE(recentCriteria(bench.session->history(), 0)->upper, 100.0);
            QCOMPARE(recentCriteria(bench.session->history(), 1)->upper, 50.0);
            QVERIFY(!recentCriteria(bench.session->history(), 2));
        }
        reference::ReferenceEngine engine;
        const auto opened = *EditSession::open(engine, test::smallStudy(), file);
        const auto rows = RowId(opened->history().rows().size());
        for (RowId row = rows; row > rows - RowId(hashes.size()); --row) {
            QVERIFY(opened->goTo(row));
            QVERIFY(opened->settle());
            const std::size_t place = hashes.size() - 1 - std::size_t(rows - row);
            QCOMPARE(opened->stateHash(), hashes[place]);
            QCOMPARE(opened->document().generation(0), generations[place].first);
            QCOMPARE(opened->document().generation(1), generations[place].second);
        }
        // Carried out anew from their text, they come to the same.
        const Bench replayed;
        for (RowId row = rows - RowId(hashes.size()) + 1; row <= rows; ++row)
            replayed.run(*editFromJson(editToJson(opened->history().row(row).edit)));
        QCOMPARE(replayed.session->stateHash(), hashes.back());
    }

    /// A barrier keeps out the growth of its own plane.
    void barriersKeepOutTheirPlane()
    {
        const auto grownWith = [](std::optional<int> barred) {
            const Bench bench;
            BarrierStroke wall{.plane = barred};
            wall.path = {.radiusMm = 2.0, .pointsLps = {bench.middle(5.0)}};
            bench.run(wall);
            bench.run(growth({}));
            bench.run(growth(1));
            return std::pair(bench.voxels(below, 0), bench.voxels(above, 1));
        };
        const auto [openFirst, shutSecond] = grownWith(1);
        const auto [shutFirst, openSecond] = grownWith({});
        QCOMPARE(shutFirst, shutSecond);
        QCOMPARE(openFirst, openSecond);
        QVERIFY(shutFirst < openFirst);
    }

    void aSurfaceShutsThePlaneOfItsSegment()
    {
        const Bench bench;
        bench.run(LaySurface{.segment = above});
        bench.run(SurfaceBarrier());
        bench.run(growth({}));
        bench.run(growth(1));
        QCOMPARE(bench.voxels(above, 1), std::int64_t(27));
        QVERIFY(bench.voxels(below, 0) > 1000);
    }

    void shrinkingAtAPlaceTakesFromItsPlane()
    {
        const Bench bench;
        bench.run(growth({}));
        bench.run(growth(1));
        const std::vector<std::uint8_t> first = bench.labels(0);
        const std::int64_t second = bench.voxels(above, 1);
        bench.run(ShrinkAt{.pointsLps = {bench.middle(8.0)}, .onlyHere = true, .plane = 1});
        QCOMPARE(bench.voxels(above, 1), second - 1);
        bench.run(ShrinkAt{.pointsLps = {bench.middle(-8.0)}, .steps = 2, .plane = 1});
        QVERIFY(bench.voxels(above, 1) < second - 1);
        QCOMPARE(bench.labels(0), first);
    }

    void seedsCompeteWithinAPlane()
    {
        const Bench bench;
        bench.run(test::addSegment("Other"));
        QVERIFY(bench.tried(GrowFromSeeds{.plane = 1}).contains(QStringLiteral("at least two")));
        GrowFromSeeds mixed;
        mixed.segments = std::vector<int>{below, above};
        QVERIFY(bench.tried(mixed).contains(QStringLiteral("'S2' lies on label plane 2")));
        mixed.plane = 1;
        QVERIFY(bench.tried(mixed).contains(QStringLiteral("'S1' lies on label plane 1")));
    }

    /// "Undo only" takes back what is of one growth; what the other did stays.
    void undoOnlyKnowsThePlanes()
    {
        const Bench bench;
        bench.run(growth({}, 3));
        const RowId ofFirst = bench.session->history().position();
        bench.run(growth(1, 4));
        const RowId ofSecond = bench.session->history().position();
        bench.run(growth({}, 1));
        const std::vector<std::uint8_t> first = bench.labels(0);
        QVERIFY(bench.tried(RevertRows{{ofFirst}}).contains(QStringLiteral("the same place")));
        QVERIFY(bench.tried(RevertRows{{ofSecond, bench.session->history().position()}})
                    .contains(QStringLiteral("several label planes")));
        bench.run(RevertRows{{ofSecond}});
        QCOMPARE(bench.labels(0), first);
        QCOMPARE(bench.voxels(above, 1), std::int64_t(27));
        QCOMPARE(bench.generation(0), 5u);
        QCOMPARE(bench.generation(1), 5u); // as in the first plane, the counter stays
        QCOMPARE(bench.rows().back().growthGeneration, 5u);
        QCOMPARE(bench.members(1), std::int64_t(0));
        const QByteArray hash = bench.session->stateHash();
        bench.undo();
        QVERIFY(bench.session->redo());
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.session->stateHash(), hash);
        bench.run(growth(1, 1));
        QCOMPARE(bench.generation(1), 7u);
    }

    void whatHasNoPlaneIsRefused()
    {
        const Bench bench;
        const QByteArray before = bench.session->stateHash();
        const QString none = QStringLiteral("no segment lies on label plane 3");
        QVERIFY(bench.tried(growth(2)).contains(none));
        QVERIFY(bench.tried(ShrinkSteps{.plane = 2}).contains(none));
        QVERIFY(bench.tried(ShrinkAt{.pointsLps = {bench.middle()}, .plane = 2}).contains(none));
        QVERIFY(bench.tried(PlugLeak{.pointLps = bench.middle(), .plane = 2}).contains(none));
        QVERIFY(bench.tried(GrowFromSeeds{.plane = 2}).contains(none));
        BarrierStroke wall{.plane = 2};
        wall.path = {.radiusMm = 2.0, .pointsLps = {bench.middle()}};
        QVERIFY(bench.tried(wall).contains(none));
        QVERIFY(bench.tried(ResumeGrowth{.plane = 1})
                    .contains(QStringLiteral("nothing has grown on label plane 2")));
        GrowCriteria other = ofBrain({});
        other.segments = std::vector<int>{above};
        QVERIFY(
            bench.tried(test::growBy(other))
                .contains(QStringLiteral("'S2' lies on label plane 2; field 'plane' must be 1")));
        for (const char* wrong : {"{\"edit\":\"shrink\",\"steps\":1,\"plane\":4}",
                 "{\"edit\":\"shrink\",\"steps\":1,\"plane\":-1}",
                 "{\"edit\":\"shrink\",\"steps\":1,\"plane\":\"1\"}"})
            QVERIFY2(!editFromJson(QJsonDocument::fromJson(wrong).object()), wrong);
        QCOMPARE(bench.session->stateHash(), before);
    }

    /// The first plane is not named: text and hashes of growths there are what they were.
    void theFirstPlaneIsNotNamed()
    {
        for (const Edit& edit : {growth({}, 2), Edit(ShrinkSteps{.steps = 1}),
                 Edit(ResumeGrowth{.steps = 1}), Edit(BarrierStroke())})
            QVERIFY(!editToJson(edit).contains(QStringLiteral("plane")));
        QCOMPARE(editToJson(growth(1, 2)).value(QStringLiteral("plane")).toInt(), 1);
        Document document = initialDocument(test::smallStudy().volume);
        const QJsonObject before = document.hashedState();
        document.place({.plane = 1, .generation = 0});
        QCOMPARE(document.hashedState(), before);
        document.place({.plane = 1, .generation = 3});
        QVERIFY(document.hashedState() != before);
    }
};

BURIN_TEST(GrowthPlanesTest)

} // namespace growthPlanesTest

#include "GrowthPlanesTest.moc"
