// SPDX-License-Identifier: Apache-2.0
#include "core/growth/SketchInterval.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <tuple>
#include <utility>

namespace core {

namespace {

constexpr std::size_t mostSeeds = 64; ///< of all sketches together; more would add no information
constexpr std::size_t fewSeeds = 8; ///< up to this many seeds use the greater reach
constexpr int reachOfMany = 3;
constexpr int reachOfFew = 6;
constexpr int mostInward = 3;
constexpr std::size_t enough = 30; ///< voxels of a sketch
constexpr std::size_t mostWidened = 100; ///< voxels that fewer are widened to
/// The deviation is at least the distance to a neighbouring tissue divided by this.
constexpr int leastContrast = 16;

bool isBefore(const glm::ivec3& a, const glm::ivec3& b)
{
    return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
}

void sortOnce(std::vector<glm::ivec3>& voxels)
{
    std::sort(voxels.begin(), voxels.end(), isBefore);
    voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
}

bool isWithin(const glm::ivec3& voxel, const glm::ivec3& size)
{
    return glm::all(glm::greaterThanEqual(voxel, glm::ivec3(0)))
        && glm::all(glm::lessThan(voxel, size));
}

int medianOf(std::vector<int> numbers)
{
    const auto middle = numbers.begin() + std::ptrdiff_t(numbers.size() / 2);
    std::nth_element(numbers.begin(), middle, numbers.end());
    return *middle;
}

/// The median of distances in 256ths, as if each were spread evenly over the code that it was
/// rounded to: otherwise a low noise would be one code or none.
std::int64_t medianDistance256(const std::vector<int>& distances)
{
    const int middle = medianOf(distances);
    std::int64_t below = 0;
    std::int64_t at = 0;
    for (const int distance : distances) {
        below += distance < middle ? 1 : 0;
        at += distance == middle ? 1 : 0;
    }
    const std::int64_t from = middle == 0 ? 0 : 256 * std::int64_t(middle) - 128;
    const std::int64_t width = middle == 0 ? 128 : 256;
    return from + width * (std::int64_t(distances.size()) - 2 * below) / (2 * at);
}

struct Spread {
    int centre = 0;
    std::int64_t deviation256 = 0;
};

Spread spreadOf(const std::vector<int>& codes)
{
    Spread spread{.centre = medianOf(codes)};
    std::vector<int> distances;
    distances.reserve(codes.size());
    for (const int code : codes)
        distances.push_back(std::abs(code - spread.centre));
    spread.deviation256 = medianDistance256(distances) * 380 / 256; // 1.4826: of a normal one
    return spread;
}

std::size_t seedCount(const std::vector<SeedSketch>& sketches)
{
    std::size_t count = 0;
    for (const SeedSketch& sketch : sketches)
        count += sketch.voxels.size();
    return count;
}

} // namespace

/// The codes that were read, to be looked up by voxel.
class SketchInterval::Neighbourhood {
public:
    Neighbourhood(const SketchInterval& question, const std::vector<int>& codes)
        : m_voxels(question.m_voxels)
        , m_codes(codes)
        , m_size(question.m_volumeSize)
    {
        if (m_voxels.empty())
            return;
        // A row of the sorted list begins where its y or z changes.
        for (std::size_t i = 0; i < m_voxels.size(); ++i) {
            const std::pair<int, int> row(m_voxels[i].z, m_voxels[i].y);
            if (m_rows.empty() || m_rows.back().first != row)
                m_rows.emplace_back(row, i);
        }
    }
    /// Index of a voxel; none where it was not read.
    [[nodiscard]] std::optional<std::size_t> find(const glm::ivec3& voxel) const
    {
        const auto row = std::lower_bound(m_rows.begin(), m_rows.end(), std::pair(voxel.z, voxel.y),
            [](const auto& a, const std::pair<int, int>& b) { return a.first < b; });
        if (row == m_rows.end() || row->first != std::pair(voxel.z, voxel.y))
            return std::nullopt;
        const std::size_t end = row + 1 == m_rows.end() ? m_voxels.size() : (row + 1)->second;
        const auto from = m_voxels.begin() + std::ptrdiff_t(row->second);
        const auto to = m_voxels.begin() + std::ptrdiff_t(end);
        const auto at = std::lower_bound(
            from, to, voxel, [](const glm::ivec3& a, const glm::ivec3& b) { return a.x < b.x; });
        if (at == to || *at != voxel)
            return std::nullopt;
        return std::size_t(at - m_voxels.begin());
    }
    /// The code of a voxel, or of the nearest one in the volume.
    [[nodiscard]] int code(const glm::ivec3& voxel) const
    {
        const auto found = find(glm::clamp(voxel, glm::ivec3(0), m_size - 1));
        return found ? m_codes[*found] : 0;
    }
    [[nodiscard]] glm::dvec3 gradient(const glm::ivec3& voxel) const
    {
        glm::dvec3 gradient(0.0);
        for (int z = -1; z <= 1; ++z) {
            for (int y = -1; y <= 1; ++y) {
                for (int x = -1; x <= 1; ++x)
                    gradient += double(code(voxel + glm::ivec3(x, y, z))) * glm::dvec3(x, y, z);
            }
        }
        return gradient;
    }
    /// Second differences along the axes, scaled to a deviation.
    [[nodiscard]] std::int64_t noise256(const std::vector<std::size_t>& places) const
    {
        std::vector<int> differences;
        for (const std::size_t place : places) {
            for (int axis = 0; axis < 3; ++axis) {
                glm::ivec3 step(0);
                step[axis] = 1;
                const auto before = find(m_voxels[place] - step);
                const auto after = find(m_voxels[place] + step);
                if (before && after)
                    differences.push_back(
                        std::abs(m_codes[*before] - 2 * m_codes[place] + m_codes[*after]));
            }
        }
        // 1.4826 / √6: the variance of a second difference is six times that of a code.
        return differences.empty() ? 0 : medianDistance256(differences) * 155 / 256;
    }
    [[nodiscard]] std::vector<int> codesAt(const std::vector<std::size_t>& places) const
    {
        std::vector<int> codes;
        codes.reserve(places.size());
        for (const std::size_t place : places)
            codes.push_back(m_codes[place]);
        return codes;
    }
    [[nodiscard]] Spread spreadAt(const std::vector<std::size_t>& places) const
    {
        Spread spread = spreadOf(codesAt(places));
        spread.deviation256 = std::max({spread.deviation256, noise256(places), std::int64_t(128)});
        return spread;
    }
    /// The region of similar voxels that is connected with the given ones, among the voxels that
    /// may be taken.
    [[nodiscard]] std::vector<std::size_t> widened(const std::vector<std::size_t>& places,
        const Spread& spread, const std::vector<bool>& near) const
    {
        const auto resembles = [&](std::size_t place) {
            return 512 * std::int64_t(std::abs(m_codes[place] - spread.centre))
                <= 5 * spread.deviation256;
        };
        std::vector<bool> taken(m_voxels.size(), false);
        std::vector<std::size_t> result;
        const auto take = [&](std::size_t place) {
            if (taken[place] || !resembles(place))
                return;
            taken[place] = true;
            result.push_back(place);
        };
        for (const std::size_t place : places)
            take(place);
        for (std::size_t i = 0; i < result.size() && result.size() < mostWidened; ++i) {
            for (int axis = 0; axis < 3; ++axis) {
                for (const int step : {-1, 1}) {
                    glm::ivec3 next = m_voxels[result[i]];
                    next[axis] += step;
                    const auto place = find(next);
                    if (place && near[*place])
                        take(*place);
                }
            }
        }
        return result;
    }

private:
    const std::vector<glm::ivec3>& m_voxels;
    const std::vector<int>& m_codes;
    glm::ivec3 m_size;
    std::vector<std::pair<std::pair<int, int>, std::size_t>> m_rows; ///< (z, y) and its first voxel
};

SketchInterval::SketchInterval(
    const std::vector<SeedSketch>& sketches, const glm::ivec3& volumeSize)
    : m_volumeSize(volumeSize)
{
    const std::size_t seeds = seedCount(sketches);
    const std::size_t every = (seeds + mostSeeds - 1) / mostSeeds;
    std::size_t place = 0; // among the seeds of all sketches
    m_reach = seeds <= fewSeeds ? reachOfFew : reachOfMany;
    for (const SeedSketch& sketch : sketches) {
        SeedSketch thin{.inward = sketch.inward};
        for (const glm::ivec3& voxel : sketch.voxels) {
            if (place++ % every == 0)
                thin.voxels.push_back(voxel);
        }
        if (thin.voxels.empty())
            continue;
        // One more than is looked at, for differences.
        const int around = m_reach + 1 + (sketch.inward ? mostInward : 0);
        for (const glm::ivec3& seed : thin.voxels) {
            const glm::ivec3 from = glm::max(seed - around, glm::ivec3(0));
            const glm::ivec3 to = glm::min(seed + around, volumeSize - 1);
            for (int z = from.z; z <= to.z; ++z) {
                for (int y = from.y; y <= to.y; ++y) {
                    for (int x = from.x; x <= to.x; ++x)
                        m_voxels.emplace_back(x, y, z);
                }
            }
        }
        m_sketches.push_back(std::move(thin));
    }
    sortOnce(m_voxels);
}

SketchedCodes SketchInterval::look(const std::vector<int>& codes) const
{
    SketchedCodes result;
    if (m_voxels.empty() || codes.size() != m_voxels.size())
        return result;
    const Neighbourhood around(*this, codes);
    std::vector<glm::ivec3> meant;
    for (const SeedSketch& sketch : m_sketches) {
        for (const glm::ivec3& seed : sketch.voxels) {
            result.seeds.push_back(around.code(seed));
            if (!sketch.inward || glm::length(*sketch.inward) == 0.0) {
                meant.push_back(seed);
                continue;
            }
            glm::dvec3 way = glm::normalize(*sketch.inward);
            const glm::dvec3 gradient = around.gradient(seed);
            const double steep = glm::length(gradient);
            const double along = steep > 0.0 ? glm::dot(gradient, way) / steep : 0.0;
            // A surface that is seen from the side says nothing of what is behind it.
            if (std::abs(along) > 0.2)
                way = (along > 0.0 ? gradient : -gradient) / steep;
            const glm::dvec3 sizes = glm::abs(way);
            way /= std::max({sizes.x, sizes.y, sizes.z});
            for (int step = 1; step <= mostInward; ++step) {
                const glm::ivec3 voxel = seed + glm::ivec3(glm::round(way * double(step)));
                if (isWithin(voxel, m_volumeSize))
                    meant.push_back(voxel);
            }
        }
    }
    std::sort(result.seeds.begin(), result.seeds.end());
    sortOnce(meant);
    std::vector<std::size_t> places;
    std::vector<bool> near(m_voxels.size(), false);
    for (const glm::ivec3& voxel : meant) {
        if (const auto place = around.find(voxel))
            places.push_back(*place);
        const glm::ivec3 from = glm::max(voxel - m_reach, glm::ivec3(0));
        const glm::ivec3 to = glm::min(voxel + m_reach, m_volumeSize - 1);
        for (int z = from.z; z <= to.z; ++z) {
            for (int y = from.y; y <= to.y; ++y) {
                const auto first = around.find({from.x, y, z});
                if (first)
                    std::fill_n(near.begin() + std::ptrdiff_t(*first), to.x - from.x + 1, true);
            }
        }
    }
    if (places.empty())
        return result;
    Spread spread = around.spreadAt(places);
    if (places.size() < enough) {
        // If a sketch touches several tissues, only few of its voxels resemble the median; then it
        // is not widened.
        const std::vector<std::size_t> wide = around.widened(places, spread, near);
        if (wide.size() > places.size() / 2) {
            places = wide;
            spread = around.spreadAt(places);
        }
    }

    std::vector<int> darker;
    std::vector<int> brighter;
    std::size_t all = 0;
    for (std::size_t i = 0; i < codes.size(); ++i) {
        if (!near[i])
            continue;
        ++all;
        const std::int64_t away = 256 * std::int64_t(codes[i] - spread.centre);
        if (away < -2 * spread.deviation256)
            darker.push_back(codes[i]);
        else if (away > 2 * spread.deviation256)
            brighter.push_back(codes[i]);
    }
    std::int64_t contrast = 0;
    const auto tell = [&](const std::vector<int>& beside, std::optional<int>& told) {
        if (beside.empty() || 10 * beside.size() < all)
            return;
        told = medianOf(beside);
        const std::int64_t away = std::abs(*told - spread.centre);
        contrast = contrast == 0 ? away : std::min(contrast, away);
    };
    tell(darker, result.darker);
    tell(brighter, result.brighter);
    result.centre = spread.centre;
    result.deviation256 = int(std::max(spread.deviation256,
        std::min(256 * contrast / leastContrast, 5 * spread.deviation256 / 2)));
    result.voxels = int(places.size());
    return result;
}

CodeInterval offeredInterval(const SketchedCodes& sketched, int sigmas256)
{
    if (sketched.voxels == 0)
        return {};
    // A code stands for values that are up to half a code away.
    const std::int64_t reach = (std::int64_t(sigmas256) * sketched.deviation256 + 32768) / 65536;
    std::int64_t low = sketched.centre - reach;
    std::int64_t high = sketched.centre + reach;
    if (sketched.darker)
        low = std::max<std::int64_t>(
            low, *sketched.darker + (sketched.centre - *sketched.darker + 3) / 4);
    if (sketched.brighter)
        high = std::min<std::int64_t>(
            high, *sketched.brighter - (*sketched.brighter - sketched.centre + 3) / 4);
    CodeInterval offered{.low = int(std::max<std::int64_t>(std::min(low, high), 0)),
        .high = int(std::min<std::int64_t>(std::max(low, high), 65535))};
    const int needed = std::max((int(sketched.seeds.size()) + 3) / 4, 1);
    if (seedsWithin(sketched, offered) < needed && int(sketched.seeds.size()) >= needed) {
        std::vector<int> nearest = sketched.seeds;
        const auto distance = [&offered](int code) {
            return std::max({offered.low - code, code - offered.high, 0});
        };
        std::sort(nearest.begin(), nearest.end(),
            [&distance](int a, int b) { return distance(a) < distance(b); });
        for (int i = 0; i < needed; ++i) {
            offered.low = std::min(offered.low, nearest[std::size_t(i)]);
            offered.high = std::max(offered.high, nearest[std::size_t(i)]);
        }
    }
    return offered;
}

int seedsWithin(const SketchedCodes& sketched, const CodeInterval& interval)
{
    return int(std::upper_bound(sketched.seeds.begin(), sketched.seeds.end(), interval.high)
        - std::lower_bound(sketched.seeds.begin(), sketched.seeds.end(), interval.low));
}

} // namespace core
