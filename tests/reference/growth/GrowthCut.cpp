// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/growth/GrowthCut.h"

#include "core/growth/SeedWord.h"
#include "core/growth/cut/GrowthCut.h"
#include "tests/reference/growth/FlowNetwork.h"
#include "tests/reference/growth/Growth.h"
#include "tests/reference/growth/LabelFamily.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <vector>

namespace reference {

namespace seedWord = core::seedWord;

namespace {

using Words = LabelFamily::Words;
using Set = LabelFamily::Set;

class LabelCut {
public:
    LabelCut(const Words& words, const core::CutGrowth& command, std::uint32_t label)
        : m_words(words)
        , m_command(command)
        , m_family(words, label)
    {
    }

    /// What leaves, and what becomes of the words of others.
    struct Outcome {
        Set leaving;
        std::map<std::size_t, std::uint32_t> words;
    };
    Outcome outcome(const Set& sketch) const
    {
        using How = core::CutGrowth::How;
        if (m_command.how == How::Backwards) {
            const Set leaving = backwards(sketch);
            return withoutThem(leaving, m_family.behind(leaving));
        }
        const bool here = m_command.how == How::Here;
        const std::optional<Set> cut = here ? std::nullopt : narrowestCut(sketch);
        Outcome found;
        if (m_command.how == How::Neck) {
            found.leaving = cut ? m_family.behind(*cut) : Set{};
            return found;
        }
        Set from = sketch;
        if (cut)
            from.insert(cut->begin(), cut->end());
        const Set all = m_family.behind(from);
        return withoutThem(here ? sketch : m_family.notNearerToRoots(all, sketch), all);
    }

    /// Rule 12: what leaves, before what rule 10 finds.
    Set backwards(const Set& sketch) const
    {
        const Set near = nearMembers(sketch);
        const Set ancestors = ancestorsAt(m_command.steps, near, sketch);
        Set leaving;
        for (const auto& [n, members] : m_family.byGeneration()) {
            for (const std::size_t voxel : members) {
                bool leaves = ancestors.count(voxel) != 0;
                for (const std::size_t parent : m_family.parents(voxel))
                    leaves = leaves || (near.count(voxel) != 0 && leaving.count(parent) != 0);
                if (leaves)
                    leaving.insert(voxel);
            }
        }
        return leaving;
    }
    bool isEverything(const Set& leaving) const
    {
        for (const auto& [n, members] : m_family.byGeneration()) {
            for (const std::size_t voxel : members) {
                if (!m_family.isRoot(voxel) && leaving.count(voxel) == 0)
                    return false;
            }
        }
        return true;
    }
    /// How many steps of those that are asked for do anything.
    std::uint32_t stepsDone(const Set& sketch) const
    {
        const Set near = nearMembers(sketch);
        std::uint32_t done = 1;
        while (done < m_command.steps
            && ancestorsAt(done, near, sketch) != ancestorsAt(done + 1, near, sketch))
            ++done;
        return done;
    }

private:
    Set nearMembers(const Set& sketch) const
    {
        Set grown;
        for (const auto& [n, members] : m_family.byGeneration()) {
            for (const std::size_t voxel : members) {
                if (!m_family.isRoot(voxel))
                    grown.insert(voxel);
            }
        }
        return m_family.notNearerToRoots(grown, sketch);
    }
    Set ancestorsAt(std::uint32_t step, const Set& near, const Set& sketch) const
    {
        Set ancestors = sketch;
        for (std::uint32_t before = 1; before < step; ++before) {
            Set more;
            for (const std::size_t voxel : ancestors) {
                for (const std::size_t parent : m_family.parents(voxel)) {
                    if (near.count(parent) != 0)
                        more.insert(parent);
                }
            }
            const std::size_t known = ancestors.size();
            ancestors.merge(more);
            if (ancestors.size() == known)
                break;
        }
        return ancestors;
    }

    /// Rule 10. @param all what lies behind what leaves
    Outcome withoutThem(const Set& leaving, const Set& all) const
    {
        const bool here = m_command.how == core::CutGrowth::How::Here;
        Outcome found;
        found.leaving = leaving;
        Set staying;
        for (const std::size_t voxel : all) {
            if (found.leaving.count(voxel) == 0)
                staying.insert(voxel);
        }
        const LabelFamily::Times times = m_family.timesOf(staying, found.leaving);
        for (const std::size_t voxel : staying) {
            const auto time = times.find(voxel);
            if (time == times.end()) {
                if (!here)
                    found.leaving.insert(voxel);
                continue;
            }
            const std::uint32_t word = m_family.retimed(voxel, times);
            if (word != m_words.values[voxel])
                found.words[voxel] = word;
        }
        return found;
    }

    /// Rules 4 to 6 and 8.
    [[nodiscard]] std::optional<Set> narrowestCut(const Set& sketch) const
    {
        const Set way = wayTo(sketch);
        const Set beyond = beyondFrom(sketch);
        const auto width = [&](const Set& voxels, std::uint32_t n) {
            return std::int64_t(std::count_if(voxels.begin(), voxels.end(),
                [&](std::size_t voxel) { return m_family.generation(voxel) == n; }));
        };
        std::map<std::uint32_t, std::int64_t> w;
        std::map<std::uint32_t, std::int64_t> either;
        for (const auto& [n, members] : m_family.byGeneration()) {
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
                if (m_family.generation(voxel) == n)
                    front.insert(voxel);
            }
            Set cut = narrowestNear(front, wideFrom);
            const Set gone = m_family.behind(cut);
            const bool whole =
                std::includes(gone.begin(), gone.end(), sketch.begin(), sketch.end());
            if (whole && (!narrowest || cut.size() < narrowest->size()))
                narrowest = std::move(cut);
        }
        return narrowest;
    }

    [[nodiscard]] Set frontOf(std::size_t voxel) const
    {
        Set front{voxel};
        std::vector<std::size_t> open{voxel};
        while (!open.empty()) {
            const std::size_t at = open.back();
            open.pop_back();
            for (const std::size_t next : neighbours(m_words, at, m_command.connectivity)) {
                if (m_family.isMember(next)
                    && m_family.generation(next) == m_family.generation(voxel)
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
                for (const std::size_t parent : m_family.parents(voxel))
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
        for (const auto& [n, members] : m_family.byGeneration()) {
            for (const std::size_t voxel : members) {
                for (const std::size_t parent : m_family.parents(voxel)) {
                    if (beyond.count(parent) != 0)
                        beyond.insert(voxel);
                }
            }
        }
        return beyond;
    }

    [[nodiscard]] Set narrowestNear(const Set& front, std::uint32_t wideFrom) const
    {
        if (front.size() > core::widestPassage)
            return front;
        const Set within = m_family.behind(front);
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
                    if (m_family.isMember(next))
                        steps.emplace(next, step);
                }
            }
        }

        // A voxel is entered at 2v and left at 2v + 1, once.
        const std::size_t source = 2 * m_words.values.size();
        const std::size_t sink = source + 1;
        constexpr int many = 1 << 30;
        FlowNetwork network;
        bool sources = false;
        bool sinks = false;
        for (const auto& [voxel, step] : steps) {
            network.add(2 * voxel, 2 * voxel + 1, 1);
            for (const std::size_t next : neighbours(m_words, voxel)) {
                if (steps.count(next) != 0)
                    network.add(2 * voxel + 1, 2 * next, many);
            }
            const bool goes = within.count(voxel) != 0;
            if (!goes && (step == farthest || m_family.isRoot(voxel))) {
                network.add(source, 2 * voxel, many);
                sources = true;
            }
            if (goes && (step == farthest || m_family.generation(voxel) >= wideFrom)) {
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
        if (std::any_of(
                cut.begin(), cut.end(), [&](std::size_t voxel) { return m_family.isRoot(voxel); }))
            return front;
        return cut;
    }

    const Words& m_words;
    const core::CutGrowth& m_command;
    LabelFamily m_family;
};

/// Rule 1: the sketch of each label.
core::Result<std::map<std::uint32_t, Set>> sketches(
    const Words& words, const core::CutGrowth& command)
{
    std::map<std::uint32_t, Set> found;
    Set roots;
    for (const glm::ivec3& place : command.voxels) {
        const std::uint32_t word = words.at(place);
        if (!seedWord::isMember(word) || command.lockedLabels.test(seedWord::label(word)))
            continue;
        const bool root = seedWord::direction(word) >= 30 || seedWord::generation(word) == 0;
        (root ? roots : found[seedWord::label(word)]).insert(words.offset(place));
    }
    if (!roots.empty())
        return core::failure(core::ErrorCode::SeedsStay, QString::number(roots.size()));
    if (found.empty())
        return core::failure(core::ErrorCode::NothingGrown);
    return found;
}

} // namespace

core::Result<CutDone> cutGrowth(DenseFields& fields, const core::CutGrowth& command)
{
    Words& words = fields.seedWords(command.plane);
    const Words before = words;
    const auto sketched = sketches(before, command);
    if (!sketched)
        return tl::unexpected(sketched.error());
    CutDone done{.generation = command.generation};
    if (command.how == core::CutGrowth::How::Backwards) {
        for (const auto& [label, sketch] : *sketched) {
            const LabelCut cut(before, command, label);
            const Set leaving = cut.backwards(sketch);
            if (cut.isEverything(leaving))
                return core::failure(core::ErrorCode::EverythingGrown);
            done.backwards.steps = std::max(done.backwards.steps, cut.stepsDone(sketch));
            done.backwards.members += std::int64_t(leaving.size());
        }
        if (done.backwards.steps < command.steps)
            done.backwards.bound = core::BackwardProgress::Bound::Seeds;
    }
    bool anything = false;
    for (const auto& [label, sketch] : *sketched) {
        const LabelCut cut(before, command, label);
        const LabelCut::Outcome outcome = cut.outcome(sketch);
        const Set& leaving = outcome.leaving;
        for (const auto& [voxel, word] : outcome.words)
            words.values[voxel] = word;
        Set shut;
        for (const std::size_t voxel : leaving) {
            giveBack(fields, command.plane, placeOf(before, voxel), before.values[voxel]);
            words.values[voxel] = seedWord::unvisited;
            for (const std::size_t next : neighbours(before, voxel)) {
                if (command.barrier && seedWord::isMember(before.values[next])
                    && seedWord::label(before.values[next]) == label && leaving.count(next) == 0)
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
        return done;
    std::uint32_t greatest = 0;
    for (const std::uint32_t word : words.values) {
        if (seedWord::isMember(word))
            greatest = std::max(greatest, seedWord::generation(word));
    }
    done.generation = greatest;
    return done;
}

core::Result<core::CutPreview> previewCut(const DenseFields& fields, const core::CutGrowth& command)
{
    DenseFields before = fields;
    DenseFields after = fields;
    if (const auto cut = cutGrowth(after, command); !cut)
        return tl::unexpected(cut.error());
    core::CutPreview cutPreview;
    const Words& words = before.seedWords(command.plane);
    for (std::size_t voxel = 0; voxel < words.values.size(); ++voxel) {
        const bool goes = seedWord::isMember(words.values[voxel])
            && !seedWord::isMember(after.seedWords(command.plane).values[voxel]);
        cutPreview.members += goes ? 1 : 0;
    }
    const core::BrickGrid grid{fields.size()};
    std::map<std::uint32_t, std::bitset<core::BrickGrid::voxelsPerBrick>> taken;
    for (int z = 0; z < fields.size().z; ++z) {
        for (int y = 0; y < fields.size().y; ++y) {
            for (int x = 0; x < fields.size().x; ++x) {
                const glm::ivec3 voxel(x, y, z);
                if (before.labels(command.plane).at(voxel) == after.labels(command.plane).at(voxel))
                    continue;
                ++cutPreview.voxels;
                taken[std::uint32_t(grid.brickOf(voxel))].set(
                    std::size_t(core::BrickGrid::offsetInBrick(voxel)));
            }
        }
    }
    for (const auto& [brick, voxels] : taken)
        cutPreview.bricks.push_back({.brick = brick, .taken = voxels});
    return cutPreview;
}

} // namespace reference
