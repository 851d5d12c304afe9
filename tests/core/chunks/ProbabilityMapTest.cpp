// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/ProbabilityMap.h"

#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <limits>
#include <random>

namespace probabilityMapTest {

using core::ProbabilityMap;

/// Probability maps as bytes, and as an edit stores them.
class ProbabilityMapTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aHalfBelongs()
    {
        QCOMPARE(int(ProbabilityMap::byteOf(0.0)), 0);
        QCOMPARE(int(ProbabilityMap::byteOf(1.0)), 255);
        QVERIFY(ProbabilityMap::byteOf(0.5) >= ProbabilityMap::half);
        QVERIFY(ProbabilityMap::byteOf(0.498) < ProbabilityMap::half);
        QCOMPARE(int(ProbabilityMap::byteOf(-3.0)), 0);
        QCOMPARE(int(ProbabilityMap::byteOf(3.0)), 255);
        QCOMPARE(int(ProbabilityMap::byteOf(std::numeric_limits<double>::quiet_NaN())), 0);
    }

    void comesBackToTheByte()
    {
        std::mt19937 random(5);
        std::vector<std::uint8_t> bytes(40000);
        for (std::uint8_t& byte : bytes)
            byte = std::uint8_t(random());
        const QByteArray packed = ProbabilityMap::packed(bytes);
        QVERIFY(ProbabilityMap::isOf(packed, bytes.size()));
        QCOMPARE(ProbabilityMap::unpacked(packed, bytes.size()), std::optional(bytes));
    }

    void whatIsDamagedOrOfAnotherVolumeIsNone()
    {
        const QByteArray packed = ProbabilityMap::packed(std::vector<std::uint8_t>(5000, 7));
        QVERIFY(!ProbabilityMap::unpacked(packed, 4999));
        QVERIFY(!ProbabilityMap::unpacked(packed, 5001));
        QVERIFY(!ProbabilityMap::unpacked(packed.left(packed.size() - 1), 5000));
        QVERIFY(!ProbabilityMap::unpacked({}, 5000));
        QVERIFY(!ProbabilityMap::unpacked("no such thing", 5000));
    }
};

BURIN_TEST(ProbabilityMapTest)

} // namespace probabilityMapTest

#include "ProbabilityMapTest.moc"
