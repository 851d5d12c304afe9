// SPDX-License-Identifier: Apache-2.0
#include "core/brick/BrickGrid.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/session/EditSession.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/faults/WorkOfGl.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QtTest>

#include <array>
#include <functional>
#include <vector>

namespace workOfStepsGlTest {

using namespace core;
using test::GlWork;

namespace {

struct Counted {
    QByteArray name;
    GlWork work;
    int bricks = 0; ///< that the step changed
};

/// What a step may cost in the small volume: what it does cost where this was written. Who needs
/// more says why in the commit that raises it.
struct Budget {
    const char* name;
    int dispatches;
    std::int64_t groups;
    std::int64_t bytesUp;
    std::int64_t bytesDown;
    std::int64_t bytesWithin;
};

constexpr std::array<Budget, 13> budgets{{{"paint", 5, 12, 84, 8228, 0},
    {"undo of paint", 2, 2, 4104, 4096, 0}, {"redo of paint", 2, 2, 4104, 4096, 0},
    {"erase", 4, 4, 84, 8196, 0}, {"drill", 10, 689, 21284, 35264, 198900},
    {"undo of drill", 7, 112, 16480, 16384, 512}, {"redo of drill", 7, 112, 16480, 16384, 512},
    {"laser", 12, 525, 6172, 24908, 157024}, {"carve", 8, 354, 300, 8196, 512},
    {"seeds", 4, 4, 28, 49152, 0}, {"grow", 7, 49, 2184, 330624, 231968},
    {"shrink", 8, 64, 1152, 327752, 72}, {"undo of shrink", 5, 40, 164000, 163872, 32}}};

int longSide()
{
    return test::longRun() ? 512 : 192;
}

constexpr glm::dvec3 middle(48.0); ///< of a ball of tissue, voxels and mm
constexpr double radius = 24.0;

OrthographicView frontView()
{
    return {.eyeLps = middle - glm::dvec3(0.0, 200.0, 0.0),
        .targetLps = middle,
        .up = {0.0, 0.0, 1.0},
        .heightMm = 80.0};
}

LoadedVolume ballIn(int side)
{
    LoadedVolume study;
    test::Codes codes = test::constantVolume(glm::ivec3(side), 0);
    for (int z = 0; z < side; ++z) {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                if (glm::distance(glm::dvec3(x, y, z), middle) <= radius)
                    codes.values[std::size_t((z * side + y) * side + x)] = test::tissueCode;
            }
        }
    }
    study.codes = std::move(codes.values);
    study.volume.geometry.size = glm::ivec3(side);
    study.volume.maximum = 65535.0;
    study.volume.voxelsSha256 = "not looked at here";
    return study;
}

} // namespace

/// What a step of the hand costs does not depend on how large the volume is: it is counted in calls
/// and bytes, in a small volume and in a large one that hold the same.
class WorkOfStepsGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY2(m_gpu.isReady(), m_gpu.why()); }
    void init() { test::failOnUnexpectedMessages(); }
    void cleanup() { QCOMPARE(m_gpu.newErrors(), 0); }
    void doesNotGrowWithTheVolume();

private:
    /// The steps, each for the second time: the first one makes programs and buffers.
    std::vector<Counted> stepsIn(int side);

    test::EditEngineFixture m_gpu;
};

std::vector<Counted> WorkOfStepsGlTest::stepsIn(int side)
{
    std::vector<Counted> all;
    const auto session = EditSession::create(m_gpu.engine(), ballIn(side), {});
    if (!session)
        return all;
    EditSession& known = **session;
    test::WorkOfGl work;
    const auto step = [&](const char* name, const std::function<bool()>& taken) {
        m_gpu.rest();
        static_cast<void>(work.take());
        const bool done = taken() && known.settle();
        m_gpu.rest(); // what views need follows
        const GlWork counted = work.take();
        if (!done)
            qWarning("%s failed", name);
        all.push_back({name, counted, known.history().rows().back().statistics.bricks});
    };
    const auto apply = [&](const Edit& edit) { return bool(known.apply(edit)); };
    const auto penAt = [](double x) {
        return test::CutWords{.view = frontView(),
            .radiusMm = 4.0,
            .depthMm = 5.0,
            .surfaceThreshold = 500.0,
            .samples = std::vector<PenSample>{{.xMm = x, .yMm = 0.3, .pressure = 0.7},
                {.xMm = x + 2.0, .yMm = 1.7, .pressure = 1.0, .tSeconds = 0.1}}};
    };
    if (!apply(test::newSegment(QStringLiteral("A"))) || !known.settle())
        return all;
    for (int round = 0; round < 2; ++round) {
        all.clear();
        const double aside = round * 6.0;
        step("paint", [&] { return apply(test::paintAt(1, {middle + glm::dvec3(aside)}, 4.0)); });
        step("undo of paint", [&] { return bool(known.undo()); });
        step("redo of paint", [&] { return bool(known.redo()); });
        step("erase", [&] { return apply(test::eraseAt(1, {middle + glm::dvec3(aside)}, 3.0)); });
        step("drill", [&] { return apply(test::drillWith(penAt(aside))); });
        step("undo of drill", [&] { return bool(known.undo()); });
        step("redo of drill", [&] { return bool(known.redo()); });
        step("laser", [&] { return apply(test::laserWith(penAt(-aside - 4.0))); });
        step("carve", [&] { return apply(test::carveAt({middle - glm::dvec3(aside)}, 4.0)); });
        step("seeds", [&] { return apply(test::seedAt(1, {middle - glm::dvec3(aside)})); });
        step("grow", [&] { return apply(test::growBetween(500.0, 2000.0, 5)); });
        step("shrink", [&] { return apply(ShrinkSteps{.steps = 3}); });
        step("undo of shrink", [&] { return bool(known.undo()); });
    }
    return all;
}

void WorkOfStepsGlTest::doesNotGrowWithTheVolume()
{
    const std::vector<Counted> small = stepsIn(96);
    const std::vector<Counted> large = stepsIn(longSide());
    QCOMPARE(small.size(), budgets.size());
    QCOMPARE(large.size(), small.size());
    // Tables of a few words for each brick are written and read whole.
    constexpr int tableBytes = 16;
    const auto bricksOf = [](int side) { return BrickGrid{glm::ivec3(side)}.brickCount(); };
    const std::int64_t more = std::int64_t(tableBytes) * (bricksOf(longSide()) - bricksOf(96));
    for (std::size_t i = 0; i < small.size(); ++i) {
        const GlWork& a = small[i].work;
        const GlWork& b = large[i].work;
        const char* name = small[i].name.constData();
        for (const GlWork& work : {a, b})
            qInfo("%-15s %3d bricks, %3d dispatches of %4lld groups, up %6lld, down %6lld, within "
                  "%6lld, made %7lld bytes",
                name, small[i].bricks, work.dispatches, qlonglong(work.groups),
                qlonglong(work.bytesUp), qlonglong(work.bytesDown), qlonglong(work.bytesWithin),
                qlonglong(work.bytesMade));
        QCOMPARE(large[i].bricks, small[i].bricks);
        QVERIFY2(b.dispatches <= a.dispatches, name);
        QVERIFY2(b.groups <= a.groups, name);
        QVERIFY2(b.bytesUp <= a.bytesUp + more, name);
        QVERIFY2(b.bytesDown <= a.bytesDown + more, name);
        QVERIFY2(b.bytesWithin <= a.bytesWithin + more, name);
        QVERIFY2(b.bytesMade <= a.bytesMade + more, name);

        const Budget& most = budgets[i];
        QCOMPARE(small[i].name, QByteArray(most.name));
        QVERIFY2(a.dispatches <= most.dispatches, name);
        QVERIFY2(a.groups <= most.groups, name);
        QVERIFY2(a.bytesUp <= most.bytesUp, name);
        QVERIFY2(a.bytesDown <= most.bytesDown, name);
        QVERIFY2(a.bytesWithin <= most.bytesWithin, name);
    }
}

BURIN_TEST(WorkOfStepsGlTest)

} // namespace workOfStepsGlTest

#include "WorkOfStepsGlTest.moc"
