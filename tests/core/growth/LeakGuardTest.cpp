// SPDX-License-Identifier: Apache-2.0
#include "core/growth/LeakGuard.h"
#include "core/growth/SeedWord.h"
#include "tests/reference/growth/FrontWatch.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

namespace leakGuardTest {

using namespace core;

namespace {

// An organ around the origin, 11 mm in radius with a lobe; through a hole in its wall, 2 mm in
// radius and 4 mm long, it leaks along y into a ball of 12 mm.
constexpr double organMm = 11.0;
constexpr double neckMm = 2.0;
constexpr double neckEndMm = 15.0;
constexpr double leakMm = 12.0;
constexpr double leakMiddleMm = neckEndMm + 11.5;

/// A vessel that gets wider by nature, from 1.5 to 2.6 mm in radius.
bool inVessel(const glm::dvec3& mm)
{
    return std::hypot(mm.x, mm.z) <= (mm.y < 8.0 ? 1.5 : 2.6);
}

bool inOrgan(const glm::dvec3& mm)
{
    return glm::length(mm) <= organMm || glm::length(mm - glm::dvec3(8.0, -6.0, 3.0)) <= 8.0;
}

bool inLeak(const glm::dvec3& mm)
{
    return mm.y > neckEndMm - 0.5 && glm::length(mm - glm::dvec3(0.0, leakMiddleMm, 0.0)) <= leakMm;
}

bool inNeck(const glm::dvec3& mm)
{
    return mm.y > 0.0 && mm.y <= neckEndMm && std::hypot(mm.x, mm.z) <= neckMm;
}

enum class Anatomy { LeakyOrgan, Organ, Vessel };

/// How a growth over faces went, until it was alarmed or at its end.
struct Watched {
    std::optional<LeakAlarm> alarm;
    double leakPart = 0.0; ///< that was taken
    double narrowYMm = 0.0; ///< where the front of the narrow place was, in the middle
};

Watched watch(const glm::dvec3& spacingMm, Anatomy anatomy, const GuardRule& rule)
{
    const bool leaks = anatomy == Anatomy::LeakyOrgan;
    const bool vessel = anatomy == Anatomy::Vessel;
    const glm::dvec3 seedMm = vessel ? glm::dvec3(0.0, -18.0, 0.0) : glm::dvec3(-6.0, 0.0, 0.0);
    const glm::dvec3 lowMm(-20.0, -20.0, -15.0);
    const glm::dvec3 highMm(20.0, 40.0, 15.0);
    const BrickGrid grid{glm::ivec3(glm::ceil((highMm - lowMm) / spacingMm)) + 1};
    const glm::ivec3 size = grid.volumeSize;
    const glm::dvec3 origin = glm::round(lowMm / spacingMm) * spacingMm; // a voxel lies at 0
    const auto mm = [&](const glm::ivec3& voxel) { return origin + glm::dvec3(voxel) * spacingMm; };
    reference::DenseArray<std::uint8_t> open{size, {}};
    double leakVoxels = 0.0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec3 place = mm({x, y, z});
                const bool leak = leaks && inLeak(place);
                leakVoxels += leak ? 1.0 : 0.0;
                const bool inside =
                    vessel ? inVessel(place) : inOrgan(place) || (leaks && inNeck(place));
                open.values.push_back(leak ? 2 : inside ? 1 : 0);
            }
        }
    }
    Watched watched;
    LeakGuard guard(grid, rule);
    std::vector<glm::ivec3> front{glm::ivec3(glm::round((seedMm - origin) / spacingMm))};
    open.at(front[0]) = 0;
    std::vector<std::vector<glm::ivec3>> fronts{{}};
    for (std::uint32_t generation = 1; !front.empty() && !watched.alarm; ++generation) {
        std::vector<LeakGuard::Voxel> told;
        for (const glm::ivec3& voxel : front)
            told.push_back(BrickVoxel::of(grid, voxel));
        watched.alarm = guard.look(generation, told);
        fronts.push_back(front);
        std::vector<glm::ivec3> next;
        for (const glm::ivec3& voxel : front) {
            for (std::size_t direction = 0; direction < 6; ++direction) {
                const auto& offset = seedWord::offsets[direction];
                const glm::ivec3 to = voxel + glm::ivec3(offset[0], offset[1], offset[2]);
                if (!open.contains(to) || open.at(to) == 0)
                    continue;
                watched.leakPart += open.at(to) == 2 ? 1.0 / leakVoxels : 0.0;
                open.at(to) = 0;
                next.push_back(to);
            }
        }
        front = std::move(next);
    }
    if (!watched.alarm)
        return watched;
    double farthest = -1e9;
    for (const glm::ivec3& voxel : fronts[watched.alarm->narrow])
        farthest = std::max(farthest, mm(voxel).y);
    watched.narrowYMm = farthest;
    return watched;
}

/// What *stop at leaks* asks for to begin with.
GuardRule usual(const glm::dvec3& spacingMm)
{
    return {.factor256 = 512,
        .excess = 60'000'000,
        .window = 20'000,
        .measure = frontMeasure(spacingMm)};
}

/// Both watch one growth from some seeds, each generation. @return how many alarm
int alarmsOfBoth(test::Codes codes, const GuardRule& rule, int connectivity, test::Random& random)
{
    const BrickGrid grid{codes.size};
    LeakGuard guard(grid, rule);
    reference::FrontWatch watch(codes.size, rule);
    std::vector<glm::ivec3> front;
    for (int seed = 0; seed < 3; ++seed)
        front.push_back(test::randomVoxel(random, codes.size));
    const auto isLess = [](const glm::ivec3& a, const glm::ivec3& b) {
        return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
    };
    std::sort(front.begin(), front.end(), isLess);
    front.erase(std::unique(front.begin(), front.end()), front.end());
    for (const glm::ivec3& voxel : front)
        codes.at(voxel) = 0;
    int alarms = 0;
    for (std::uint32_t generation = 1; !front.empty(); ++generation) {
        std::vector<LeakGuard::Voxel> told;
        for (const glm::ivec3& voxel : front)
            told.push_back(BrickVoxel::of(grid, voxel));
        const std::optional<LeakAlarm> alarm = guard.look(generation, told);
        if (alarm != watch.look(generation, front))
            return -1000000;
        alarms += alarm ? 1 : 0;
        std::vector<glm::ivec3> next;
        for (const glm::ivec3& voxel : front) {
            for (int direction = 0; direction < connectivity; ++direction) {
                const auto& offset = seedWord::offsets[std::size_t(direction)];
                const glm::ivec3 to = voxel + glm::ivec3(offset[0], offset[1], offset[2]);
                if (!codes.contains(to) || codes.at(to) < test::tissueCode / 2)
                    continue;
                codes.at(to) = 0;
                next.push_back(to);
            }
        }
        front = std::move(next);
    }
    return alarms;
}

/// A chamber from which a corridor of 3 × 3 voxels leads into a larger one.
test::Codes chambers()
{
    test::Codes codes = test::constantVolume({40, 32, 32}, 0);
    const auto dig = [&codes](const glm::ivec3& from, const glm::ivec3& to) {
        for (int z = from.z; z < to.z; ++z) {
            for (int y = from.y; y < to.y; ++y) {
                for (int x = from.x; x < to.x; ++x)
                    codes.at({x, y, z}) = test::tissueCode;
            }
        }
    };
    dig({0, 9, 9}, {12, 22, 22});
    dig({12, 14, 14}, {20, 17, 17});
    dig({20, 2, 2}, {40, 30, 30});
    return codes;
}

/// What a guard says of each generation of a growth over faces from one end of the chambers, which
/// begin at this voxel of a larger volume.
std::vector<std::optional<LeakAlarm>> alarmsAt(const glm::ivec3& begin, const BrickGrid& grid)
{
    test::Codes codes = chambers();
    LeakGuard guard(grid, {.factor256 = 512, .excess = 12, .window = 10});
    std::vector<glm::ivec3> front{{0, 15, 15}};
    codes.at(front[0]) = 0;
    std::vector<std::optional<LeakAlarm>> alarms;
    for (std::uint32_t generation = 1; !front.empty(); ++generation) {
        std::vector<LeakGuard::Voxel> told;
        for (const glm::ivec3& voxel : front)
            told.push_back(BrickVoxel::of(grid, begin + voxel));
        alarms.push_back(guard.look(generation, told));
        std::vector<glm::ivec3> next;
        for (const glm::ivec3& voxel : front) {
            for (std::size_t direction = 0; direction < 6; ++direction) {
                const auto& offset = seedWord::offsets[direction];
                const glm::ivec3 to = voxel + glm::ivec3(offset[0], offset[1], offset[2]);
                if (!codes.contains(to) || codes.at(to) == 0)
                    continue;
                codes.at(to) = 0;
                next.push_back(to);
            }
        }
        front = std::move(next);
    }
    return alarms;
}

} // namespace

/// The leak guard measures fronts in mm²: one anatomy alarms it at one place, however finely it was
/// scanned, and none that does not leak does.
class LeakGuardTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void spacings_data()
    {
        QTest::addColumn<double>("inPlane");
        QTest::addColumn<double>("between");
        QTest::newRow("0.3 mm") << 0.3 << 0.3;
        QTest::newRow("0.7 mm") << 0.7 << 0.7;
        QTest::newRow("1.5 mm") << 1.5 << 1.5;
        QTest::newRow("0.3 x 0.3 x 3 mm") << 0.3 << 3.0;
    }
    void spacings()
    {
        QFETCH(double, inPlane);
        QFETCH(double, between);
        const glm::dvec3 spacing(inPlane, inPlane, between);
        const Watched leaking = watch(spacing, Anatomy::LeakyOrgan, usual(spacing));
        QVERIFY(leaking.alarm);
        qInfo("alarm at %.0f mm², narrow place at y = %.1f mm, %.1f %% of the leak taken",
            double(leaking.alarm->areaUm2) / 1.0e6, leaking.narrowYMm, 100.0 * leaking.leakPart);
        QVERIFY2(leaking.narrowYMm > organMm - 2.0 && leaking.narrowYMm < neckEndMm + 4.0,
            QByteArray::number(leaking.narrowYMm).constData());
        QVERIFY2(leaking.leakPart < 0.08, QByteArray::number(leaking.leakPart).constData());
        for (const Anatomy sound : {Anatomy::Organ, Anatomy::Vessel}) {
            const Watched watched = watch(spacing, sound, usual(spacing));
            QVERIFY2(!watched.alarm,
                QByteArray::number(watched.alarm ? watched.alarm->generation : 0).constData());
        }
    }

    /// As recipes of before ask for it: the finer the scan, the sooner.
    void voxelsCanStillBeCounted()
    {
        QVERIFY(watch(glm::dvec3(0.3), Anatomy::Vessel, GuardRule{}).alarm);
        QVERIFY(!watch(glm::dvec3(1.5), Anatomy::Vessel, GuardRule{}).alarm);
        const Watched counted = watch(glm::dvec3(0.3), Anatomy::LeakyOrgan, GuardRule{});
        QVERIFY(counted.alarm);
        QCOMPARE(counted.alarm->areaUm2, std::int64_t(0));
    }

    /// Generation by generation the same as the oracle, measured and counted.
    void isTheOraclesToTheBit()
    {
        int alarms = 0;
        for (int number = 0; number < 60; ++number) {
            test::Random random{std::uint32_t(number)};
            const glm::ivec3 size(test::randomInt(random, 8, 30), test::randomInt(random, 8, 30),
                test::randomInt(random, 8, 30));
            test::Codes codes =
                number % 3 ? test::balls(size, 9, random) : test::noiseVolume(size, 1600, random);
            GuardRule rule{.factor256 = test::randomInt(random, 256, 600),
                .excess = test::randomInt(random, 0, 12),
                .window = test::randomInt(random, 1, 9)};
            if (number % 4 != 0) {
                const glm::dvec3 spacing(0.1 * test::randomInt(random, 2, 9),
                    0.1 * test::randomInt(random, 2, 9), 0.1 * test::randomInt(random, 2, 40));
                rule.measure = frontMeasure(spacing);
                rule.excess *= rule.measure->areaUm2[7];
                rule.window *= std::int64_t(1000.0 * spacing.x);
            }
            alarms += alarmsOfBoth(codes, rule, number % 2 ? 6 : number % 4 ? 18 : 26, random);
        }
        QVERIFY2(alarms > 20, QByteArray::number(alarms).constData());
    }

    /// A volume may have more than 2³² voxels. Its bricks from the 2²⁰th on, here those from z =
    /// 1024 on, are others than the first.
    void volumesMayBeLarge()
    {
        const glm::ivec3 begin(1024, 1024, 1008);
        const BrickGrid large{{2048, 2048, 1040}};
        QVERIFY(large.brickCount() > 1 << 20);
        const auto small = alarmsAt(glm::ivec3(0), {{40, 32, 32}});
        const auto there = alarmsAt(begin, large);
        QCOMPARE(there.size(), small.size());
        int alarms = 0;
        for (std::size_t generation = 0; generation < small.size(); ++generation) {
            std::optional<LeakAlarm> expected = small[generation];
            if (expected) {
                ++alarms;
                expected->voxel += begin;
            }
            QVERIFY(there[generation] == expected);
        }
        QVERIFY(alarms > 0);
    }

    void areasAreThoseOfPlanes()
    {
        const FrontMeasure measure = frontMeasure({0.3, 0.4, 2.0});
        QCOMPARE(measure.areaUm2[1], std::int64_t(800000));
        QCOMPARE(measure.areaUm2[2], std::int64_t(600000));
        QCOMPARE(measure.areaUm2[3], std::int64_t(1000000));
        QCOMPARE(measure.areaUm2[4], std::int64_t(120000));
        QCOMPARE(measure.areaUm2[0], std::int64_t(120000));
        QCOMPARE(measure.volumeUm3, std::int64_t(240000000));
        QVERIFY(isSound(GuardRule{.measure = measure}));
        QVERIFY(isSound(GuardRule{.measure = frontMeasure({1e-9, 0.5, 1e9})}));
        GuardRule odd;
        odd.window = 0;
        QVERIFY(!isSound(odd));
    }
};

BURIN_PLAIN_TEST(LeakGuardTest)

} // namespace leakGuardTest

#include "LeakGuardTest.moc"
