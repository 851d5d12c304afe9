// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/PlainMasks.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/sessions/SessionBench.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <optional>
#include <random>

namespace cleanSegmentTest {

using namespace core;

namespace {

using test::smallGrid;

std::size_t at(int x, int y, int z)
{
    return (std::size_t(z) * std::size_t(smallGrid().size.y) + std::size_t(y))
        * std::size_t(smallGrid().size.x)
        + std::size_t(x);
}

/// A block of 8³ with a hole of 2³ and one of a single voxel, an island of 3³ and a speck.
struct Bench : test::SessionBench {
    Bench(bool delayed, const Edit& matter)
        : SessionBench(delayed)
    {
        run(matter);
    }
    explicit Bench(bool delayed = false)
        : Bench(delayed, parts())
    {
    }
    [[nodiscard]] static Edit parts()
    {
        std::vector<bool> mask(smallGrid().voxelCount(), false);
        const auto set = [&](const glm::ivec3& from, int side, bool in) {
            for (int z = 0; z < side; ++z) {
                for (int y = 0; y < side; ++y) {
                    for (int x = 0; x < side; ++x)
                        mask[at(from.x + x, from.y + y, from.z + z)] = in;
                }
            }
        };
        set({5, 5, 5}, 8, true);
        set({7, 7, 7}, 2, false);
        set({10, 10, 10}, 1, false);
        set({18, 18, 18}, 3, true);
        set({24, 6, 6}, 1, true);
        VoxelRuns runs;
        for (std::size_t voxel = 0; voxel < mask.size(); ++voxel) {
            if (mask[voxel])
                runs.append(voxel, 1);
        }
        return test::maskImport(
            QStringLiteral("parts.nii"), smallGrid().size, {{QStringLiteral("Parts"), runs}});
    }
};

constexpr std::int64_t all = 512 - 8 - 1 + 27 + 1;

glm::dvec3 placeOf(const glm::ivec3& voxel)
{
    return smallGrid().toWorld(glm::dvec3(voxel));
}

/// Three segments that lie about at random, each voxel at most one's.
Edit randomMatter(std::mt19937& random, std::uint32_t percent)
{
    std::array<VoxelRuns, 3> runs;
    for (std::size_t voxel = 0; voxel < smallGrid().voxelCount(); ++voxel) {
        const std::uint32_t dice = std::uint32_t(random()) % 100;
        if (dice < 3 * percent)
            runs.at(dice / percent).append(voxel, 1);
    }
    return test::matterImport(smallGrid().size, runs);
}

/// The island of a voxel: grown by whole sweeps over the volume until one adds nothing.
std::vector<bool> islandAround(const std::vector<std::uint8_t>& labels, std::size_t clicked)
{
    const glm::ivec3& size = smallGrid().size;
    std::vector<bool> island(labels.size(), false);
    island[clicked] = true;
    for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t voxel = 0; voxel < labels.size(); ++voxel) {
            if (island[voxel] || labels[voxel] != labels[clicked])
                continue;
            const glm::ivec3 place(int(voxel % std::size_t(size.x)),
                int(voxel / std::size_t(size.x)) % size.y,
                int(voxel / std::size_t(size.x)) / size.y);
            const glm::ivec3 from = glm::max(place - 1, glm::ivec3(0));
            const glm::ivec3 to = glm::min(place + 1, size - 1);
            bool touches = false;
            for (int z = from.z; z <= to.z; ++z) {
                for (int y = from.y; y <= to.y; ++y) {
                    for (int x = from.x; x <= to.x; ++x)
                        touches = touches || island[at(x, y, z)];
                }
            }
            island[voxel] = touches;
            grows = grows || touches;
        }
    }
    return island;
}

double voxelMm3()
{
    const glm::dvec3 spacing = smallGrid().spacingMm();
    return spacing.x * spacing.y * spacing.z;
}

} // namespace

class CleanSegmentTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void eachRuleIsARowThatComesBack_data()
    {
        QTest::addColumn<CleanSegment>("edit");
        QTest::addColumn<qint64>("left");
        QTest::addColumn<QString>("name");
        const double one = voxelMm3();
        QTest::newRow("all holes") << CleanSegment{.segment = 1} << qint64(all + 9)
                                   << QStringLiteral("Fill holes of 'Parts'");
        QTest::newRow("small holes") << CleanSegment{.segment = 1, .mm3 = one} << qint64(all + 1)
                                     << QStringLiteral("Fill holes of 'Parts'");
        QTest::newRow("holes up to their own size") << CleanSegment{.segment = 1,
            .mm3 = 8.0 * one} << qint64(all + 9) << QStringLiteral("Fill holes of 'Parts'");
        QTest::newRow("the largest island")
            << CleanSegment{.segment = 1, .rule = IslandRule::KeepLargest} << qint64(512 - 9)
            << QStringLiteral("Keep the largest island of 'Parts'");
        QTest::newRow("small islands")
            << CleanSegment{.segment = 1, .rule = IslandRule::RemoveSmall, .mm3 = 27.0 * one}
            << qint64(all - 1) << QStringLiteral("Remove small islands of 'Parts'");
        QTest::newRow("larger islands")
            << CleanSegment{.segment = 1, .rule = IslandRule::RemoveSmall, .mm3 = 27.5 * one}
            << qint64(all - 28) << QStringLiteral("Remove small islands of 'Parts'");
    }
    void eachRuleIsARowThatComesBack()
    {
        QFETCH(const CleanSegment, edit);
        QFETCH(const qint64, left);
        QFETCH(const QString, name);
        for (const bool delayed : {false, true}) {
            Bench bench(delayed);
            QCOMPARE(bench.voxels(), all);
            const QByteArray before = bench.session->stateHash();
            QCOMPARE(bench.tried(edit), QString());
            QCOMPARE(bench.voxels(), left);
            QCOMPARE(bench.session->document().segment(1)->voxels, left);
            QVERIFY2(
                bench.rows().back().name.startsWith(name), qPrintable(bench.rows().back().name));
            const QByteArray after = bench.session->stateHash();
            QVERIFY(bench.session->undo() && bench.session->settle());
            QCOMPARE(bench.session->stateHash(), before);
            QVERIFY(bench.session->redo() && bench.session->settle());
            QCOMPARE(bench.session->stateHash(), after);
            // There is nothing left to be done, and no row of it.
            const std::size_t rows = bench.rows().size();
            QCOMPARE(bench.tried(edit), QString());
            QCOMPARE(bench.rows().size(), rows);
        }
    }

    /// One island, by a click into it; a second click finds nothing left to be done, or no island.
    void aClickedIsland_data()
    {
        QTest::addColumn<CleanSegment>("edit");
        QTest::addColumn<qint64>("left");
        QTest::addColumn<qint64>("given");
        QTest::addColumn<QString>("name");
        const std::optional<glm::dvec3> island = placeOf({19, 19, 19});
        const std::optional<glm::dvec3> block = placeOf({5, 5, 5});
        QTest::newRow("kept")
            << CleanSegment{.segment = 1, .rule = IslandRule::KeepClicked, .islandLps = island}
            << qint64(27) << qint64(0)
            << QStringLiteral("Keep only one island of 'Parts', −%1 voxels").arg(all - 27);
        QTest::newRow("the block removed")
            << CleanSegment{.segment = 1, .rule = IslandRule::RemoveClicked, .islandLps = block}
            << qint64(28) << qint64(0)
            << QStringLiteral("Remove one island of 'Parts', −%1 voxels").arg(all - 28);
        QTest::newRow("given") << CleanSegment{.segment = 1,
            .rule = IslandRule::GiveClicked,
            .islandLps = island,
            .to = 2} << qint64(all - 27)
                               << qint64(27)
                               << QStringLiteral(
                                      "Give one island of 'Parts' to 'Other', −27 voxels");
    }
    void aClickedIsland()
    {
        QFETCH(const CleanSegment, edit);
        QFETCH(const qint64, left);
        QFETCH(const qint64, given);
        QFETCH(const QString, name);
        for (const bool delayed : {false, true}) {
            Bench bench(delayed);
            QCOMPARE(bench.tried(test::addSegment("Other")), QString());
            const QByteArray before = bench.session->stateHash();
            QCOMPARE(bench.tried(edit), QString());
            QCOMPARE(bench.voxels(1), left);
            QCOMPARE(bench.voxels(2), given);
            QCOMPARE(bench.session->document().segment(2)->voxels, given);
            QCOMPARE(bench.rows().back().name, name);
            const QByteArray after = bench.session->stateHash();
            QVERIFY(bench.session->undo() && bench.session->settle());
            QCOMPARE(bench.session->stateHash(), before);
            QVERIFY(bench.session->redo() && bench.session->settle());
            QCOMPARE(bench.session->stateHash(), after);
            const std::size_t rows = bench.rows().size();
            const bool isThere = edit.rule == IslandRule::KeepClicked;
            QVERIFY(bench.session->apply(edit));
            const Result<void> again = bench.session->settle();
            QCOMPARE(bool(again), isThere);
            QVERIFY(isThere || again.error().code == ErrorCode::NoIslandThere);
            QCOMPARE(bench.rows().size(), rows);
            QCOMPARE(bench.session->stateHash(), after);
        }
    }

    /// Any island of random matter, beside two other segments: the voxels are those that sweeps
    /// find, undo brings all back, and what was recorded comes to the same from scratch.
    void clickedIslandsOfRandomMatter_data()
    {
        QTest::addColumn<uint>("percent");
        for (const uint percent : {2U, 5U, 8U, 20U})
            QTest::addRow("%u %%", percent) << percent;
    }
    void clickedIslandsOfRandomMatter()
    {
        QFETCH(const uint, percent);
        std::mt19937 random(percent);
        const Edit matter = randomMatter(random, percent);
        Bench bench(false, matter);
        for (const IslandRule rule :
            {IslandRule::GiveClicked, IslandRule::RemoveClicked, IslandRule::KeepClicked}) {
            const std::vector<std::uint8_t> before = *bench.session->questions().labels(0);
            const QByteArray hash = bench.session->stateHash();
            QVERIFY(bench.voxels(1) > 1);
            std::size_t clicked = std::uint32_t(random()) % before.size();
            while (before[clicked] != 1)
                clicked = (clicked + 1) % before.size();
            const auto& size = smallGrid().size;
            CleanSegment edit{.segment = 1, .rule = rule};
            edit.islandLps = placeOf(
                {int(clicked % std::size_t(size.x)), int(clicked / std::size_t(size.x)) % size.y,
                    int(clicked / std::size_t(size.x)) / size.y});
            if (rule == IslandRule::GiveClicked)
                edit.to = 3;
            QCOMPARE(bench.tried(edit), QString());
            const std::vector<bool> island = islandAround(before, clicked);
            std::vector<std::uint8_t> expected = before;
            for (std::size_t voxel = 0; voxel < expected.size(); ++voxel) {
                if (before[voxel] == 1 && island[voxel] != (rule == IslandRule::KeepClicked))
                    expected[voxel] = rule == IslandRule::GiveClicked ? 3 : 0;
            }
            QVERIFY(*bench.session->questions().labels(0) == expected);
            const QByteArray after = bench.session->stateHash();
            QVERIFY(after != hash);
            QVERIFY(bench.session->undo() && bench.session->settle());
            QCOMPARE(bench.session->stateHash(), hash);
            QVERIFY(bench.session->redo() && bench.session->settle());
            QCOMPARE(bench.session->stateHash(), after);
        }
        Bench anew(false, matter);
        for (std::size_t row = 1; row < bench.rows().size(); ++row)
            QCOMPARE(anew.tried(bench.rows()[row].edit), QString());
        QCOMPARE(anew.session->stateHash(), bench.session->stateHash());
    }

    /// A hole that another segment fills is no hole of nobody.
    void othersKeepTheirVoxels()
    {
        Bench bench;
        QCOMPARE(bench.tried(test::addSegment("Other")), QString());
        const glm::dvec3 place = smallGrid().toWorld({10.0, 10.0, 10.0});
        QCOMPARE(bench.tried(test::paintAt(2, {place}, 0.1)), QString());
        QCOMPARE(bench.voxels(2), std::int64_t(1));
        QCOMPARE(bench.tried(CleanSegment{.segment = 1}), QString());
        QCOMPARE(bench.voxels(), all + 8);
        QCOMPARE(bench.voxels(2), std::int64_t(1));
    }

    void whatCannotBe()
    {
        Bench bench;
        const std::size_t rows = bench.rows().size();
        QVERIFY(!bench.tried(CleanSegment{.segment = 9}).isEmpty());
        QVERIFY(bench.tried(CleanSegment{.segment = 1, .rule = IslandRule::RemoveSmall})
                    .contains(QLatin1String("mm3")));
        QCOMPARE(bench.tried(ChangeSegment{.segment = 1, .locked = true}), QString());
        QVERIFY(!bench.tried(CleanSegment{.segment = 1}).isEmpty());
        QCOMPARE(bench.rows().size(), rows + 1);
    }

    /// What a click needs is asked for, and what does not belong to it is refused; so is a locked
    /// segment on either side, and a click into a hole.
    void clicksThatCannotBe()
    {
        Bench bench;
        QCOMPARE(bench.tried(test::addSegment("Other")), QString());
        const std::optional<glm::dvec3> island = placeOf({19, 19, 19});
        const auto refused = [&](const CleanSegment& edit, const char* field) {
            const QString why = bench.tried(edit);
            QVERIFY2(why.contains(QStringLiteral("cleanSegment.%1: ").arg(QLatin1String(field))),
                qPrintable(why));
        };
        using Rule = IslandRule;
        const std::size_t rows = bench.rows().size();
        refused({.segment = 1, .rule = Rule::KeepClicked}, "islandLps");
        refused({.segment = 1, .rule = Rule::KeepLargest, .islandLps = island}, "islandLps");
        refused(
            {.segment = 1, .rule = Rule::RemoveClicked, .mm3 = 4.0, .islandLps = island}, "mm3");
        refused({.segment = 1, .rule = Rule::RemoveClicked, .islandLps = island, .to = 2}, "to");
        refused({.segment = 1, .rule = Rule::GiveClicked, .islandLps = island}, "to");
        refused({.segment = 1, .rule = Rule::GiveClicked, .islandLps = island, .to = 1}, "to");
        refused({.segment = 1, .rule = Rule::KeepClicked, .islandLps = placeOf({40, 5, 5})},
            "islandLps");
        CleanSegment give{
            .segment = 1, .rule = Rule::GiveClicked, .islandLps = placeOf({10, 10, 10}), .to = 9};
        QCOMPARE(bench.session->apply(give).error().code, ErrorCode::UnknownSegment);
        give.to = 2;
        QVERIFY(bench.session->apply(give)); // a hole, which only the labels tell
        const Result<void> hole = bench.session->settle();
        QVERIFY(!hole && hole.error().code == ErrorCode::NoIslandThere);
        QCOMPARE(hole.error().arguments, QStringList{QStringLiteral("Parts")});
        QCOMPARE(bench.rows().size(), rows);
        give.islandLps = island;
        for (const int locked : {1, 2}) {
            QCOMPARE(bench.tried(ChangeSegment{.segment = locked, .locked = true}), QString());
            QCOMPARE(bench.session->apply(give).error().code, ErrorCode::SegmentLocked);
            QCOMPARE(bench.tried(ChangeSegment{.segment = locked, .locked = false}), QString());
        }
        QCOMPARE(bench.voxels(1), all);
        QCOMPARE(bench.tried(give), QString());
        QCOMPARE(bench.voxels(2), std::int64_t(27));
    }

    /// What was another segment's stays so, also in the midst of what is given away: the island
    /// is the segment's voxels alone.
    void givingTakesFromTheSegmentAlone()
    {
        Bench bench;
        for (const char* name : {"Other", "Third"})
            QCOMPARE(bench.tried(test::addSegment(name)), QString());
        QCOMPARE(bench.tried(test::paintAt(3, {placeOf({10, 10, 10})}, 0.1)), QString());
        QCOMPARE(bench.tried(CleanSegment{.segment = 1,
                     .rule = IslandRule::GiveClicked,
                     .islandLps = placeOf({6, 6, 6}),
                     .to = 2}),
            QString());
        QCOMPARE(bench.voxels(1), std::int64_t(28));
        QCOMPARE(bench.voxels(2), all - 28);
        QCOMPARE(bench.voxels(3), std::int64_t(1));
    }
};

BURIN_TEST(CleanSegmentTest)

} // namespace cleanSegmentTest

#include "CleanSegmentTest.moc"
