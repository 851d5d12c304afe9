// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/edits/kinds/segments/ImportMask.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/DelayedEngine.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTest>

#include <algorithm>

namespace cleanSegmentTest {

using namespace core;

namespace {

const VolumeGeometry& geometry()
{
    static const VolumeGeometry its = test::smallStudy().volume.geometry;
    return its;
}

std::size_t at(int x, int y, int z)
{
    return (std::size_t(z) * std::size_t(geometry().size.y) + std::size_t(y))
        * std::size_t(geometry().size.x)
        + std::size_t(x);
}

/// A block of 8³ with a hole of 2³ and one of a single voxel, an island of 3³ and a speck.
struct Bench {
    explicit Bench(bool delayed = false)
        : late(inner, 11)
    {
        EditEngine& engine = delayed ? static_cast<EditEngine&>(late) : inner;
        session = *EditSession::create(engine, test::smallStudy(), {.file = {}});
        std::vector<bool> mask(geometry().voxelCount(), false);
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
        ImportMask import{.file = QStringLiteral("parts.nii")};
        import.size = geometry().size;
        import.segments.emplace();
        import.segments->push_back(
            {.name = QStringLiteral("Parts"), .rgb = 7, .code = {}, .voxels = packedRuns(runs)});
        QCOMPARE(tried(import), QString());
    }
    [[nodiscard]] QString tried(const Edit& edit) const
    {
        Result<void> done = session->apply(edit);
        if (done)
            done = session->settle();
        return done ? QString() : done.error().arguments.join(QStringLiteral(": "));
    }
    [[nodiscard]] std::int64_t voxels(int label = 1) const
    {
        const std::vector<std::uint8_t> all = *session->questions().labels(0);
        return std::count(all.begin(), all.end(), label);
    }
    [[nodiscard]] const std::vector<HistoryRow>& rows() const { return session->history().rows(); }

    reference::ReferenceEngine inner;
    reference::DelayedEngine late;
    std::unique_ptr<EditSession> session;
};

constexpr std::int64_t all = 512 - 8 - 1 + 27 + 1;

double voxelMm3()
{
    const glm::dvec3 spacing = geometry().spacingMm();
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

    /// A hole that another segment fills is no hole of nobody.
    void othersKeepTheirVoxels()
    {
        Bench bench;
        QCOMPARE(bench.tried(test::addSegment("Other")), QString());
        const glm::dvec3 place = geometry().toWorld({10.0, 10.0, 10.0});
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
};

BURIN_TEST(CleanSegmentTest)

} // namespace cleanSegmentTest

#include "CleanSegmentTest.moc"
