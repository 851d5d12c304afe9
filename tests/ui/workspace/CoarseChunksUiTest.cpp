// SPDX-License-Identifier: Apache-2.0
#include "core/brick/VoxelRuns.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/GradedBall.h"
#include "tests/support/scenes/PlainMasks.h"
#include "ui/workspace/Chunks.h"

#include <QTest>

#include <algorithm>

namespace coarseChunksUiTest {

namespace {

constexpr int side = 162; ///< voxels: more than four million, so that coarse chunks come first
constexpr double marginMm = 200.0; ///< all of the volume

/// A ball of which the segment has half.
class Fixture : public test::WorkspaceFixture {
public:
    Fixture()
        : WorkspaceFixture(test::GradedBall::in(side))
    {
        using Ball = test::GradedBall;
        core::VoxelRuns runs;
        const auto across = std::uint64_t(side);
        for (int z = 0; z < side; ++z) {
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < int(Ball::middle.x); ++x) {
                    if (glm::distance(glm::dvec3(x, y, z), Ball::middle) < Ball::radius)
                        runs.append(
                            (std::uint64_t(z) * across + std::uint64_t(y)) * across + unsigned(x),
                            1);
                }
            }
        }
        apply(test::maskImport(QStringLiteral("half.nii"), glm::ivec3(side),
            {{QStringLiteral("Half"), runs, 0x20A0C0}}));
        workspace.setActiveSegment(1);
    }
};

/// What the 3D view is given at some time.
enum class Seen : std::uint8_t { Nothing, Coarse, Fine };

Seen seenOf(const gpu::SceneChunks* bodies)
{
    const auto isDrawn = [](std::uint32_t argb) { return argb >> 24 != 0; };
    if (!bodies || std::none_of(bodies->argb.begin(), bodies->argb.end(), isDrawn))
        return Seen::Nothing;
    return bodies->cell == glm::ivec3(1) ? Seen::Fine : Seen::Coarse;
}

} // namespace

/// Chunks of a large box are shown roughly until they are there.
class CoarseChunksUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void theyStayUntilThoseThatFollowAreDrawn();
};

void CoarseChunksUiTest::theyStayUntilThoseThatFollowAreDrawn()
{
    Fixture fixture;
    ui::Chunks& chunks = fixture.workspace.chunks();
    std::vector<Seen> seen;
    QObject::connect(&chunks, &ui::Chunks::pictureChanged, &chunks,
        [&] { seen.push_back(seenOf(chunks.bodies().get())); });
    chunks.divide(marginMm);
    const auto isDone = [&] {
        fixture.session().poll();
        return chunks.map() && fixture.session().settle() && !chunks.isCounting();
    };
    QVERIFY(QTest::qWaitFor(isDone, 120000));
    QCoreApplication::processEvents();
    const auto coarse = std::find(seen.begin(), seen.end(), Seen::Coarse);
    QVERIFY(coarse != seen.end());
    QCOMPARE(std::count(coarse, seen.end(), Seen::Nothing), 0);
    QCOMPARE(seen.back(), Seen::Fine);
    QVERIFY(std::is_sorted(coarse, seen.end())); // never back to the coarse ones
}

BURIN_TEST(CoarseChunksUiTest)

} // namespace coarseChunksUiTest

#include "CoarseChunksUiTest.moc"
