// SPDX-License-Identifier: Apache-2.0
#include "core/islands/SegmentIslands.h"

#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <random>
#include <set>

namespace segmentIslandsTest {

namespace {

using core::IslandRule;
using Labels = std::vector<std::uint8_t>;

constexpr std::int64_t any = std::numeric_limits<std::int64_t>::max();

/// Voxel by voxel, by flooding: the parts of those voxels for which @p isIn holds.
std::vector<std::vector<std::size_t>> partsOf(
    const Labels& labels, const glm::ivec3& size, bool own, bool corners)
{
    const auto place = [&](const glm::ivec3& at) {
        return (std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x)
            + std::size_t(at.x);
    };
    std::vector<bool> seen(labels.size(), false);
    std::vector<std::vector<std::size_t>> parts;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                if (seen[place({x, y, z})] || (labels[place({x, y, z})] == 1) != own)
                    continue;
                std::vector<glm::ivec3> front{{x, y, z}};
                seen[place(front.back())] = true;
                parts.emplace_back();
                while (!front.empty()) {
                    const glm::ivec3 at = front.back();
                    front.pop_back();
                    parts.back().push_back(place(at));
                    for (int step = 0; step < 27; ++step) {
                        const glm::ivec3 by(step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1);
                        const glm::ivec3 next = at + by;
                        const bool inside = glm::all(glm::greaterThanEqual(next, glm::ivec3(0)))
                            && glm::all(glm::lessThan(next, size));
                        if (!inside
                            || (!corners && std::abs(by.x) + std::abs(by.y) + std::abs(by.z) != 1)
                            || seen[place(next)] || (labels[place(next)] == 1) != own)
                            continue;
                        seen[place(next)] = true;
                        front.push_back(next);
                    }
                }
            }
        }
    }
    return parts;
}

bool isOpen(const std::vector<std::size_t>& part, const glm::ivec3& size)
{
    for (const std::size_t voxel : part) {
        const glm::ivec3 at(int(voxel % std::size_t(size.x)),
            int(voxel / std::size_t(size.x) % std::size_t(size.y)),
            int(voxel / std::size_t(size.x) / std::size_t(size.y)));
        if (glm::any(glm::equal(at, glm::ivec3(0))) || glm::any(glm::equal(at, size - 1)))
            return true;
    }
    return false;
}

/// By the definition, from all parts.
std::pair<std::set<std::uint64_t>, std::int64_t> expected(const Labels& labels,
    const glm::ivec3& size, IslandRule rule, std::int64_t voxels, std::size_t clicked)
{
    const bool holes = rule == IslandRule::FillHoles;
    const auto parts = partsOf(labels, size, !holes, !holes);
    std::size_t largest = 0;
    for (std::size_t i = 1; i < parts.size(); ++i) {
        if (parts[i].size() > parts[largest].size())
            largest = i;
    }
    std::set<std::uint64_t> meant;
    std::int64_t count = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto part = std::int64_t(parts[i].size());
        const bool isClicked =
            std::find(parts[i].begin(), parts[i].end(), clicked) != parts[i].end();
        const bool goes = holes               ? part <= voxels && !isOpen(parts[i], size)
            : rule == IslandRule::KeepLargest ? i != largest
            : rule == IslandRule::RemoveSmall ? part < voxels
            : rule == IslandRule::KeepClicked ? !isClicked
                                              : isClicked;
        if (!goes)
            continue;
        ++count;
        meant.insert(parts[i].begin(), parts[i].end());
    }
    return {meant, count};
}

std::set<std::uint64_t> voxelsOf(const core::VoxelRuns& runs)
{
    std::set<std::uint64_t> voxels;
    for (const core::VoxelRun& run : runs.runs()) {
        for (std::uint64_t at = 0; at < run.count; ++at)
            voxels.insert(run.first + at);
    }
    return voxels;
}

} // namespace

/// Islands and holes of a segment, held to flooding voxel by voxel.
class SegmentIslandsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void randomMatter_data()
    {
        QTest::addColumn<int>("percent");
        QTest::addColumn<int>("rule");
        QTest::addColumn<qint64>("voxels");
        for (const int percent : {4, 15, 50, 85, 96}) {
            for (int rule = 0; rule < 6; ++rule) {
                for (const std::int64_t voxels : {std::int64_t(1), std::int64_t(3), any})
                    QTest::addRow(
                        "%d %%, rule %d, %lld", percent, rule, static_cast<long long>(voxels))
                        << percent << rule << qint64(voxels);
            }
        }
    }
    void randomMatter()
    {
        QFETCH(const int, percent);
        QFETCH(const int, rule);
        QFETCH(const qint64, voxels);
        std::mt19937 random(std::uint32_t(percent * 10 + rule));
        const std::array<glm::ivec3, 5> sizes{
            glm::ivec3(13, 11, 9), {1, 12, 7}, {20, 1, 6}, {17, 6, 1}, {4, 5, 37}};
        for (const glm::ivec3& size : sizes) {
            Labels labels(std::size_t(size.x * size.y * size.z));
            for (std::uint8_t& label : labels)
                label = int(random() % 100) < percent ? 1 : random() % 5 == 0 ? 2 : 0;
            // Any voxel of the segment may be clicked; where it has none, there is nothing.
            const auto own = std::count(labels.begin(), labels.end(), std::uint8_t(1));
            std::size_t clicked = 0;
            for (auto skipped = own > 0 ? random() % std::uint32_t(own) : 0;
                 own > 0 && (labels[clicked] != 1 || skipped-- > 0);)
                ++clicked;
            const auto change = core::islandChange(
                labels, size, 1, IslandRule(rule), voxels, core::Progress(), clicked);
            QVERIFY(change);
            const auto [meant, parts] = expected(labels, size, IslandRule(rule), voxels, clicked);
            QVERIFY(voxelsOf(change->voxels) == meant);
            QCOMPARE(change->parts, parts);
        }
    }

    void ofEqualIslandsTheFirstStays()
    {
        const Labels labels{1, 0, 1, 0, 1};
        const auto change =
            core::islandChange(labels, {5, 1, 1}, 1, IslandRule::KeepLargest, 0, core::Progress());
        QVERIFY(change);
        QVERIFY(voxelsOf(change->voxels) == (std::set<std::uint64_t>{2, 4}));
    }

    /// The islands beside the largest, by size; so many as are asked for are listed, all counted.
    void furtherIslandsBySize_data()
    {
        QTest::addColumn<int>("percent");
        for (const int percent : {2, 6, 15, 40, 90})
            QTest::addRow("%d %%", percent) << percent;
    }
    void furtherIslandsBySize()
    {
        QFETCH(const int, percent);
        std::mt19937 random(std::uint32_t(percent + 7));
        const std::array<glm::ivec3, 5> sizes{
            glm::ivec3(13, 11, 9), {1, 12, 7}, {20, 1, 6}, {17, 6, 1}, {4, 5, 37}};
        for (const glm::ivec3& size : sizes) {
            Labels labels(std::size_t(size.x * size.y * size.z));
            for (std::uint8_t& label : labels)
                label = int(random() % 100) < percent ? 1 : random() % 5 == 0 ? 2 : 0;
            auto parts = partsOf(labels, size, true, true); // in the order of memory
            std::stable_sort(parts.begin(), parts.end(),
                [](const auto& one, const auto& other) { return one.size() > other.size(); });
            std::vector<std::int64_t> counts;
            for (const auto& part : parts)
                counts.push_back(std::int64_t(part.size()));
            const auto found = core::islandSizes(labels, size, 1, core::Progress());
            QVERIFY(found && *found == counts);
            if (!parts.empty())
                parts.erase(parts.begin());
            for (const std::int64_t least : {1, 2, 4}) {
                for (const std::size_t most : {std::size_t(0), std::size_t(3), std::size_t(1000)}) {
                    const auto further =
                        core::furtherIslands(labels, size, 1, least, most, core::Progress());
                    QVERIFY(further);
                    const auto count = std::count_if(parts.begin(), parts.end(),
                        [least](const auto& part) { return std::int64_t(part.size()) >= least; });
                    QCOMPARE(further->count, std::int64_t(count));
                    QCOMPARE(further->islands.size(), std::min(std::size_t(count), most));
                    for (std::size_t place = 0; place < further->islands.size(); ++place)
                        QVERIFY(voxelsOf(further->islands[place])
                            == std::set<std::uint64_t>(parts[place].begin(), parts[place].end()));
                }
            }
        }
        core::Progress progress;
        progress.cancel();
        const auto cancelled = core::furtherIslands(Labels(24, 1), {4, 3, 2}, 1, 1, 9, progress);
        QVERIFY(!cancelled && cancelled.error().code == core::ErrorCode::Cancelled);
        QVERIFY(!core::islandSizes(Labels(24, 1), {4, 3, 2}, 1, progress));
        const auto none = core::islandSizes(Labels(24, 2), {4, 3, 2}, 1, core::Progress());
        QVERIFY(none && none->empty());
    }

    /// A click beside the segment means no island, whichever rule it is for.
    void aClickBesideItMeansNothing()
    {
        const Labels labels{1, 0, 1, 2, 1};
        for (const IslandRule rule :
            {IslandRule::KeepClicked, IslandRule::RemoveClicked, IslandRule::GiveClicked}) {
            for (const std::size_t clicked : {std::size_t(1), std::size_t(3), std::size_t(5)}) {
                const auto change =
                    core::islandChange(labels, {5, 1, 1}, 1, rule, any, core::Progress(), clicked);
                QVERIFY(change && change->voxels.empty() && change->parts == 0);
            }
            const auto change =
                core::islandChange(labels, {5, 1, 1}, 1, rule, any, core::Progress(), 2);
            QVERIFY(change);
            QVERIFY(voxelsOf(change->voxels)
                == (rule == IslandRule::KeepClicked ? std::set<std::uint64_t>{0, 4}
                                                    : std::set<std::uint64_t>{2}));
        }
    }

    void nothingInNothing()
    {
        for (const IslandRule rule :
            {IslandRule::FillHoles, IslandRule::KeepLargest, IslandRule::RemoveSmall}) {
            const auto change =
                core::islandChange(Labels(24, 2), {4, 3, 2}, 1, rule, any, core::Progress());
            QVERIFY(change && change->voxels.empty() && change->parts == 0);
        }
    }

    void canBeCancelled()
    {
        core::Progress progress;
        progress.cancel();
        const auto change =
            core::islandChange(Labels(24, 1), {4, 3, 2}, 1, IslandRule::KeepLargest, any, progress);
        QVERIFY(!change && change.error().code == core::ErrorCode::Cancelled);
    }
};

BURIN_TEST(SegmentIslandsTest)

} // namespace segmentIslandsTest

#include "SegmentIslandsTest.moc"
