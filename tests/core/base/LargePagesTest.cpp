// SPDX-License-Identifier: Apache-2.0
#include "core/base/LargePages.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <sys/mman.h>
#include <unistd.h>

namespace largePagesTest {

namespace {

/// How many pages of this memory are resident; it begins at a page.
std::ptrdiff_t residentPages(void* memory, std::size_t bytes)
{
    const auto page = std::size_t(sysconf(_SC_PAGESIZE));
    std::vector<unsigned char> resident(bytes / page);
    if (mincore(memory, bytes, resident.data()) != 0)
        return -1;
    return std::count_if(
        resident.begin(), resident.end(), [](unsigned char each) { return (each & 1) != 0; });
}

} // namespace

/// Memory that is given back before it is freed.
class LargePagesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void wholePagesAreGivenBack()
    {
        const auto page = std::size_t(sysconf(_SC_PAGESIZE));
        const std::size_t bytes = 64 * page;
        void* const memory =
            mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        QVERIFY(memory != MAP_FAILED);
        const std::span<std::uint8_t> all(static_cast<std::uint8_t*>(memory), bytes);
        std::fill(all.begin(), all.end(), std::uint8_t(7));
        QCOMPARE(residentPages(memory, bytes), std::ptrdiff_t(64));
        // From the middle of a page to the middle of another: 39 whole ones lie between.
        const std::size_t from = 10 * page + page / 2;
        const std::size_t to = 50 * page + page / 2;
        core::giveBackPages(&all[from], to - from);
        QCOMPARE(residentPages(memory, bytes), std::ptrdiff_t(64 - 39));
        const auto isKept = [](std::uint8_t each) { return each == 7; };
        QVERIFY(std::all_of(all.begin(), all.begin() + std::ptrdiff_t(11 * page), isKept));
        QVERIFY(std::all_of(all.begin() + std::ptrdiff_t(50 * page), all.end(), isKept));
        // Less than a page is none, and it can all be written again.
        core::giveBackPages(&all[0], page - 1);
        QVERIFY(isKept(all[0]));
        std::fill(all.begin(), all.end(), std::uint8_t(8));
        QCOMPARE(residentPages(memory, bytes), std::ptrdiff_t(64));
        munmap(memory, bytes);
    }
};

BURIN_PLAIN_TEST(LargePagesTest)

} // namespace largePagesTest

#include "LargePagesTest.moc"
