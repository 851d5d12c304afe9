// SPDX-License-Identifier: Apache-2.0
#include "core/growth/SketchInterval.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <functional>

namespace sketchIntervalTest {

using namespace core;

namespace {

constexpr glm::ivec3 size(40, 40, 40);

using Codes = std::function<int(const glm::ivec3&)>;

SketchedCodes lookAt(const Codes& codes, const std::vector<SeedSketch>& sketches)
{
    const SketchInterval question(sketches, size);
    std::vector<int> read;
    for (const glm::ivec3& voxel : question.voxels())
        read.push_back(codes(voxel));
    return question.look(read);
}

/// A ball of one tissue in another, with noise of a deviation that is the same everywhere.
Codes ball(int inside, int outside, double radius, int noise)
{
    return [=](const glm::ivec3& voxel) {
        const double away = glm::length(glm::dvec3(voxel) - 20.0);
        // An edge is two voxels wide.
        const double part = glm::clamp(0.5 * (radius + 1.0 - away), 0.0, 1.0);
        test::Random random(std::uint32_t((voxel.z * 40 + voxel.y) * 40 + voxel.x + 1));
        int sum = 0; // twelve even numbers make nearly a normal one
        for (int i = 0; i < 12; ++i)
            sum += test::randomInt(random, -1000, 1000);
        return int(std::lround(outside + part * (inside - outside) + noise * sum / 2000.0));
    };
}

std::vector<glm::ivec3> line(const glm::ivec3& from, const glm::ivec3& step, int count)
{
    std::vector<glm::ivec3> voxels;
    for (int i = 0; i < count; ++i)
        voxels.push_back(from + i * step);
    return voxels;
}

bool holds(const CodeInterval& interval, int low, int high)
{
    return interval.low <= low && interval.high >= high;
}

} // namespace

class SketchIntervalTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aSketchOnASliceTellsItsTissue()
    {
        const Codes codes = ball(1000, 2000, 12.0, 20);
        const SketchedCodes seen = lookAt(codes, {{.voxels = line({12, 20, 20}, {1, 0, 0}, 16)}});
        QVERIFY(std::abs(seen.centre - 1000) < 15);
        const double deviation = seen.deviation256 / 256.0;
        QVERIFY2(deviation > 14.0 && deviation < 32.0, qPrintable(QString::number(deviation)));
        const CodeInterval offered = offeredInterval(seen, 640);
        QVERIFY(holds(offered, 970, 1030));
        QVERIFY(offered.low > 850 && offered.high < 1150);
    }

    /// σ of one voxel is none: it comes from the noise around.
    void oneSeedIsEnough()
    {
        const Codes codes = ball(1000, 2000, 12.0, 20);
        const SketchedCodes seen = lookAt(codes, {{.voxels = {{20, 20, 20}}}});
        QVERIFY(seen.voxels >= 30);
        QVERIFY(std::abs(seen.centre - 1000) < 20);
        QVERIFY(holds(offeredInterval(seen, 640), 970, 1030));
    }

    void withoutNoiseThereIsAnIntervalToo()
    {
        const Codes codes = ball(1000, 2000, 12.0, 0);
        const CodeInterval offered =
            offeredInterval(lookAt(codes, {{.voxels = {{20, 20, 20}}}}), 640);
        QVERIFY(holds(offered, 999, 1001));
        QVERIFY(offered.high < 1500);
    }

    /// The voxels that are seen are edge values, half of one tissue and half of the other; what is
    /// meant lies behind them.
    void aSketchOnASurfaceMeansWhatIsBehindIt()
    {
        const Codes codes = ball(2000, 1000, 12.0, 20);
        std::vector<glm::ivec3> surface;
        for (int x = 14; x <= 26; ++x) {
            for (int y = 0; y < 40; ++y) {
                if (codes({x, y, 20}) >= 1450) {
                    surface.emplace_back(x, y, 20);
                    break;
                }
            }
        }
        const SketchedCodes seen =
            lookAt(codes, {{.voxels = surface, .inward = glm::dvec3(0.0, 1.0, 0.0)}});
        QVERIFY2(std::abs(seen.centre - 2000) < 60, qPrintable(QString::number(seen.centre)));
        QVERIFY(seen.darker && std::abs(*seen.darker - 1000) < 200);
        const CodeInterval offered = offeredInterval(seen, 640);
        QVERIFY(offered.low > 1200 && offered.low < 1950);
        // Else growth could not begin.
        QVERIFY(4 * seedsWithin(seen, offered) >= int(seen.seeds.size()));
    }

    /// A stroke that goes too far is not the centre of everything.
    void aFewWrongVoxelsDoNotMatter()
    {
        const Codes codes = ball(1000, 2000, 12.0, 20);
        const SketchedCodes seen = lookAt(codes, {{.voxels = line({10, 20, 20}, {1, 0, 0}, 29)}});
        QVERIFY(std::abs(seen.centre - 1000) < 40);
        QVERIFY(seen.brighter && *seen.brighter > 1400);
        QVERIFY(offeredInterval(seen, 1024).high <= 2000 - (*seen.brighter - seen.centre) / 4);
    }

    /// However loose, a quarter of the way to another tissue is left to it.
    void threeQuartersOfTheWayAtMost()
    {
        SketchedCodes seen{.centre = 1000,
            .deviation256 = 256 * 500,
            .voxels = 40,
            .darker = 600,
            .seeds = {1000}};
        QCOMPARE(offeredInterval(seen, 1024).low, 700);
        QCOMPARE(offeredInterval(seen, 1024).high, 3000);
        seen.brighter = 1400;
        QCOMPARE(offeredInterval(seen, 1024).high, 1300);
        QCOMPARE(offeredInterval(seen, 64).high, 1125); // nearer than that
    }

    /// Tighter lies within looser.
    void moreDeviationsHoldMore()
    {
        const SketchedCodes seen =
            lookAt(ball(1000, 2000, 12.0, 20), {{.voxels = {{20, 20, 20}, {22, 20, 20}}}});
        CodeInterval before = offeredInterval(seen, 256);
        for (int sigmas256 = 320; sigmas256 <= 1280; sigmas256 += 64) {
            const CodeInterval next = offeredInterval(seen, sigmas256);
            QVERIFY(holds(next, before.low, before.high));
            before = next;
        }
    }

    void atTheBorderAndWithoutSeeds()
    {
        const Codes codes = ball(1000, 2000, 30.0, 20);
        QCOMPARE(lookAt(codes, {}).voxels, 0);
        QCOMPARE(offeredInterval({}, 640), CodeInterval());
        const SketchedCodes seen = lookAt(
            codes, {{.voxels = {{0, 20, 20}, {0, 21, 20}}, .inward = glm::dvec3(-1.0, 0.0, 0.0)}});
        QVERIFY(seen.voxels > 0);
        const SketchInterval corner({{.voxels = {{39, 39, 39}}}}, size);
        for (const glm::ivec3& voxel : corner.voxels())
            QVERIFY(glm::all(glm::lessThan(voxel, size)));
    }

    /// Long sketches do not cost more.
    void readsABoundedNumberOfVoxels()
    {
        std::vector<glm::ivec3> all;
        for (int z = 0; z < 40; ++z) {
            for (int y = 0; y < 40; ++y)
                all.emplace_back((y * 7 + z * 3) % 40, y, z);
        }
        QVERIFY(SketchInterval({{.voxels = all}}, size).voxels().size() <= 64 * 9 * 9 * 9);
        // Many short ones do not, either.
        std::vector<SeedSketch> sketches;
        for (const glm::ivec3& voxel : all)
            sketches.push_back({.voxels = {voxel}});
        const SketchInterval many(sketches, size);
        QVERIFY(many.voxels().size() <= 64 * 9 * 9 * 9);
        QVERIFY(
            many.look(std::vector<int>(many.voxels().size(), 7)).seeds.size() <= std::size_t(64));
    }
};

BURIN_TEST(SketchIntervalTest)

} // namespace sketchIntervalTest

#include "SketchIntervalTest.moc"
