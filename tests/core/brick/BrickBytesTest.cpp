// SPDX-License-Identifier: Apache-2.0
#include "core/brick/BrickBytes.h"

#include "core/brick/ThreadWithoutVoxels.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <atomic>
#include <thread>

namespace brickBytesTest {

using namespace core;

class BrickBytesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void copiesShareUntilOneIsWritten()
    {
        const BrickBytes first(std::vector<std::uint8_t>{1, 2, 3});
        BrickBytes second = first;
        QCOMPARE(&second.read(), &first.read());
        QVERIFY(second == first);
        second.write()[0] = 9;
        QCOMPARE(int(first.read()[0]), 1);
        QCOMPARE(int(second.read()[0]), 9);
        QVERIFY(!(second == first));
        second.clear();
        QVERIFY(second.empty() && second.read().empty());
        QVERIFY(second == BrickBytes(std::vector<std::uint8_t>()));
        second.write().push_back(4);
        QCOMPARE(second.size(), std::size_t(1));
    }

    void whatAnotherThreadLetGoOfIsWritten()
    {
        BrickBytes bytes(std::vector<std::uint8_t>{1, 2, 3});
        // Orders nothing: write() alone does, which the thread sanitizer must see.
        std::atomic<int> seen = 0;
        std::thread other([copy = bytes, &seen]() mutable {
            const int last = copy.read()[2];
            copy.clear();
            seen.store(last, std::memory_order_relaxed);
        });
        while (seen.load(std::memory_order_relaxed) == 0)
            std::this_thread::yield();
        const std::uint8_t* before = bytes.read().data();
        bytes.write()[2] = 4;
        QCOMPARE(bytes.read().data(), before);
        other.join();
        QCOMPARE(int(seen), 3);
    }

    void looksAreCountedWhereTheyMustNotBe()
    {
        const BrickBytes bytes(std::vector<std::uint8_t>{1, 2, 3});
        const BrickBytes alike(std::vector<std::uint8_t>{1, 2, 3});
        const std::int64_t before = ThreadWithoutVoxels::looks();
        QCOMPARE(bytes.read().size(), std::size_t(3)); // nobody minds yet
        QCOMPARE(ThreadWithoutVoxels::looks(), before);
        {
            const ThreadWithoutVoxels here;
            // Handing bricks on is no look at their voxels.
            BrickBytes copy = bytes;
            QVERIFY(!copy.empty() && copy.size() == 3 && copy == bytes);
            copy.clear();
            QCOMPARE(ThreadWithoutVoxels::looks(), before);
            {
                const VoxelsAllowed forOnce;
                QCOMPARE(bytes.read().size(), std::size_t(3));
            }
            std::thread([&bytes] { QCOMPARE(bytes.read().size(), std::size_t(3)); }).join();
            QCOMPARE(ThreadWithoutVoxels::looks(), before);
            expectComplaint();
            QCOMPARE(bytes.read().size(), std::size_t(3));
            QVERIFY(bytes == alike);
            QCOMPARE(ThreadWithoutVoxels::looks(), before + 3);
        }
        QCOMPARE(bytes.read().size(), std::size_t(3));
        QCOMPARE(ThreadWithoutVoxels::looks(), before + 3);
    }

private:
    /// Builds with assertions complain, once.
    static void expectComplaint()
    {
#ifdef _GLIBCXX_ASSERTIONS
        QTest::ignoreMessage(
            QtWarningMsg, "A thread that serves a window looked at the voxels of a brick.");
#endif
    }
};

BURIN_TEST(BrickBytesTest)

} // namespace brickBytesTest

#include "BrickBytesTest.moc"
