// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/EngineThread.h"
#include "gpu/gl/context/EglContext.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace engineThreadGlTest {

using gpu::EngineThread;

namespace {

/// A context that needs no driver, or refuses.
class FakeContext : public gpu::GlContext {
public:
    explicit FakeContext(bool refuses)
        : m_refuses(refuses)
    {
    }
    bool makeCurrent() override { return !m_refuses; }
    void doneCurrent() override { }

private:
    bool m_refuses;
};

std::unique_ptr<EngineThread> started()
{
    auto context = gpu::EglContext::create();
    if (!context)
        return nullptr;
    auto thread = std::make_unique<EngineThread>(std::move(*context));
    return thread->start() ? std::move(thread) : nullptr;
}

} // namespace

class EngineThreadGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void runsJobsInOrderOnOneThread()
    {
        const auto thread = started();
        QVERIFY(thread);
        std::vector<int> order;
        std::vector<std::thread::id> where;
        for (int i = 0; i < 50; ++i) {
            thread->post([&, i] {
                order.push_back(i);
                where.push_back(std::this_thread::get_id());
            });
        }
        bool nested = false;
        thread->run([&] { thread->run([&] { nested = true; }); });
        QVERIFY(nested);
        QCOMPARE(order.size(), std::size_t(50));
        for (std::size_t i = 0; i < 50; ++i) {
            QCOMPARE(order[i], int(i));
            QVERIFY(where[i] == where[0] && where[i] != std::this_thread::get_id());
        }
    }

    void editsComeBeforeFramesAndBothRestWhenDone()
    {
        const auto thread = started();
        QVERIFY(thread);
        std::vector<char> order;
        int edits = 0;
        int frames = 0;
        std::promise<void> rested;
        thread->run([&] {
            thread->setSlices(
                [&] {
                    order.push_back('e');
                    return ++edits < 3;
                },
                [&] {
                    order.push_back('f');
                    if (++frames == 5)
                        rested.set_value();
                    return frames < 5;
                });
        });
        rested.get_future().wait();
        std::vector<char> seen;
        // A job wakes the loop: one more turn of both comes after it, none before it.
        thread->run([&] { seen = order; });
        QCOMPARE(QByteArray(seen.data(), 10), QByteArray("efefefefef"));
        thread->run([&] { thread->setSlices({}, {}); });
    }

    void anAlarmWakesIt()
    {
        const auto thread = started();
        QVERIFY(thread);
        std::promise<void> woken;
        std::atomic<bool> asked = false;
        thread->run([&] {
            thread->setSlices(
                [&] {
                    if (!asked.exchange(true))
                        thread->wakeAt(EngineThread::Clock::now() + std::chrono::milliseconds(20));
                    else
                        woken.set_value();
                    return false;
                },
                {});
        });
        woken.get_future()
            .wait(); // hangs, and so fails by the test's time limit, when it never wakes
        thread->run([&] { thread->setSlices({}, {}); });
    }

    void postedJobsAreDoneBeforeItEnds()
    {
        std::atomic<int> done = 0;
        {
            const auto thread = started();
            QVERIFY(thread);
            for (int i = 0; i < 20; ++i)
                thread->post([&] { ++done; });
        }
        QCOMPARE(done.load(), 20);
    }

    void aRefusedContextIsAnError()
    {
        EngineThread thread(std::make_unique<FakeContext>(true));
        const auto result = thread.start();
        QVERIFY(!result);
        QCOMPARE(result.error().code, core::ErrorCode::GraphicsUnavailable);
    }
};

BURIN_TEST(EngineThreadGlTest)

} // namespace engineThreadGlTest

#include "EngineThreadGlTest.moc"
