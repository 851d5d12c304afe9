// SPDX-License-Identifier: Apache-2.0
#include "core/volume/SliceChain.h"

#include "core/base/ParallelFor.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <numeric>
#include <random>
#include <thread>
#include <vector>

namespace sliceChainTest {

class SliceChainTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void takesSlicesInTheirOrder();
    void goesAsFarAsSlicesAreThere();
    void waitsForWhatIsDone();
};

void SliceChainTest::takesSlicesInTheirOrder()
{
    std::mt19937 random(5);
    for (int round = 0; round < 200; ++round) {
        const int slices = 1 + int(random() % 60);
        std::vector<int> order(static_cast<std::size_t>(slices));
        std::iota(order.begin(), order.end(), 0);
        std::shuffle(order.begin(), order.end(), random);
        std::vector<int> taken;
        core::SliceChain chain(slices, [&](int k) { taken.push_back(k); });
        std::vector<std::thread> threads;
        for (int thread = 0; thread < 4; ++thread) {
            threads.emplace_back([&, thread] {
                for (int turn = thread; turn < slices; turn += 4)
                    chain.sliceIsThere(order[std::size_t(turn)]);
            });
        }
        for (std::thread& thread : threads)
            thread.join();
        chain.finish();
        std::sort(order.begin(), order.end());
        QCOMPARE(taken, order);
    }
}

void SliceChainTest::goesAsFarAsSlicesAreThere()
{
    std::vector<int> taken;
    core::SliceChain chain(4, [&](int k) { taken.push_back(k); });
    chain.sliceIsThere(2);
    QCOMPARE(taken, std::vector<int>());
    chain.sliceIsThere(0);
    QCOMPARE(taken, std::vector<int>({0}));
    chain.sliceIsThere(1);
    QCOMPARE(taken, std::vector<int>({0, 1, 2}));
    chain.sliceIsThere(3);
    chain.finish();
    QCOMPARE(taken, std::vector<int>({0, 1, 2, 3}));
}

void SliceChainTest::waitsForWhatIsDone()
{
    constexpr int slices = 50;
    std::vector<int> content(slices, 1);
    int sum = 0;
    core::SliceChain chain(slices, [&](int k) { sum += content[std::size_t(k)]; });
    // None is there before: the first part of what follows has all to do, and the others to wait.
    core::parallelFor(slices + 1, [&](int part) {
        if (part == 0) {
            for (int k = 0; k < slices; ++k)
                chain.sliceIsThere(k);
            chain.finish();
            return;
        }
        chain.waitFor(part - 1);
        content[std::size_t(part) - 1] = 1000;
    });
    QCOMPARE(sum, slices);
}

BURIN_TEST(SliceChainTest)

} // namespace sliceChainTest

#include "SliceChainTest.moc"
