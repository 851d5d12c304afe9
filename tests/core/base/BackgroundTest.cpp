// SPDX-License-Identifier: Apache-2.0
#include "core/base/Background.h"
#include "tests/support/program/Signal.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <atomic>
#include <memory>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

namespace backgroundTest {

using namespace core;

namespace {

void ignore(const Result<void>&) { }

/// A task that does not look whether it is wanted: it goes on until the gate is opened.
struct Gate {
    test::Signal begun;
    test::Signal open;

    void pass()
    {
        begun.release();
        open.acquire();
    }
};

} // namespace

/// What is done beside a thread is told there, or not at all.
class BackgroundTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void outcomesAreToldHere();
    void tasksAreDoneInOrder();
    void progressIsToldUntilTheOutcomeIs();
    void whatIsCancelledIsNotTold();
    void whatIsNoLongerWantedGoesAtOnce();
    void whatIsStoppedIsTold();
    void whatIsThrownIsTheOutcome();
    void withoutItsContextNothingIsTold();
    void nothingIsToldOfWhatIsDestroyed();
    void theLatestReplacesTheOthers();
    void whatIsFinishedIsToldBeforeItReturns();
    void whoIsToldMayStartOrDestroy();
};

void BackgroundTest::outcomesAreToldHere()
{
    std::thread::id worker;
    std::thread::id told;
    int value = 0;
    bool nothing = false;
    ErrorCode code = ErrorCode::Internal;
    Background background;
    background.start(
        this,
        [&] {
            worker = std::this_thread::get_id();
            return 7;
        },
        [&](const Result<int>& outcome) {
            told = std::this_thread::get_id();
            value = outcome.value_or(0);
        });
    background.start(
        this, [] {}, [&](const Result<void>& outcome) { nothing = outcome.has_value(); });
    background.start(
        this, []() -> Result<int> { return failure(ErrorCode::FolderEmpty); },
        [&](const Result<int>& outcome) { code = outcome.error().code; });
    // Only what can be moved comes as well.
    std::unique_ptr<int> owned;
    background.start(
        this, [] { return std::make_unique<int>(8); },
        [&](Result<std::unique_ptr<int>>&& outcome) { owned = *std::move(outcome); });
    QVERIFY(background.busy());
    QCOMPARE(value, 0);
    QTRY_VERIFY(!background.busy());
    QCOMPARE(value, 7);
    QVERIFY(nothing);
    QCOMPARE(code, ErrorCode::FolderEmpty);
    QVERIFY(owned && *owned == 8);
    QCOMPARE(told, std::this_thread::get_id());
    QVERIFY(worker != std::thread::id() && worker != told);
}

void BackgroundTest::tasksAreDoneInOrder()
{
    std::vector<int> done;
    std::vector<int> told;
    std::vector<int> expected;
    Background background;
    for (int i = 0; i < 50; ++i) {
        expected.push_back(i);
        background.start(
            this, [&done, i] { done.push_back(i); },
            [&told, i](const Result<void>&) { told.push_back(i); });
    }
    QTRY_VERIFY(!background.busy());
    QCOMPARE(done, expected);
    QCOMPARE(told, expected);
}

void BackgroundTest::progressIsToldUntilTheOutcomeIs()
{
    QStringList told;
    Background background;
    background.start(
        this,
        [&told](const Progress& progress, const Background::Meanwhile& meanwhile) {
            progress.report(core::ProgressStep::ReadingSlices, 1, 3);
            meanwhile([&told] { told += QStringLiteral("meanwhile"); });
            progress.report(core::ProgressStep::ReadingSlices, 2, 3);
        },
        [&told](const Result<void>&) { told += QStringLiteral("done"); },
        [&told](core::ProgressStep step, int done, int total) {
            QCOMPARE(step, core::ProgressStep::ReadingSlices);
            told += QStringLiteral("step %1/%2").arg(done).arg(total);
        });
    QTRY_VERIFY(!background.busy());
    QCOMPARE(told.join(u','), QStringLiteral("step 1/3,meanwhile,step 2/3,done"));
}

void BackgroundTest::whatIsCancelledIsNotTold()
{
    Gate gate;
    bool noticed = false;
    bool begun = false;
    QStringList told;
    const auto tell = [&told](const char* what) {
        return [&told, what](const Result<void>&) { told += QLatin1String(what); };
    };
    Background background;
    Background::Task first = background.start(
        this,
        [&](const Progress& progress) {
            progress.report(core::ProgressStep::ReadingSlices, 0, 1);
            gate.pass();
            noticed = progress.cancelled();
        },
        tell("first"), [&told](core::ProgressStep, int, int) { told += QStringLiteral("begun"); });
    Background::Task second = background.start(
        this, [&begun] { begun = true; }, tell("second"));
    background.start(
        this, [] {}, tell("third"));
    gate.begun.acquire();
    QVERIFY(first.running() && second.running());
    first.cancel();
    second.cancel();
    QVERIFY(!first.running() && !second.running() && background.busy());
    gate.open.release();
    QTRY_VERIFY(!background.busy());
    QVERIFY(noticed);
    QVERIFY(!begun);
    QCOMPARE(told, QStringList(QStringLiteral("third")));
    QVERIFY(!Background::Task().running());
}

void BackgroundTest::whatIsNoLongerWantedGoesAtOnce()
{
    Gate gate;
    std::weak_ptr<int> outcome;
    Background background;
    Background::Task task = background.start(
        this,
        [&outcome] {
            auto made = std::make_shared<int>(1);
            outcome = made;
            return made;
        },
        [](const Result<std::shared_ptr<int>>&) {});
    background.start(
        this, [&gate] { gate.pass(); }, ignore);
    gate.begun.acquire(); // the first is done then, and waits for being told
    QVERIFY(!outcome.expired());
    task.cancel();
    QVERIFY(outcome.expired());
    gate.open.release();
}

void BackgroundTest::whatIsStoppedIsTold()
{
    Gate gate;
    std::optional<ErrorCode> code;
    Background background;
    Background::Task task = background.start(
        this,
        [&gate](const Progress& progress) -> Result<void> {
            gate.pass();
            if (progress.cancelled())
                return failure(ErrorCode::Cancelled);
            return {};
        },
        [&code](const Result<void>& outcome) { code = outcome.error().code; });
    gate.begun.acquire();
    task.stop();
    QVERIFY(task.running());
    gate.open.release();
    QTRY_VERIFY(code);
    QCOMPARE(*code, ErrorCode::Cancelled);
}

void BackgroundTest::whatIsThrownIsTheOutcome()
{
    Error told;
    bool after = false;
    Background background;
    background.start(
        this, []() -> int { throw std::runtime_error("why"); },
        [&told](const Result<int>& outcome) { told = outcome.error(); });
    background.start(
        this, [] {}, [&after](const Result<void>& outcome) { after = outcome.has_value(); });
    QTRY_VERIFY(after);
    QCOMPARE(told.code, ErrorCode::Internal);
    QCOMPARE(told.arguments.value(0), QStringLiteral("why"));
}

void BackgroundTest::withoutItsContextNothingIsTold()
{
    bool told = false;
    bool after = false;
    auto context = std::make_unique<QObject>();
    Background background;
    background.start(
        context.get(),
        [](const Progress& progress) { progress.report(core::ProgressStep::Measuring, 1, 1); },
        [&told](const Result<void>&) { told = true; },
        [&told](core::ProgressStep, int, int) { told = true; });
    background.start(
        this, [] {}, [&after](const Result<void>&) { after = true; });
    context.reset();
    QTRY_VERIFY(after);
    QVERIFY(!told);
}

void BackgroundTest::nothingIsToldOfWhatIsDestroyed()
{
    Gate gate;
    bool told = false;
    bool begun = false;
    std::atomic<bool> ended = false;
    const auto tell = [&told](const Result<void>&) { told = true; };
    {
        Background background;
        background.start(
            this,
            [&](const Progress& progress) {
                progress.report(core::ProgressStep::Measuring, 1, 1);
                gate.begun.release();
                while (!progress.cancelled())
                    std::this_thread::yield();
                ended = true;
            },
            tell, [&told](core::ProgressStep, int, int) { told = true; });
        background.start(
            this, [&begun] { begun = true; }, tell);
        gate.begun.acquire();
    }
    QVERIFY(ended);
    QVERIFY(!begun);
    QCoreApplication::processEvents();
    QVERIFY(!told);
}

void BackgroundTest::theLatestReplacesTheOthers()
{
    Gate gate;
    std::vector<int> done;
    std::vector<int> told;
    Background background;
    background.replace(
        this, [&gate] { gate.pass(); }, [&told](const Result<void>&) { told.push_back(0); });
    gate.begun.acquire();
    for (int i = 1; i < 4; ++i)
        background.replace(
            this, [&done, i] { done.push_back(i); },
            [&told, i](const Result<void>&) { told.push_back(i); });
    gate.open.release();
    QTRY_VERIFY(!background.busy());
    QCOMPARE(done, std::vector<int>{3});
    QCOMPARE(told, std::vector<int>{3});
}

void BackgroundTest::whatIsFinishedIsToldBeforeItReturns()
{
    Background background;
    background.finish();
    int told = 0;
    for (int i = 0; i < 3; ++i)
        background.start(
            this, [] {}, [&told](const Result<void>&) { ++told; });
    background.finish();
    QCOMPARE(told, 3);
    QVERIFY(!background.busy());
}

void BackgroundTest::whoIsToldMayStartOrDestroy()
{
    auto background = std::make_unique<Background>();
    bool destroyed = false;
    background->start(
        this, [] {},
        [&](const Result<void>&) {
            QVERIFY(!background->busy());
            background->start(
                this, [] {},
                [&](const Result<void>&) {
                    background.reset();
                    destroyed = true;
                });
        });
    QTRY_VERIFY(destroyed);
}

BURIN_TEST(BackgroundTest)

} // namespace backgroundTest

#include "BackgroundTest.moc"
