// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/ShellPeel.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

namespace shellPeelTest {

using namespace core;
using test::Random;

namespace {

constexpr std::int32_t none = SurfaceHit::none;
constexpr std::int32_t pitch = 65536 / 2;

PeelSheet sheetOf(const glm::ivec2& size, const auto& heightMm)
{
    PeelSheet sheet{{-3, 5}, size, {}};
    for (int b = 0; b < size.y; ++b) {
        for (int a = 0; a < size.x; ++a) {
            const double z = heightMm(a * 0.5, b * 0.5);
            sheet.surface.push_back(std::isnan(z) ? none : std::int32_t(std::lround(z * 65536)));
        }
    }
    return sheet;
}

/// Rule 3 as it is written.
std::vector<std::int32_t> slowOffset(const PeelSheet& sheet, std::int64_t depth, bool restore)
{
    std::vector<std::int32_t> ends(sheet.surface.size(), none);
    const std::int64_t sign = restore ? -1 : 1;
    const auto at = [&](int a, int b) {
        return sheet.surface[std::size_t(a) + std::size_t(sheet.size.x) * std::size_t(b)];
    };
    for (int b = 0; b < sheet.size.y; ++b) {
        for (int a = 0; a < sheet.size.x; ++a) {
            if (at(a, b) == none)
                continue;
            std::int64_t end = std::numeric_limits<std::int64_t>::min();
            for (int q = 0; q < sheet.size.y; ++q) {
                for (int p = 0; p < sheet.size.x; ++p) {
                    const std::int64_t dx = std::int64_t(p - a) * pitch;
                    const std::int64_t dy = std::int64_t(q - b) * pitch;
                    const std::int64_t square = depth * depth - dx * dx - dy * dy;
                    if (square >= 0 && at(p, q) != none)
                        end = std::max(
                            end, sign * at(p, q) + std::int64_t(std::floor(std::sqrt(square))));
                }
            }
            ends[std::size_t(a) + std::size_t(sheet.size.x) * std::size_t(b)] =
                std::int32_t(sign * end);
        }
    }
    return ends;
}

} // namespace

class ShellPeelTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void offsetsAsTheRuleSays()
    {
        Random random(5);
        const int rounds = qEnvironmentVariableIsSet("BURIN_LONG") ? 60 : 12;
        for (int round = 0; round < rounds; ++round) {
            const glm::ivec2 size{test::randomInt(random, 1, 60), test::randomInt(random, 1, 40)};
            const double rough = round % 4 ? test::randomUnit(random) : 30.0;
            const double slope = 4.0 * test::randomUnit(random) - 2.0;
            const PeelSheet sheet = sheetOf(size, [&](double x, double y) {
                if (test::randomUnit(random) < 0.1)
                    return std::nan("");
                return slope * x - 0.05 * y * y + rough * test::randomUnit(random);
            });
            for (const double depthMm : {0.2, 0.5, 3.0, 11.0}) {
                const auto depth = std::int32_t(depthMm * 65536);
                QVERIFY(
                    offsetSurface(sheet, pitch, depth, false) == slowOffset(sheet, depth, false));
                QVERIFY(offsetSurface(sheet, pitch, depth, true) == slowOffset(sheet, depth, true));
            }
        }
    }

    /// No pile-ups and no gaps: the shell of a ball, seen from outside or from inside, is as thick
    /// as it was asked to be, at every slope.
    void shellsAreEven_data()
    {
        QTest::addColumn<double>("radiusMm");
        QTest::addColumn<bool>("convex");
        QTest::newRow("head") << 90.0 << true;
        QTest::newRow("knuckle") << 12.0 << true;
        QTest::newRow("bowl") << 90.0 << false;
        QTest::newRow("cup") << 25.0 << false;
    }
    void shellsAreEven()
    {
        QFETCH(double, radiusMm);
        QFETCH(bool, convex);
        constexpr double depthMm = 6.0;
        const int side = int(4.0 * radiusMm);
        const double middle = side * 0.25;
        // The surface is cut off where it turns away from the viewer by more than 70°.
        const double edge = radiusMm * std::sin(70.0 * M_PI / 180.0);
        const PeelSheet sheet = sheetOf({side, side}, [&](double x, double y) {
            const double away = std::hypot(x - middle, y - middle);
            const double z = std::sqrt(std::max(radiusMm * radiusMm - away * away, 0.0));
            return away > edge ? std::nan("") : convex ? -z : z;
        });
        const std::vector<std::int32_t> ends =
            offsetSurface(sheet, pitch, std::int32_t(depthMm * 65536), false);
        std::size_t i = 0;
        int looked = 0;
        for (int b = 0; b < side; ++b) {
            for (int a = 0; a < side; ++a, ++i) {
                const double away = std::hypot(a * 0.5 - middle, b * 0.5 - middle);
                // Near the edge of the curve what would reach in from outside is missing.
                if (ends[i] == none || away > edge - depthMm)
                    continue;
                const double z = ends[i] / 65536.0;
                const double thickness =
                    convex ? radiusMm - std::hypot(away, z) : std::hypot(away, z) - radiusMm;
                QVERIFY2(std::abs(thickness - depthMm) < 0.1,
                    qPrintable(QStringLiteral("%1 mm at %2").arg(thickness).arg(away)));
                ++looked;
            }
        }
        QVERIFY(looked > 100);
    }

    void onlyTheLargestSheetIsPeeled()
    {
        // A plate with a hole, through which something deeper is seen, and a step.
        ShellPeel peel;
        peel.mask.size = {20, 10};
        peel.mask.values.assign(200, 256);
        std::vector<SurfaceHit> hits(200);
        for (int i = 0; i < 200; ++i) {
            const int a = i % 20;
            const int b = i / 20;
            hits[std::size_t(i)].zSurface = a >= 14 ? 20 * 65536 : 65536 * a / 2;
            if (a == 5 && b > 2 && b < 6)
                hits[std::size_t(i)].zSurface = 40 * 65536;
            if (a == 3)
                hits[std::size_t(i)] = SurfaceHit{};
        }
        peel.jump = 2 * 65536;
        const PeelSheet sheet = peelSheet(peel, hits);
        for (int i = 0; i < 200; ++i) {
            const int a = i % 20;
            const int b = i / 20;
            const bool hole = a == 5 && b > 2 && b < 6;
            QCOMPARE(sheet.surface[std::size_t(i)] != none, a > 3 && a < 14 && !hole);
        }
        peel.jump = -1;
        const PeelSheet all = peelSheet(peel, hits);
        QCOMPARE(std::count(all.surface.begin(), all.surface.end(), none), std::ptrdiff_t(10));
    }

    void largePeels()
    {
        // Half a head at 256 elements across, 30 mm deep.
        const PeelSheet sheet = sheetOf({256, 256}, [](double x, double y) {
            const double away = std::hypot(x - 64.0, y - 64.0);
            return away > 62.0 ? std::nan("")
                               : -std::sqrt(90.0 * 90.0 - away * away) + 0.3 * std::sin(x * 3.0);
        });
        std::vector<std::int32_t> ends;
        QBENCHMARK_ONCE
        {
            ends = offsetSurface(sheet, pitch, 30 * 65536, false);
        }
        QCOMPARE(ends.size(), sheet.surface.size());
    }
};

BURIN_PLAIN_TEST(ShellPeelTest)

} // namespace shellPeelTest

#include "ShellPeelTest.moc"
