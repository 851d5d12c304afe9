// SPDX-License-Identifier: Apache-2.0
#include "gpu/shaders/RecentPrograms.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <memory>
#include <new>

namespace recentProgramsTest {

/// Which programs are kept. Numbers stand for them, as no context is needed to count.
class RecentProgramsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void aProgramIsMadeOnce();
    void theLeastRecentlyUsedGoes();
    void whatCannotBeMadeLeavesNothing();

private:
    using Programs = gpu::RecentPrograms<int, int, 3>;
    /// @return whether the program had to be made
    static bool made(Programs& programs, int kind)
    {
        bool isMade = false;
        const auto program = programs.of(kind, [&] {
            isMade = true;
            return std::make_shared<int>(kind);
        });
        return isMade && *program == kind;
    }
};

void RecentProgramsTest::aProgramIsMadeOnce()
{
    Programs programs;
    for (const int kind : {7, 0, 9})
        QVERIFY(made(programs, kind));
    for (const int kind : {9, 7, 0, 0, 9})
        QVERIFY(!made(programs, kind));
    const auto other = [] { return std::make_shared<int>(-1); };
    QCOMPARE(*programs.of(7, other), 7);
    QCOMPARE(programs.count(), std::size_t(3));
}

void RecentProgramsTest::theLeastRecentlyUsedGoes()
{
    Programs programs;
    for (const int kind : {1, 2, 3})
        QVERIFY(made(programs, kind));
    QVERIFY(!made(programs, 1)); // 2 is the oldest now
    QVERIFY(made(programs, 4));
    QCOMPARE(programs.count(), std::size_t(3));
    for (const int kind : {1, 3, 4})
        QVERIFY(!made(programs, kind));
    QVERIFY(made(programs, 2)); // and 1 goes
    QVERIFY(!made(programs, 3));
    QVERIFY(made(programs, 1));
    QCOMPARE(programs.count(), std::size_t(3));
}

void RecentProgramsTest::whatCannotBeMadeLeavesNothing()
{
    Programs programs;
    bool refused = false;
    try {
        static_cast<void>(programs.of(1, []() -> std::shared_ptr<int> { throw std::bad_alloc(); }));
    } catch (const std::bad_alloc&) {
        refused = true;
    }
    QVERIFY(refused);
    QCOMPARE(programs.count(), std::size_t(0));
    QVERIFY(made(programs, 1));
}

BURIN_TEST(RecentProgramsTest)

} // namespace recentProgramsTest

#include "RecentProgramsTest.moc"
