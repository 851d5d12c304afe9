// SPDX-License-Identifier: Apache-2.0
#include "core/base/MemoryReserve.h"
#include "tests/support/cases/RandomHistory.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/Sanitizer.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <atomic>
#include <cstdlib>
#include <mutex>
#include <new>
#include <random>

namespace refusedNewGlTest {

// This program's operator new. Of its own code's allocations (not those of libraries, among them
// the driver) one of at least a brick is refused now and then.

extern "C" {
extern char __executable_start;
extern char etext;
}

namespace {

constexpr std::size_t least = 4096;

std::atomic<bool> armed = false;
std::atomic<int> counted = 0;
std::atomic<int> refusals = 0;
std::atomic<int> next = 0;

std::mutex lotMutex;
std::mt19937 lot;

[[maybe_unused]] bool refuses(std::size_t bytes, const void* caller)
{
    if (!armed || bytes < least || caller < &__executable_start || caller >= &etext)
        return false;
    const int call = ++counted;
    if (call != next)
        return false;
    const std::lock_guard lock(lotMutex);
    next = call + 3 + int(lot() % 14u);
    ++refusals;
    return true;
}

} // namespace

} // namespace refusedNewGlTest

#if !__has_feature(address_sanitizer) // whose own these would replace for all tests of the program
void* operator new(std::size_t bytes)
{
    if (refusedNewGlTest::refuses(bytes, __builtin_return_address(0)))
        throw core::MemoryRefused(bytes);
    if (void* place = std::malloc(bytes > 0 ? bytes : 1))
        return place;
    throw core::MemoryRefused(bytes);
}

void operator delete(void* place) noexcept
{
    std::free(place);
}

void operator delete(void* place, std::size_t) noexcept
{
    std::free(place);
}
#endif

namespace refusedNewGlTest {

/// A hasty user whose program gets no memory now and then, on whatever thread asks for it: a step
/// is carried out whole or refused with everything as it was, or the session has to be opened
/// again, and holds what its history says.
class RefusedNewGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY2(m_gpu.isReady(), m_gpu.why()); }
    void aSessionGoesOn_data();
    void aSessionGoesOn();

private:
    test::EditEngineFixture m_gpu;
};

void RefusedNewGlTest::aSessionGoesOn_data()
{
    QTest::addColumn<uint>("seed");
    for (uint seed = 71; seed < (test::longRun() ? 91u : 72u); ++seed)
        QTest::addRow("seed %u", seed) << seed;
}

void RefusedNewGlTest::aSessionGoesOn()
{
    QFETCH(uint, seed);
    lot.seed(seed);
    counted = 0;
    refusals = 0;
    next = 3;
    const test::RandomHistory history = test::runRandomHistory(
        m_gpu.engine(), test::longRun() ? 1000 : 100, seed, [](bool acting) { armed = acting; });
    armed = false;
    int done = 0;
    for (const auto& [what, count] : history.done)
        done += count;
    int reopened = 0;
    for (const auto& [what, count] : history.refused)
        reopened += what.contains(QLatin1String("lost")) ? count : 0;
    qInfo("%d of %d refused, %d steps done, opened again %d times", int(refusals), int(counted),
        done, reopened);
    QVERIFY2(history.failure.isEmpty(), qPrintable(history.failure));
    QVERIFY(refusals > 10);
    QVERIFY(done > 15);
}

BURIN_TEST(RefusedNewGlTest)

} // namespace refusedNewGlTest

#include "RefusedNewGlTest.moc"
