// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/SliceParts.h"

#include "core/islands/RunParts.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

namespace core {

namespace {

/// Halves are rounded up.
int meanOf(std::int64_t sum, std::int64_t count)
{
    return int((2 * sum + count) / (2 * count));
}

/// Of each pixel the number of its part, in the order of their first pixels; less than 0: none.
std::vector<int> partAtPixels(const SliceMask& mask, int& parts)
{
    RunParts runs({mask.size.x, mask.size.y, 1}, 1);
    for (int y = 0; y < mask.size.y; ++y) {
        runs.beginRow(std::size_t(y));
        const std::uint8_t* row = &mask.pixels[mask.indexOf({0, y})];
        for (int x = 0; x < mask.size.x;) {
            const int begin = x;
            while (x < mask.size.x && row[x] != 0)
                ++x;
            if (x > begin)
                runs.add(begin, x);
            else
                ++x;
        }
    }
    runs.endRows();
    static_cast<void>(runs.join(Progress()));
    std::vector<int> partAt(mask.pixels.size(), -1);
    std::map<std::uint32_t, int> known;
    runs.forEach([&](std::size_t run, int y, int) {
        const int part = known.emplace(runs.partOf(run), int(known.size())).first->second;
        const auto row = partAt.begin() + std::ptrdiff_t(mask.indexOf({0, y}));
        std::fill(row + runs.run(run).begin, row + runs.run(run).end, part);
    });
    parts = int(known.size());
    return partAt;
}

template <class Visit> void forEachDrawn(const SliceParts& slice, const Visit& visit)
{
    std::size_t at = 0;
    for (int y = 0; y < slice.size.y; ++y) {
        for (int x = 0; x < slice.size.x; ++x, ++at) {
            if (slice.partAt[at] >= 0)
                visit(std::size_t(slice.partAt[at]), glm::ivec2(x, y));
        }
    }
}

/// Sets that are joined; each is known by its least member.
class Joined {
public:
    explicit Joined(std::size_t count)
        : m_parent(count)
    {
        std::iota(m_parent.begin(), m_parent.end(), std::size_t(0));
    }
    [[nodiscard]] std::size_t of(std::size_t each) const
    {
        while (m_parent[each] != each)
            each = m_parent[each];
        return each;
    }
    void join(std::size_t one, std::size_t other)
    {
        const auto [least, greatest] = std::minmax({of(one), of(other)});
        m_parent[greatest] = least;
    }

private:
    std::vector<std::size_t> m_parent;
};

std::optional<std::size_t> nearestOf(
    const std::vector<SlicePart>& parts, const glm::ivec2& to, const SliceSteps& steps)
{
    std::optional<std::size_t> nearest;
    for (std::size_t part = 0; part < parts.size(); ++part) {
        if (!nearest
            || steps.squared(parts[part].centroid - to)
                < steps.squared(parts[*nearest].centroid - to))
            nearest = part;
    }
    return nearest;
}

} // namespace

SliceParts sliceParts(const SliceMask& mask, const SliceSteps& steps)
{
    SliceParts slice{.size = mask.size};
    int count = 0;
    slice.partAt = partAtPixels(mask, count);
    slice.parts.assign(std::size_t(count), SlicePart{.begin = mask.size});
    std::vector<glm::i64vec2> sums(std::size_t(count), glm::i64vec2(0));
    std::vector<std::int64_t> pixels(std::size_t(count), 0);
    forEachDrawn(slice, [&](std::size_t of, const glm::ivec2& at) {
        SlicePart& part = slice.parts[of];
        part.begin = glm::min(part.begin, at);
        part.end = glm::max(part.end, at + 1);
        sums[of] += glm::i64vec2(at);
        ++pixels[of];
    });
    for (std::size_t of = 0; of < slice.parts.size(); ++of) {
        SlicePart& part = slice.parts[of];
        part.centroid = {meanOf(sums[of].x, pixels[of]), meanOf(sums[of].y, pixels[of])};
        part.middle = mask.size * 2; // farther than all of its pixels
    }
    forEachDrawn(slice, [&](std::size_t of, const glm::ivec2& at) {
        SlicePart& part = slice.parts[of];
        if (steps.squared(at - part.centroid) < steps.squared(part.middle - part.centroid))
            part.middle = at;
    });
    return slice;
}

std::vector<MatchedParts> matchedParts(
    const SliceParts& lower, const SliceParts& upper, const SliceSteps& steps)
{
    const std::size_t lowers = lower.parts.size();
    const std::size_t all = lowers + upper.parts.size();
    Joined joined(all);
    std::vector<bool> overlaps(all, false);
    for (std::size_t at = 0; at < lower.partAt.size(); ++at) {
        if (lower.partAt[at] < 0 || upper.partAt[at] < 0)
            continue;
        const auto one = std::size_t(lower.partAt[at]);
        const std::size_t other = lowers + std::size_t(upper.partAt[at]);
        joined.join(one, other);
        overlaps[one] = true;
        overlaps[other] = true;
    }
    for (std::size_t part = 0; part < lowers; ++part) {
        const glm::ivec2& centroid = lower.parts[part].centroid;
        const auto nearest = nearestOf(upper.parts, centroid, steps);
        if (overlaps[part] || !nearest || overlaps[lowers + *nearest])
            continue;
        if (nearestOf(lower.parts, upper.parts[*nearest].centroid, steps) == part)
            joined.join(part, lowers + *nearest);
    }
    std::map<std::size_t, MatchedParts> groups;
    for (std::size_t part = 0; part < all; ++part) {
        MatchedParts& group = groups[joined.of(part)];
        group.overlap = group.overlap || overlaps[part];
        if (part < lowers)
            group.lower.push_back(int(part));
        else
            group.upper.push_back(int(part - lowers));
    }
    std::vector<MatchedParts> matched;
    for (auto& [least, group] : groups)
        matched.push_back(std::move(group));
    return matched;
}

} // namespace core
