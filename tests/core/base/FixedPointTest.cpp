// SPDX-License-Identifier: Apache-2.0
#include "core/base/FixedPoint.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <cstdint>
#include <random>

namespace fixedPointTest {

namespace fixedPoint = core::fixedPoint;

/// A number of at most as many bits as were drawn, so that small ones come as often as large ones.
static std::int64_t anyNumber(std::mt19937_64& random, int bits)
{
    return std::int64_t(random() >> (63 - random() % std::uint64_t(bits)));
}

class FixedPointTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// Also where a double no longer holds every whole number.
    void rootsAreRoundedDown()
    {
        std::mt19937_64 random(3);
        for (int i = 0; i < 100'000; ++i) {
            const std::int64_t root = anyNumber(random, 31);
            const std::int64_t square = root * root;
            QCOMPARE(fixedPoint::squareRoot(square), root);
            QCOMPARE(fixedPoint::squareRoot(square + 2 * root), root);
            if (root > 0)
                QCOMPARE(fixedPoint::squareRoot(square - 1), root - 1);
        }
        QCOMPARE(fixedPoint::squareRoot(std::int64_t(1) << 62), std::int64_t(1) << 31);
        QCOMPARE(fixedPoint::squareRoot((std::int64_t(1) << 62) - 1), (std::int64_t(1) << 31) - 1);
    }

    void quotientsAreRoundedDown()
    {
        std::mt19937_64 random(5);
        for (int i = 0; i < 100'000; ++i) {
            const std::int64_t divisor = anyNumber(random, 31) + 1;
            const std::int64_t quotient = anyNumber(random, 30) * (random() % 2 ? 1 : -1);
            const std::int64_t rest = std::int64_t(random() % std::uint64_t(divisor));
            QCOMPARE(fixedPoint::floorDivide(quotient * divisor + rest, divisor), quotient);
        }
    }

    void halvesAreRoundedUp()
    {
        for (const std::int64_t whole : {-70'000, -1, 0, 1, 70'000}) {
            const std::int64_t half = std::int64_t(1) << 13;
            QCOMPARE(fixedPoint::round14(whole * 2 * half + half), whole + 1);
            QCOMPARE(fixedPoint::round14(whole * 2 * half + half - 1), whole);
            QCOMPARE(fixedPoint::round14(whole * 2 * half - half), whole);
            const std::int64_t large = std::int64_t(1) << 29;
            QCOMPARE(fixedPoint::round30(whole * 2 * large + large), whole + 1);
            QCOMPARE(fixedPoint::round30(whole * 2 * large + large - 1), whole);
            QCOMPARE(fixedPoint::round30(whole * 2 * large - large), whole);
        }
    }
};

BURIN_TEST(FixedPointTest)

} // namespace fixedPointTest

#include "FixedPointTest.moc"
