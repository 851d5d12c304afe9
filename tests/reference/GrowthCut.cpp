// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/GrowthCut.h"

#include "core/growth/GrowthCut.h"
#include "core/growth/SeedWord.h"
#include "tests/reference/Growth.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

namespace reference {

namespace seedWord = core::seedWord;

namespace {

using Words = DenseArray<std::uint32_t>;
using Set = std::set<std::size_t>; ///< voxels by their offset in the volume

glm::ivec3 placeOf(const Words& words, std::size_t voxel)
{
    const auto x = std::size_t(words.size.x);
    const auto y = std::size_t(words.size.y);
    return {int(voxel % x), int(voxel / x % y), int(voxel / (x * y))};
}

/// The neighbours in the first so many directions.
std::vector<std::size_t> neighbours(const Words& words, std::size_t voxel, int directions = 26)
{
    std::vector<std::size_t> found;
    const glm::ivec3 place = placeOf(words, voxel);
    for (int direction = 0; direction < directions; ++direction) {
        const auto& offset = seedWord::offsets[std::size_t(direction)];
        const glm::ivec3 next = place + glm::ivec3(offset[0], offset[1], offset[2]);
        if (words.contains(next))
            found.push_back(words.offset(next));
    }
    return found;
}

/// A flow network; arcs are added with their capacity, and what flows is kept as capacity of the
/// way back. Places are numbered as they come. Fills all shortest ways before it looks for longer
/// ones (Dinic): wide growths have hundreds of ways through millions of arcs.
class Network {
public:
    void add(std::size_t from, std::size_t to, int capacity)
    {
        const std::size_t a = number(from);
        const std::size_t b = number(to);
        m_edges[a].push_back({.to = b, .left = capacity, .back = m_edges[b].size()});
        m_edges[b].push_back({.to = a, .left = 0, .back = m_edges[a].size() - 1});
    }
    /// Lets as much through as goes.
    void fill(std::size_t source, std::size_t sink)
    {
        const std::size_t first = number(source);
        const std::size_t last = number(sink);
        for (;;) {
            m_steps = stepsFrom(first);
            if (m_steps[last] == unreached)
                return;
            m_tried.assign(m_edges.size(), 0);
            while (push(first, last)) { }
        }
    }
    /// The places to which more would get through from the source.
    Set reached(std::size_t source)
    {
        const std::vector<int> steps = stepsFrom(number(source));
        Set places;
        for (const auto& [place, number] : m_numbers) {
            if (steps[number] != unreached)
                places.insert(place);
        }
        return places;
    }

private:
    static constexpr int unreached = -1;
    struct Edge {
        std::size_t to = 0;
        int left = 0;
        std::size_t back = 0; ///< place of the opposite edge there
    };

    std::size_t number(std::size_t place)
    {
        const auto [found, isNew] = m_numbers.emplace(place, m_numbers.size());
        if (isNew)
            m_edges.emplace_back();
        return found->second;
    }
    [[nodiscard]] std::vector<int> stepsFrom(std::size_t source) const
    {
        std::vector<int> steps(m_edges.size(), unreached);
        steps[source] = 0;
        std::vector<std::size_t> queue{source};
        for (std::size_t next = 0; next < queue.size(); ++next) {
            const std::size_t at = queue[next];
            for (const Edge& edge : m_edges[at]) {
                if (edge.left <= 0 || steps[edge.to] != unreached)
                    continue;
                steps[edge.to] = steps[at] + 1;
                queue.push_back(edge.to);
            }
        }
        return steps;
    }
    /// One more unit by a shortest way; edges that lead nowhere are not tried again.
    bool push(std::size_t first, std::size_t last)
    {
        std::vector<std::size_t> way; // the places before the present one
        for (std::size_t at = first; at != last;) {
            std::vector<Edge>& edges = m_edges[at];
            std::size_t& tried = m_tried[at];
            while (tried < edges.size()
                && (edges[tried].left <= 0 || m_steps[edges[tried].to] != m_steps[at] + 1))
                ++tried;
            if (tried < edges.size()) {
                way.push_back(at);
                at = edges[tried].to;
                continue;
            }
            if (way.empty())
                return false;
            at = way.back();
            way.pop_back();
            ++m_tried[at];
        }
        for (const std::size_t at : way) {
            Edge& edge = m_edges[at][m_tried[at]];
            --edge.left;
            ++m_edges[edge.to][edge.back].left;
        }
        return true;
    }

    std::unordered_map<std::size_t, std::size_t> m_numbers;
    std::vector<std::vector<Edge>> m_edges;
    std::vector<int> m_steps; ///< from the source, as the ways were when last looked for
    std::vector<std::size_t> m_tried; ///< of each place's edges
};

class LabelCut {
public:
    LabelCut(const Words& words, const core::CutGrowth& command, std::uint32_t label)
        : m_words(words)
        , m_command(command)
        , m_label(label)
    {
        for (std::size_t voxel = 0; voxel < words.values.size(); ++voxel) {
            if (isMember(voxel))
                m_byGeneration[generation(voxel)].insert(voxel);
        }
    }

    [[nodiscard]] bool isMember(std::size_t voxel) const
    {
        const std::uint32_t word = m_words.values[voxel];
        return seedWord::isMember(word) && seedWord::label(word) == m_label;
    }

    Set leaving(const Set& sketch) const
    {
        if (m_command.how == core::CutGrowth::How::Here)
            return sketch;
        const Set way = wayTo(sketch);
        const Set beyond = beyondFrom(sketch);
        const auto width = [&](const Set& voxels, std::uint32_t n) {
            return std::int64_t(std::count_if(voxels.begin(), voxels.end(),
                [&](std::size_t voxel) { return generation(voxel) == n; }));
        };
        std::map<std::uint32_t, std::int64_t> w;
        std::map<std::uint32_t, std::int64_t> either;
        for (const auto& [n, members] : m_byGeneration) {
            w[n] = width(way, n);
            either[n] = std::max(w[n], width(beyond, n));
        }
        // Rule 6: the numerator of q for every generation where it is 3/2 or more.
        std::map<std::uint32_t, std::int64_t> wide;
        std::uint32_t best = 0;
        for (const auto& [n, own] : w) {
            if (own == 0)
                continue;
            std::int64_t before = 0;
            std::int64_t after = 0;
            for (const auto& [m, other] : w)
                before = m < n ? std::max(before, other) : before;
            for (const auto& [m, other] : either)
                after = m > n ? std::max(after, other) : after;
            const std::int64_t least = std::min(before, after);
            if (2 * least < 3 * own)
                continue;
            wide[n] = least;
            if (best == 0 || least * w[best] > wide[best] * own)
                best = n;
        }
        std::optional<Set> narrowest;
        for (const auto& [n, numerator] : wide) {
            bool isNeck = 2 * numerator * w[best] >= wide[best] * w[n];
            for (const auto& [m, other] : w) {
                const std::int64_t apart = std::int64_t(m) - std::int64_t(n);
                if (other == 0 || apart == 0 || std::abs(apart) > 4)
                    continue;
                isNeck = isNeck && (apart < 0 ? other > w[n] : other >= w[n]);
            }
            if (!isNeck && n != best)
                continue;
            std::uint32_t wideFrom = n + 1;
            while (either.count(wideFrom) == 0 || either[wideFrom] < numerator)
                ++wideFrom;
            Set front;
            for (const std::size_t voxel : way) {
                if (generation(voxel) == n)
                    front.insert(voxel);
            }
            Set cut = narrowestNear(front, wideFrom);
            if (!narrowest || cut.size() < narrowest->size())
                narrowest = std::move(cut);
        }
        if (!narrowest)
            return m_command.how == core::CutGrowth::How::Neck ? Set{} : closed(sketch);
        return closed(*narrowest);
    }

private:
    [[nodiscard]] std::uint32_t generation(std::size_t voxel) const
    {
        return seedWord::generation(m_words.values[voxel]);
    }
    [[nodiscard]] bool isRoot(std::size_t voxel) const
    {
        return seedWord::direction(m_words.values[voxel]) >= 30 || generation(voxel) == 0;
    }

    [[nodiscard]] std::vector<std::size_t> parents(std::size_t voxel) const
    {
        std::vector<std::size_t> found;
        if (isRoot(voxel))
            return found;
        const std::uint32_t direction = seedWord::direction(m_words.values[voxel]);
        for (const std::size_t next : neighbours(m_words, voxel,
                 direction < 6        ? 6
                     : direction < 18 ? 18
                                      : 26)) {
            if (isMember(next) && generation(next) < generation(voxel))
                found.push_back(next);
        }
        return found;
    }

    [[nodiscard]] Set frontOf(std::size_t voxel) const
    {
        Set front{voxel};
        std::vector<std::size_t> open{voxel};
        while (!open.empty()) {
            const std::size_t at = open.back();
            open.pop_back();
            for (const std::size_t next : neighbours(m_words, at, m_command.connectivity)) {
                if (isMember(next) && generation(next) == generation(voxel)
                    && front.insert(next).second)
                    open.push_back(next);
            }
        }
        return front;
    }

    [[nodiscard]] Set frontsOf(const Set& voxels) const
    {
        Set fronts;
        for (const std::size_t voxel : voxels) {
            if (fronts.count(voxel) == 0)
                fronts.merge(frontOf(voxel));
        }
        return fronts;
    }

    [[nodiscard]] Set wayTo(const Set& sketch) const
    {
        Set way;
        Set open = frontsOf(sketch);
        while (!open.empty()) {
            Set before;
            for (const std::size_t voxel : open) {
                for (const std::size_t parent : parents(voxel))
                    before.insert(parent);
            }
            way.merge(open);
            Set next = frontsOf(before);
            open.clear();
            for (const std::size_t voxel : next) {
                if (way.count(voxel) == 0)
                    open.insert(voxel);
            }
        }
        return way;
    }

    [[nodiscard]] Set beyondFrom(const Set& sketch) const
    {
        Set beyond = frontsOf(sketch);
        for (const auto& [n, members] : m_byGeneration) {
            for (const std::size_t voxel : members) {
                for (const std::size_t parent : parents(voxel)) {
                    if (beyond.count(parent) != 0)
                        beyond.insert(voxel);
                }
            }
        }
        return beyond;
    }

    [[nodiscard]] Set closed(const Set& cut) const
    {
        Set leaves;
        for (const std::size_t voxel : cut) {
            if (generation(voxel) != 0)
                leaves.insert(voxel);
        }
        for (const auto& [n, members] : m_byGeneration) {
            for (const std::size_t voxel : members) {
                const std::vector<std::size_t> before = parents(voxel);
                if (!before.empty()
                    && std::all_of(before.begin(), before.end(),
                        [&](std::size_t parent) { return leaves.count(parent) != 0; }))
                    leaves.insert(voxel);
            }
        }
        return leaves;
    }

    [[nodiscard]] Set narrowestNear(const Set& front, std::uint32_t wideFrom) const
    {
        if (front.size() > core::widestPassage)
            return front;
        const Set within = closed(front);
        glm::ivec3 low = placeOf(m_words, *front.begin());
        glm::ivec3 high = low;
        for (const std::size_t voxel : front) {
            low = glm::min(low, placeOf(m_words, voxel));
            high = glm::max(high, placeOf(m_words, voxel));
        }
        const glm::ivec3 side = high - low + 1;
        const int farthest =
            std::min(2 + std::max({side.x, side.y, side.z}), core::farthestPassage);
        std::map<std::size_t, int> steps;
        for (const std::size_t voxel : front)
            steps[voxel] = 0;
        for (int step = 1; step <= farthest; ++step) {
            for (const auto& [voxel, before] : std::map(steps)) {
                for (const std::size_t next : neighbours(m_words, voxel)) {
                    if (isMember(next))
                        steps.emplace(next, step);
                }
            }
        }

        // A voxel is entered at 2v and left at 2v + 1, once.
        const std::size_t source = 2 * m_words.values.size();
        const std::size_t sink = source + 1;
        constexpr int many = 1 << 30;
        Network network;
        bool sources = false;
        bool sinks = false;
        for (const auto& [voxel, step] : steps) {
            network.add(2 * voxel, 2 * voxel + 1, 1);
            for (const std::size_t next : neighbours(m_words, voxel)) {
                if (steps.count(next) != 0)
                    network.add(2 * voxel + 1, 2 * next, many);
            }
            const bool goes = within.count(voxel) != 0;
            if (!goes && (step == farthest || isRoot(voxel))) {
                network.add(source, 2 * voxel, many);
                sources = true;
            }
            if (goes && (step == farthest || generation(voxel) >= wideFrom)) {
                network.add(2 * voxel + 1, sink, many);
                sinks = true;
            }
        }
        if (!sources || !sinks)
            return front;
        network.fill(source, sink);
        const Set reached = network.reached(source);
        Set cut;
        for (const auto& [voxel, step] : steps) {
            if (reached.count(2 * voxel) != 0 && reached.count(2 * voxel + 1) == 0)
                cut.insert(voxel);
        }
        if (std::any_of(cut.begin(), cut.end(), [&](std::size_t voxel) { return isRoot(voxel); }))
            return front;
        return cut;
    }

    const Words& m_words;
    const core::CutGrowth& m_command;
    std::uint32_t m_label;
    std::map<std::uint32_t, Set> m_byGeneration;
};

} // namespace

std::uint32_t cutGrowth(DenseFields& fields, const core::CutGrowth& command)
{
    Words& words = fields.seedWords(command.plane);
    const Words before = words;
    bool anything = false;
    for (std::uint32_t label = 1; label < 256; ++label) {
        if (command.frozen.test(label))
            continue;
        Set sketch;
        for (const glm::ivec3& place : command.voxels) {
            const std::uint32_t word = before.at(place);
            if (seedWord::isMember(word) && seedWord::label(word) == label
                && seedWord::generation(word) != 0)
                sketch.insert(before.offset(place));
        }
        if (sketch.empty())
            continue;
        const LabelCut cut(before, command, label);
        const Set leaving = cut.leaving(sketch);
        Set shut;
        for (const std::size_t voxel : leaving) {
            giveBack(fields, command.plane, placeOf(before, voxel), before.values[voxel]);
            words.values[voxel] = seedWord::unvisited;
            for (const std::size_t next : neighbours(before, voxel)) {
                if (command.barrier && cut.isMember(next) && leaving.count(next) == 0)
                    shut.insert(voxel);
            }
        }
        for (const std::size_t voxel : shut) {
            words.values[voxel] = seedWord::barrier;
            for (const std::size_t next : neighbours(before, voxel)) {
                const std::uint32_t word = words.values[next];
                if (!seedWord::isMember(word) && !seedWord::isPendingSeed(word))
                    words.values[next] = seedWord::barrier;
            }
        }
        anything = anything || !leaving.empty();
    }
    if (!anything)
        return command.generation;
    std::uint32_t greatest = 0;
    for (const std::uint32_t word : words.values) {
        if (seedWord::isMember(word))
            greatest = std::max(greatest, seedWord::generation(word));
    }
    return greatest;
}

core::ForeseenCut foreseeCut(const DenseFields& fields, const core::CutGrowth& command)
{
    DenseFields before = fields;
    DenseFields after = fields;
    cutGrowth(after, command);
    core::ForeseenCut foreseen;
    const Words& words = before.seedWords(command.plane);
    for (std::size_t voxel = 0; voxel < words.values.size(); ++voxel) {
        const bool goes = seedWord::isMember(words.values[voxel])
            && !seedWord::isMember(after.seedWords(command.plane).values[voxel]);
        foreseen.members += goes ? 1 : 0;
    }
    const core::BrickGrid grid{fields.size()};
    std::map<std::uint32_t, std::bitset<core::BrickGrid::voxelsPerBrick>> taken;
    for (int z = 0; z < fields.size().z; ++z) {
        for (int y = 0; y < fields.size().y; ++y) {
            for (int x = 0; x < fields.size().x; ++x) {
                const glm::ivec3 voxel(x, y, z);
                if (before.labels(command.plane).at(voxel) == after.labels(command.plane).at(voxel))
                    continue;
                ++foreseen.voxels;
                taken[std::uint32_t(grid.brickOf(voxel))].set(
                    std::size_t(core::BrickGrid::offsetInBrick(voxel)));
            }
        }
    }
    for (const auto& [brick, voxels] : taken)
        foreseen.bricks.push_back({.brick = brick, .taken = voxels});
    return foreseen;
}

} // namespace reference
