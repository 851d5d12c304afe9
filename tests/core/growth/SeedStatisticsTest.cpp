// SPDX-License-Identifier: Apache-2.0
#include "core/growth/SeedStatistics.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <cmath>
#include <vector>

namespace seedStatisticsTest {

using namespace core;

namespace {

SeedSums sumsOf(const std::vector<int>& codes)
{
    SeedSums sums;
    for (const int code : codes) {
        ++sums.voxels;
        sums.codes += std::uint64_t(code);
        sums.squares += std::uint64_t(code) * std::uint64_t(code);
    }
    return sums;
}

} // namespace

class SeedStatisticsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void isMeanAndDeviation()
    {
        test::Random random(7);
        for (int number = 0; number < 400; ++number) {
            const int low = test::randomInt(random, 0, 65535);
            const int high =
                test::randomInt(random, low, number % 2 ? 65535 : std::min(low + 40, 65535));
            std::vector<int> codes;
            for (int i = test::randomInt(random, 1, 3000); i > 0; --i)
                codes.push_back(test::randomInt(random, low, high));
            double mean = 0.0;
            for (const int code : codes)
                mean += code;
            mean /= double(codes.size());
            double variance = 0.0;
            for (const int code : codes)
                variance += (code - mean) * (code - mean);
            variance /= double(codes.size());
            const SeedMoments spread = seedMoments(sumsOf(codes));
            QVERIFY(std::abs(double(spread.mean256) / 256.0 - mean) <= 1.0 / 256.0 + 1e-9);
            // Of the variance 2⁻¹⁰ is lost at most.
            QVERIFY(std::abs(double(spread.deviation256) / 256.0 - std::sqrt(variance))
                <= 0.5 / 256.0 + 0.04);
            QVERIFY(
                double(spread.deviation256) / 256.0 >= std::sqrt(variance) - 1.0 / 256.0 - 1e-9);
        }
    }

    void intervalIsInclusive()
    {
        QCOMPARE(seedInterval(sumsOf({10, 11}), 256), (CodeInterval{10, 11}));
        QCOMPARE(seedInterval(sumsOf({10, 11}), 255), (CodeInterval{11, 10}));
        QCOMPARE(seedInterval(sumsOf({10, 12}), 256), (CodeInterval{10, 12}));
        QCOMPARE(seedInterval(sumsOf({10, 12}), 512), (CodeInterval{9, 13}));
        QCOMPARE(seedInterval(sumsOf({7, 7, 7}), 25600), (CodeInterval{7, 7}));
        QCOMPARE(seedInterval(sumsOf({0, 65535}), 25600), (CodeInterval{0, 65535}));
        const CodeInterval none = seedInterval({}, 25600);
        QVERIFY(none.low > none.high);
    }

    void manyVoxelsDoNotOverflow()
    {
        // 2³⁰ at either end of the range.
        const std::uint64_t half = std::uint64_t(1) << 30;
        const SeedSums sums{2 * half, half * 65535, half * 65535 * 65535};
        const SeedMoments spread = seedMoments(sums);
        QCOMPARE(spread.mean256, std::int64_t(65535 * 128));
        QCOMPARE(spread.deviation256, std::int64_t(65535 * 128));
    }
};

BURIN_TEST(SeedStatisticsTest)

} // namespace seedStatisticsTest

#include "SeedStatisticsTest.moc"
