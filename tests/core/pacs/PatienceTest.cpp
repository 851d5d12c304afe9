// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/Patience.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace patienceTest {

using core::Patience;
using std::chrono::milliseconds;
using std::chrono::seconds;
using Lost = core::Patience::Lost;

/// When another machine is given up, told by times and not by waiting.
class PatienceTest : public QObject {
    Q_OBJECT

    static constexpr Patience::Clock::time_point begin{};

private Q_SLOTS:
    void silence()
    {
        Patience patience(seconds(4), {}, begin);
        QVERIFY(patience.lost(begin + milliseconds(3999)) == Lost::No);
        QVERIFY(patience.lost(begin + seconds(4)) == Lost::Silence);
        patience.passed(100'000, begin + seconds(3));
        QVERIFY(patience.lost(begin + milliseconds(6999)) == Lost::No);
        QVERIFY(patience.lost(begin + seconds(7)) == Lost::Silence);
        QVERIFY(patience.lastSign() == begin + seconds(3));
        patience.whole(begin + seconds(5));
        QVERIFY(patience.lastSign() == begin + seconds(5));
    }

    void aByteASecond()
    {
        Patience patience(seconds(4), {}, begin);
        for (int second = 1; second < 4; ++second) {
            patience.passed(1, begin + seconds(second));
            QVERIFY(patience.lost(begin + seconds(second)) == Lost::No);
        }
        patience.passed(1, begin + seconds(4));
        QVERIFY(patience.lost(begin + seconds(4)) == Lost::Dripping);
        // What is whole counts, however small it is.
        patience.whole(begin + seconds(4));
        QVERIFY(patience.lost(begin + milliseconds(7999)) == Lost::No);
    }

    void slowIsNotDripping()
    {
        Patience patience(seconds(4), {}, begin);
        for (int second = 1; second < 10'000; ++second) {
            patience.passed(1024, begin + seconds(second));
            QVERIFY(patience.lost(begin + seconds(second)) == Lost::No);
        }
        // And what came before buys no silence.
        QVERIFY(patience.lost(begin + seconds(10'003)) == Lost::Silence);
    }

    void aQuestionHasAnEnd()
    {
        Patience patience(seconds(4), Patience::ofQuestion(4), begin);
        for (int second = 1; second < 40; ++second) {
            patience.whole(begin + seconds(second));
            QVERIFY(patience.lost(begin + seconds(second)) == Lost::No);
        }
        QVERIFY(patience.lost(begin + seconds(40)) == Lost::Whole);
        QCOMPARE(patience.error(QStringLiteral("X"), Lost::Whole).arguments.value(1),
            QStringLiteral("40"));
    }
};

BURIN_TEST(PatienceTest)

} // namespace patienceTest

#include "PatienceTest.moc"
