// SPDX-License-Identifier: Apache-2.0
#include "core/base/Guarded.h"
#include "core/base/MemoryReserve.h"
#include "core/base/ParallelFor.h"
#include "core/base/TaskThread.h"
#include "tests/support/program/Sanitizer.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include <sys/resource.h>

namespace guardedTest {

using namespace core;

namespace {

/// While it lives the system starts no further thread: there is no room for its stack.
class NoThreads {
public:
    NoThreads()
    {
        getrlimit(RLIMIT_AS, &m_before);
        const rlimit none{addressSpaceBytes(), m_before.rlim_max};
        setrlimit(RLIMIT_AS, &none);
    }
    ~NoThreads() { setrlimit(RLIMIT_AS, &m_before); }
    NoThreads(const NoThreads&) = delete;
    NoThreads& operator=(const NoThreads&) = delete;

private:
    rlimit m_before{};
};

char* volatile place = nullptr;

std::size_t tooMuch()
{
    static volatile std::size_t bytes = std::size_t(1) << 60;
    return bytes;
}

} // namespace

/// Whatever is thrown on a thread of this program is an error of whoever waits for it.
class GuardedTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// First: the room of threads that have ended is used again.
    void workIsDoneWhereNoThreadCanBeStarted();
    void whatIsThrownIsTheError();
    void resultsPassThrough();
    void tasksTellWhatTheyThrow();
    void whoWaitsForATaskGetsWhatItThrows();
    void aLoneTaskIsDoneBesideItsOwner();
    void parallelWorkThrowsOnce();
    void theReserveIsThereOnce();
};

void GuardedTest::whatIsThrownIsTheError()
{
    const auto errorOf = [](auto work) { return guarded(work).error(); };
    QCOMPARE(errorOf([] { throw std::bad_alloc(); }).code, ErrorCode::OutOfMemory);
    const Error named = errorOf([] { throw MemoryRefused(12'345'678); });
    QCOMPARE(named.code, ErrorCode::OutOfMemory);
    QVERIFY2(named.arguments.value(0).contains(QLatin1String("12 MB")),
        qPrintable(named.arguments.value(0)));
    if (!test::underSanitizer)
        QCOMPARE(errorOf([] { place = new char[tooMuch()]; }).code, ErrorCode::OutOfMemory);
    const Error told = errorOf([] { throw std::runtime_error("why"); });
    QCOMPARE(told.code, ErrorCode::Internal);
    QCOMPARE(told.arguments.value(0), QStringLiteral("why"));
    QCOMPARE(errorOf([] { throw 7; }).code, ErrorCode::Internal);
}

void GuardedTest::resultsPassThrough()
{
    const Result<int> seven = guarded([]() -> Result<int> { return 7; });
    QVERIFY(seven);
    QCOMPARE(*seven, 7);
    const Result<int> none = guarded([]() -> Result<int> { return failure(ErrorCode::Cancelled); });
    QCOMPARE(none.error().code, ErrorCode::Cancelled);
    QVERIFY(guarded([] {}));
}

void GuardedTest::tasksTellWhatTheyThrow()
{
    std::vector<QString> told;
    {
        TaskThread thread;
        const auto tell = [&told](const Error& error) { told.push_back(error.arguments.value(0)); };
        thread.post([] { throw std::runtime_error("first"); }, tell);
        thread.post([] {}, tell);
        thread.post([] { throw std::runtime_error("third"); }, tell);
        thread.finish();
    }
    QCOMPARE(told, (std::vector<QString>{QStringLiteral("first"), QStringLiteral("third")}));
}

void GuardedTest::whoWaitsForATaskGetsWhatItThrows()
{
    TaskThread thread;
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, thread.run([] { throw std::runtime_error("x"); }));
    bool done = false;
    thread.run([&done] { done = true; });
    QVERIFY(done);
}

void GuardedTest::aLoneTaskIsDoneBesideItsOwner()
{
    std::thread::id where;
    LoneTask task([&where] { where = std::this_thread::get_id(); });
    task.finish();
    QVERIFY(where != std::thread::id());
    QVERIFY(where != std::this_thread::get_id());

    LoneTask failing([] { throw std::runtime_error("x"); });
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, failing.finish());

    // Whoever leaves without asking for it waits for it all the same.
    bool done = false;
    {
        const LoneTask left([&done] {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            done = true;
        });
    }
    QVERIFY(done);
}

void GuardedTest::parallelWorkThrowsOnce()
{
    std::atomic<int> begun = 0;
    const auto work = [&](int i) {
        ++begun;
        if (i == 3)
            throw std::runtime_error("x");
    };
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, parallelFor(1000, work));
    QVERIFY(begun >= 1);
    parallelFor(0, [](int) { throw std::runtime_error("x"); });
    std::vector<std::atomic<int>> counts(100);
    parallelFor(
        100, [&](int i) { ++counts[std::size_t(i)]; }, 7);
    for (const std::atomic<int>& count : counts)
        QCOMPARE(int(count), 1);
}

void GuardedTest::workIsDoneWhereNoThreadCanBeStarted()
{
    if (test::underSanitizer)
        QSKIP("A sanitizer itself needs the addresses that threads must not get.");
    std::vector<int> counts(1000, 0);
    std::thread::id here = std::this_thread::get_id();
    std::vector<std::thread::id> where(1000);
    Result<void> started;
    int begun = 0;
    std::thread::id whereAlone;
    const auto alone = [&] {
        ++begun;
        whereAlone = std::this_thread::get_id();
    };
    {
        const NoThreads none;
        LoneTask finished(alone);
        QCOMPARE(begun, 0);
        finished.finish();
        const LoneTask left(alone);
        parallelFor(
            1000,
            [&](int i) {
                ++counts[std::size_t(i)];
                where[std::size_t(i)] = std::this_thread::get_id();
            },
            16);
        started = guarded([] { const TaskThread thread; });
    }
    QCOMPARE(counts, std::vector<int>(1000, 1));
    QCOMPARE(where, std::vector<std::thread::id>(1000, here));
    QCOMPARE(begun, 1); // not the one that nobody asked for
    QCOMPARE(whereAlone, here);
    QVERIFY(!started);
    QCOMPARE(started.error().code, ErrorCode::OutOfMemory);
}

void GuardedTest::theReserveIsThereOnce()
{
    const std::size_t before = addressSpaceBytes();
    keepMemoryReserve();
    keepMemoryReserve();
    const std::size_t kept = addressSpaceBytes() - before;
    QVERIFY(kept >= 16'000'000 && kept < 30'000'000);
    QVERIFY(!memoryWasRefused());
    giveUpMemoryReserve();
    giveUpMemoryReserve();
    QVERIFY(memoryWasRefused());
    QVERIFY(addressSpaceBytes() <= before + 1'000'000);
    keepMemoryReserve();
    QVERIFY(!memoryWasRefused());
    giveUpMemoryReserve();
}

BURIN_TEST(GuardedTest)

} // namespace guardedTest

#include "GuardedTest.moc"
