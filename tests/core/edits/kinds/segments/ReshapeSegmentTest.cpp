// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/morphology/GaussianShape.h"
#include "core/morphology/GridGaussian.h"
#include "core/session/EditSession.h"
#include "core/session/SegmentWork.h"
#include "core/sessionfile/SessionSalvage.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/PlainMasks.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/sessions/SessionBench.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <optional>
#include <random>

namespace reshapeSegmentTest {

using namespace core;

namespace {

using Labels = std::vector<std::uint8_t>;
using test::smallGrid;
using test::smallIndexOf;

/// A block of 12 × 12 × 8 voxels, 12 mm along each axis, beside which nothing is.
const glm::ivec3 blockFrom(10, 10, 10);
const glm::ivec3 blockTo(22, 22, 18);
constexpr std::int64_t blockVoxels = 12 * 12 * 8;

Edit block()
{
    VoxelRuns runs;
    for (int z = blockFrom.z; z < blockTo.z; ++z) {
        for (int y = blockFrom.y; y < blockTo.y; ++y)
            runs.append(smallIndexOf({blockFrom.x, y, z}), 12);
    }
    return test::matterImport(smallGrid().size, std::array{runs});
}

/// Two segments of random blocks, and specks of both.
Edit randomMatter(std::mt19937& random)
{
    const glm::ivec3& size = smallGrid().size;
    Labels labels(smallGrid().voxelCount(), 0);
    for (const int label : {1, 2, 1, 2, 1, 1}) {
        const glm::ivec3 from{int(random() % 26), int(random() % 24), int(random() % 24)};
        const glm::ivec3 sides{
            3 + int(random() % 10), 3 + int(random() % 10), 3 + int(random() % 6)};
        const glm::ivec3 to = glm::min(from + sides, size);
        for (int z = from.z; z < to.z; ++z) {
            for (int y = from.y; y < to.y; ++y) {
                for (int x = from.x; x < to.x; ++x)
                    labels[smallIndexOf({x, y, z})] = std::uint8_t(label);
            }
        }
    }
    std::array<VoxelRuns, 2> runs;
    for (std::size_t voxel = 0; voxel < labels.size(); ++voxel) {
        const std::uint32_t dice = std::uint32_t(random()) % 200;
        const int label = dice < 2 ? int(dice) + 1 : labels[voxel];
        if (label > 0)
            runs.at(std::size_t(label) - 1).append(voxel, 1);
    }
    return test::matterImport(smallGrid().size, runs);
}

struct Bench : test::SessionBench {
    explicit Bench(bool delayed = false, const Edit& matter = block(), const QString& file = {})
        : SessionBench(delayed, test::smallStudy(), file)
    {
        run(matter);
    }
};

bool isNear(const glm::ivec3& one, const glm::ivec3& other, double mm)
{
    return glm::length(glm::dvec3(one - other) * smallGrid().spacingMm()) <= mm + 1e-9;
}

/// Whether a voxel within so many millimetres is the label's, or is not.
bool hasNear(const Labels& labels, const glm::ivec3& at, double mm, int label, bool own)
{
    const glm::ivec3 reach(glm::ceil(mm / smallGrid().spacingMm()));
    const glm::ivec3 from = glm::max(at - reach, glm::ivec3(0));
    const glm::ivec3 to = glm::min(at + reach, smallGrid().size - 1);
    for (int z = from.z; z <= to.z; ++z) {
        for (int y = from.y; y <= to.y; ++y) {
            for (int x = from.x; x <= to.x; ++x) {
                if ((labels[smallIndexOf({x, y, z})] == label) == own && isNear({x, y, z}, at, mm))
                    return true;
            }
        }
    }
    return false;
}

/// By the definition of those operations that one look at each voxel tells.
Labels expectedAfter(const ReshapeSegment& edit, const Labels& before)
{
    Labels after = before;
    const glm::ivec3& size = smallGrid().size;
    const ShellPlace shell = edit.shell.value_or(ShellPlace::Inside);
    const double mm = shell == ShellPlace::Centred ? edit.mm / 2.0 : edit.mm;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                std::uint8_t& label = after[smallIndexOf({x, y, z})];
                const bool own = label == edit.segment;
                if (!own && label != 0)
                    continue;
                const bool nearOther = hasNear(before, {x, y, z}, mm, edit.segment, !own);
                bool isOwn = own;
                if (edit.operation == ShapeOperation::Grow)
                    isOwn = own || nearOther;
                else if (edit.operation == ShapeOperation::Shrink)
                    isOwn = own && !nearOther;
                else if (own)
                    isOwn = shell != ShellPlace::Outside && nearOther;
                else
                    isOwn = shell != ShellPlace::Inside && nearOther;
                label = isOwn ? std::uint8_t(edit.segment) : 0;
            }
        }
    }
    return after;
}

} // namespace

class ReshapeSegmentTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Of a block, whose voxels can be counted by hand.
    void eachOperationIsARowThatComesBack_data()
    {
        using enum ShapeOperation;
        QTest::addColumn<ReshapeSegment>("edit");
        QTest::addColumn<qint64>("left");
        QTest::addColumn<QString>("name");
        // 1 mm reaches the next voxel along x and y, and none along z, which is 1.5 mm away.
        QTest::newRow("grow") << ReshapeSegment{.segment = 1, .operation = Grow, .mm = 1.0}
                              << qint64(blockVoxels + 4 * 12 * 8)
                              << QStringLiteral("Grow 'Matter 1' by 1 mm, +384 voxels");
        QTest::newRow("shrink") << ReshapeSegment{.segment = 1, .operation = Shrink, .mm = 1.5}
                                << qint64(10 * 10 * 6)
                                << QStringLiteral("Shrink 'Matter 1' by 1.5 mm, −552 voxels");
        QTest::newRow("inside") << ReshapeSegment{.segment = 1, .operation = Hollow, .mm = 1.5}
                                << qint64(blockVoxels - 10 * 10 * 6)
                                << QStringLiteral(
                                       "Hollow 'Matter 1', 1.5 mm inside its border, −600 voxels");
        QTest::newRow("centred")
            << ReshapeSegment{.segment = 1,
                   .operation = Hollow,
                   .mm = 2.0,
                   .shell = ShellPlace::Centred}
            << qint64((12 * 12 - 10 * 10) * 8 + 4 * 12 * 8)
            << QStringLiteral("Hollow 'Matter 1', 2 mm along its border, +384 −800 voxels");
        QTest::newRow("outside")
            << ReshapeSegment{.segment = 1,
                   .operation = Hollow,
                   .mm = 1.0,
                   .shell = ShellPlace::Outside}
            << qint64(4 * 12 * 8)
            << QStringLiteral("Hollow 'Matter 1', 1 mm outside its border, +384 −1 152 voxels");
        // Only to the left, which is along x.
        QTest::newRow("by sides") << ReshapeSegment{.segment = 1,
            .mm = 3.0,
            .sides = {.rightMm = 0.0,
                .anteriorMm = 0.0,
                .posteriorMm = 0.0,
                .inferiorMm = 0.0,
                .superiorMm = 0.0}}
                                  << qint64(blockVoxels + 3 * 12 * 8)
                                  << QStringLiteral(
                                         "Grow 'Matter 1' by margins of up to 3 mm, +288 voxels");
        // The four edges along z, each of 8 voxels, have less than one half.
        QTest::newRow("Gaussian") << ReshapeSegment{.segment = 1,
            .operation = ShapeOperation::Gaussian,
            .mm = 1.0} << qint64(blockVoxels - 4 * 8)
                                  << QStringLiteral(
                                         "Smooth 'Matter 1' by a Gaussian of 1 mm, −32 voxels");
        QTest::newRow("open") << ReshapeSegment{.segment = 1, .operation = Open, .mm = 20.0}
                              << qint64(0)
                              << QStringLiteral("Open 'Matter 1' by 20 mm, −1 152 voxels");
    }
    void eachOperationIsARowThatComesBack()
    {
        QFETCH(const ReshapeSegment, edit);
        QFETCH(const qint64, left);
        QFETCH(const QString, name);
        for (const bool delayed : {false, true}) {
            Bench bench(delayed);
            QCOMPARE(bench.voxels(), blockVoxels);
            const QByteArray before = bench.session->stateHash();
            QCOMPARE(bench.tried(edit), QString());
            QCOMPARE(bench.voxels(), left);
            QCOMPARE(bench.session->document().segment(1)->voxels, left);
            QCOMPARE(bench.rows().back().name, name);
            const QByteArray after = bench.session->stateHash();
            QVERIFY(bench.session->undo() && bench.session->settle());
            QCOMPARE(bench.session->stateHash(), before);
            QVERIFY(bench.session->redo() && bench.session->settle());
            QCOMPARE(bench.session->stateHash(), after);
        }
    }

    /// A gap of two voxels closes, a speck goes by the majority; and what has nothing to be done
    /// leaves no row.
    void closeAndSmooth()
    {
        Bench bench;
        const auto placeOf = [](const glm::ivec3& voxel) {
            return smallGrid().toWorld(glm::dvec3(voxel));
        };
        QCOMPARE(bench.tried(test::eraseAt(1, {placeOf({15, 15, 14})}, 0.1)), QString());
        QCOMPARE(bench.tried(test::paintAt(1, {placeOf({30, 15, 14})}, 0.1)), QString());
        QCOMPARE(bench.voxels(), blockVoxels);
        QCOMPARE(bench.tried(
                     ReshapeSegment{.segment = 1, .operation = ShapeOperation::Close, .mm = 1.5}),
            QString());
        QCOMPARE(bench.voxels(), blockVoxels + 1);
        QCOMPARE(bench.rows().back().name, QStringLiteral("Close 'Matter 1' by 1.5 mm, +1 voxels"));
        const std::size_t rows = bench.rows().size();
        QCOMPARE(bench.tried(
                     ReshapeSegment{.segment = 1, .operation = ShapeOperation::Close, .mm = 1.5}),
            QString());
        QCOMPARE(bench.rows().size(), rows);
        QCOMPARE(bench.tried(
                     ReshapeSegment{.segment = 1, .operation = ShapeOperation::Median, .mm = 1.0}),
            QString());
        QCOMPARE(int(bench.labels()[smallIndexOf({30, 15, 14})]), 0);
        QVERIFY(
            bench.rows().back().name.startsWith(QStringLiteral("Smooth 'Matter 1' by 1 mm, −")));
    }

    /// Random matter of two segments, operation by operation: the voxels are those that a look
    /// around each voxel tells, undo brings all back, and the rows come to the same from scratch.
    void randomMatterReplays_data()
    {
        QTest::addColumn<uint>("seed");
        for (const uint seed : {1U, 2U, 3U, 4U})
            QTest::addRow("seed %u", seed) << seed;
    }
    void randomMatterReplays()
    {
        QFETCH(const uint, seed);
        std::mt19937 random(seed);
        const Edit matter = randomMatter(random);
        Bench bench(false, matter);
        const std::size_t begun = bench.rows().size();
        for (int step = 0; step < 10; ++step) {
            ReshapeSegment edit{.segment = 1 + int(random() % 2)};
            edit.operation = ShapeOperation(step % 8);
            edit.mm = double(1024 + random() % 3000) / 1024.0;
            if (edit.operation == ShapeOperation::Hollow)
                edit.shell = ShellPlace(random() % 3);
            const Labels before = bench.labels();
            const QByteArray hash = bench.session->stateHash();
            const std::size_t rows = bench.rows().size();
            QCOMPARE(bench.tried(edit), QString());
            const Labels after = bench.labels();
            QCOMPARE(bench.rows().size(), before == after ? rows : rows + 1);
            if (edit.operation <= ShapeOperation::Hollow)
                QVERIFY(after == expectedAfter(edit, before));
            for (std::size_t voxel = 0; voxel < after.size(); ++voxel) {
                const bool others = before[voxel] != 0 && before[voxel] != edit.segment;
                QVERIFY(!others || after[voxel] == before[voxel]);
            }
            if (before == after)
                continue;
            const QByteArray changed = bench.session->stateHash();
            QVERIFY(bench.session->undo() && bench.session->settle());
            QCOMPARE(bench.session->stateHash(), hash);
            QVERIFY(bench.session->redo() && bench.session->settle());
            QCOMPARE(bench.session->stateHash(), changed);
        }
        QVERIFY(bench.rows().size() > begun + 3);
        Bench anew(true, matter);
        for (std::size_t row = 1; row < bench.rows().size(); ++row)
            QCOMPARE(anew.tried(bench.rows()[row].edit), QString());
        QCOMPARE(anew.session->stateHash(), bench.session->stateHash());
    }

    /// In a further label plane it comes to the same, whoever lies across it in the first one.
    void smoothedTogetherInAFurtherPlane()
    {
        std::mt19937 random(21);
        const Edit matter = randomMatter(random);
        Edit above = matter;
        above.as<ImportMask>()->planes = std::vector<int>{2, 2};
        Bench plain(false, matter);
        Bench further(false, above);
        further.run(test::addSegment("Across"));
        further.run(test::paintAt(3, {smallGrid().toWorld({16.0, 16.0, 14.0})}, 8.0));
        const Labels across = further.labels(0);
        const Labels before = plain.labels();
        QVERIFY(further.labels(2) == before);
        ReshapeSegment joint{.segment = 2,
            .operation = ShapeOperation::Gaussian,
            .mm = 1.5,
            .with = std::vector<int>{1}};
        plain.run(joint);
        QVERIFY(plain.labels() != before);
        const QByteArray hash = further.session->stateHash();
        further.run(joint);
        QVERIFY(further.labels(2) == plain.labels());
        QVERIFY(further.labels(0) == across);
        QVERIFY(further.session->undo() && further.session->settle());
        QCOMPARE(further.session->stateHash(), hash);
        // With one of the first plane, which is smoothed there beside what is free in it.
        joint.with = std::vector<int>{1, 3};
        const std::array<std::uint8_t, 1> third{3};
        const auto change = jointGaussianChange(
            across, smallGrid().size, third, gaussianOf(smallGrid(), joint.mm), Progress());
        QVERIFY(change && !change->freed.empty());
        Labels smoothed = across;
        for (const VoxelRun& run : change->given.front().runs())
            std::fill_n(smoothed.begin() + std::ptrdiff_t(run.first), run.count, std::uint8_t(3));
        for (const VoxelRun& run : change->freed.runs())
            std::fill_n(smoothed.begin() + std::ptrdiff_t(run.first), run.count, std::uint8_t(0));
        further.run(joint);
        QVERIFY(further.labels(2) == plain.labels());
        QVERIFY(further.labels(0) == smoothed);
        const std::size_t rows = further.rows().size();
        QVERIFY(further.session->undo() && further.session->settle());
        QCOMPARE(further.session->stateHash(), hash);
        QVERIFY(further.labels(0) == across);
        // Seen before it is a step, and dropped; then committed.
        QVERIFY(further.session->begin(joint));
        further.session->end(Ending::Rollback);
        QVERIFY(further.session->settle());
        QCOMPARE(further.session->stateHash(), hash);
        QVERIFY(further.session->begin(joint));
        further.session->end(Ending::Commit);
        QVERIFY(further.session->settle());
        QCOMPARE(further.rows().size(), rows + 1);
        QVERIFY(further.labels(2) == plain.labels() && further.labels(0) == smoothed);
        // Each of them has to be free to change.
        further.run(test::lockSegment(3));
        QVERIFY(!further.tried(joint).isEmpty());
    }

    /// Two blocks that touch: their common border stays closed, the outer edges are rounded, undo
    /// brings all back, and a locked one is left out of it.
    void smoothedTogether()
    {
        VoxelRuns left;
        VoxelRuns right;
        for (int z = 10; z < 18; ++z) {
            for (int y = 10; y < 22; ++y) {
                left.append(smallIndexOf({10, y, z}), y % 2 == 0 ? 6 : 7);
                right.append(smallIndexOf({y % 2 == 0 ? 16 : 17, y, z}), y % 2 == 0 ? 7 : 6);
            }
        }
        for (const bool delayed : {false, true}) {
            Bench bench(delayed, test::matterImport(smallGrid().size, std::array{left, right}));
            const Labels before = bench.labels();
            const QByteArray hash = bench.session->stateHash();
            const ReshapeSegment joint{.segment = 1,
                .operation = ShapeOperation::Gaussian,
                .mm = 1.0,
                .with = std::vector<int>{2}};
            QCOMPARE(bench.tried(joint), QString());
            QVERIFY(bench.rows().back().name.startsWith(
                QStringLiteral("Smooth 'Matter 1' and others together by a Gaussian of 1 mm, ")));
            const Labels after = bench.labels();
            for (int z = 12; z < 16; ++z) {
                for (int y = 13; y < 19; ++y) {
                    // The teeth are one voxel long; none of their voxels is nobody's, and within
                    // one voxel of them no border has moved farther.
                    QVERIFY(after[smallIndexOf({16, y, z})] == 1
                        || after[smallIndexOf({16, y, z})] == 2);
                    QCOMPARE(int(after[smallIndexOf({15, y, z})]), 1);
                    QCOMPARE(int(after[smallIndexOf({17, y, z})]), 2);
                }
            }
            QCOMPARE(int(after[smallIndexOf({10, 10, 10})]), 0);
            QCOMPARE(int(after[smallIndexOf({22, 10, 10})]), 0);
            QVERIFY(bench.session->undo() && bench.session->settle());
            QVERIFY(bench.labels() == before);
            QCOMPARE(bench.session->stateHash(), hash);
            // Where the editable range ends, nothing changes.
            ReshapeSegment kept = joint;
            kept.editable = EditableRange{.outside = std::vector<int>{2}};
            QCOMPARE(bench.tried(kept), QString());
            const Labels within = bench.labels();
            for (std::size_t voxel = 0; voxel < before.size(); ++voxel)
                QCOMPARE(int(within[voxel]), int(before[voxel] == 2 ? 2 : after[voxel]));
            QVERIFY(within != before && within != after);
            QVERIFY(bench.session->undo() && bench.session->settle());
            QCOMPARE(bench.tried(ChangeSegment{.segment = 2, .locked = true}), QString());
            QVERIFY(!bench.tried(joint).isEmpty());
        }
    }

    /// Nothing is taken from a segment that is there already, locked or not.
    void othersKeepTheirVoxels()
    {
        Bench bench;
        QCOMPARE(bench.tried(test::addSegment("Other")), QString());
        QCOMPARE(bench.tried(test::paintAt(2, {smallGrid().toWorld({23.0, 15.0, 14.0})}, 1.2)),
            QString());
        const std::int64_t others = bench.voxels(2);
        QVERIFY(others > 1);
        QCOMPARE(bench.tried(ReshapeSegment{.segment = 1, .mm = 4.0}), QString());
        QCOMPARE(bench.voxels(2), others);
        QVERIFY(bench.voxels(1) > blockVoxels);
    }

    void whatCannotBe()
    {
        Bench bench;
        const std::size_t rows = bench.rows().size();
        const auto refused = [&](const ReshapeSegment& edit, const char* field) {
            const QString why = bench.tried(edit);
            QVERIFY2(why.contains(QStringLiteral("reshapeSegment.%1: ").arg(QLatin1String(field))),
                qPrintable(why));
        };
        refused({.segment = 1, .mm = 0.0}, "mm");
        refused({.segment = 1, .mm = -1.0}, "mm");
        refused({.segment = 1, .mm = 5000.0}, "mm");
        refused({.segment = 1, .mm = 1.0, .shell = ShellPlace::Inside}, "shell");
        const auto sidesAreRefused = [&](ShapeOperation operation, const SideMargins& sides) {
            refused({.segment = 1, .operation = operation, .mm = 1.0, .sides = sides}, "sides");
        };
        refused({.segment = 1, .mm = 1.0, .with = std::vector<int>{1}}, "with");
        refused({.segment = 1,
                    .operation = ShapeOperation::Gaussian,
                    .mm = 1.0,
                    .with = std::vector<int>{1}},
            "with");
        sidesAreRefused(ShapeOperation::Open, {.leftMm = 1.0});
        refused({.segment = 1, .mm = 1.0, .sides = {.leftMm = -1.0}}, "leftMm");
        refused({.segment = 1, .mm = 1.0, .sides = {.superiorMm = 5000.0}}, "superiorMm");
        sidesAreRefused(ShapeOperation::Shrink, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
        // Of a ball that is allowed, voxels may be too many.
        Document fine = bench.session->document();
        fine.volumes.front().geometry.indexToWorld = glm::dmat4(glm::dmat3(0.01));
        const ReshapeSegment large{.segment = 1, .mm = 50.0};
        QVERIFY(check(large, bench.session->document()));
        QVERIFY(!check(large, fine));
        QCOMPARE(check(large, fine).error().arguments.join(QStringLiteral(": ")),
            QStringLiteral("reshapeSegment.mm: 50 mm are more than 4096 voxels here"));
        QVERIFY(!bench.tried(ReshapeSegment{.segment = 9, .mm = 1.0}).isEmpty());
        QCOMPARE(bench.tried(test::lockSegment(1)), QString());
        const Result<void> locked = bench.session->apply(ReshapeSegment{.segment = 1, .mm = 1.0});
        QVERIFY(!locked);
        QVERIFY(locked.error().code == ErrorCode::SegmentLocked);
        QCOMPARE(bench.rows().size(), rows + 1);
        QCOMPARE(bench.voxels(), blockVoxels);
    }

    /// Whoever does not want to wait gets his voxels as they were; so it is with islands.
    void abortedBeforeItsEnd()
    {
        Bench bench;
        const std::size_t rows = bench.rows().size();
        const QByteArray before = bench.session->stateHash();
        QVERIFY(!bench.session->segmentWork().percent());
        for (const Edit& edit : std::vector<Edit>{
                 ReshapeSegment{.segment = 1, .mm = 3.0}, CleanSegment{.segment = 1}}) {
            QVERIFY(bench.session->apply(edit));
            QCOMPARE(bench.session->segmentWork().percent(), std::optional<int>(0));
            bench.session->segmentWork().abort();
            const Result<void> settled = bench.session->settle();
            QVERIFY(!settled);
            QVERIFY(settled.error().code == ErrorCode::Cancelled);
            QVERIFY(!bench.session->segmentWork().percent());
        }
        QCOMPARE(bench.rows().size(), rows);
        QCOMPARE(bench.session->stateHash(), before);
        bench.session->segmentWork().abort(); // of nothing
        QCOMPARE(bench.tried(ReshapeSegment{.segment = 1, .mm = 3.0}), QString());
        QCOMPARE(bench.rows().size(), rows + 1);
    }

    /// Whoever closes a study does not wait for what may take minutes.
    void closingDropsWhatIsBeingWorkedOut()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("a.burin"));
        Bench bench(false, block(), file);
        const std::size_t rows = bench.rows().size();
        QVERIFY(bench.session->apply(ReshapeSegment{.segment = 1, .mm = 3.0}));
        QVERIFY(bench.session->apply(ReshapeSegment{.segment = 1, .mm = 2.0}));
        bench.session.reset();
        const auto contents = checkSession(file);
        QVERIFY(contents && contents->isWhole());
        QCOMPARE(contents->rows.size(), rows);
    }
};

BURIN_TEST(ReshapeSegmentTest)

} // namespace reshapeSegmentTest

#include "ReshapeSegmentTest.moc"
