// SPDX-License-Identifier: Apache-2.0
#include "core/growth/GrowthCut.h"

#include "core/growth/CutWriting.h"
#include "core/growth/FrontSurroundings.h"
#include "core/growth/NarrowestCut.h"

#include <algorithm>
#include <map>
#include <optional>

namespace core {

namespace {

using Voxel = WordBricks::Voxel;
using Voxels = std::vector<Voxel>;

constexpr std::uint32_t faces = 6;
constexpr std::uint32_t facesAndEdges = 18;

/// Neighbours among which the parents of a member lie (rule 2).
std::uint32_t parentReach(std::uint32_t word)
{
    const std::uint32_t direction = seedWord::direction(word);
    return direction < faces        ? faces
        : direction < facesAndEdges ? facesAndEdges
                                    : seedWord::directions;
}

bool isRoot(std::uint32_t word)
{
    return seedWord::isSeed(word) || seedWord::generation(word) == 0;
}

/// What the words hold, whichever the label.
struct Survey {
    std::uint32_t greatest = 0; ///< generation
    std::uint32_t reach = faces; ///< the farthest parentReach()
};

/// Voxels by generation, each put in while a generation is worked at that lies on its near side.
class Generations {
public:
    explicit Generations(std::uint32_t greatest)
        : m_voxels(std::size_t(greatest) + 1)
    {
    }
    Voxels& operator[](std::uint32_t generation) { return m_voxels[generation]; }
    [[nodiscard]] std::size_t width(std::uint32_t generation) const
    {
        return m_voxels[generation].size();
    }
    [[nodiscard]] std::uint32_t count() const { return std::uint32_t(m_voxels.size()); }

private:
    std::vector<Voxels> m_voxels;
};

/// One label's cut; the rules are those of GrowthCut.h.
class LabelCut {
public:
    LabelCut(const WordBricks& words, const CutGrowth& command, std::uint32_t label,
        const Survey& survey, std::vector<std::uint8_t>& marks)
        : m_words(words)
        , m_command(command)
        , m_label(label)
        , m_survey(survey)
        , m_marks(marks)
    {
    }

    /// Marks what leaves. @return it
    Voxels run(const Voxels& sketch)
    {
        if (m_command.how == CutGrowth::How::Here) {
            for (const Voxel voxel : sketch)
                m_marks[voxel] |= leaves;
            return sketch;
        }
        Generations way = wayTo(sketch);
        std::optional<Voxels> narrowest;
        for (const Neck& neck : findNecks(way, sketch)) {
            Voxels cut = cutAt(neck, way[neck.generation]);
            if (!narrowest || cut.size() < narrowest->size())
                narrowest = std::move(cut);
        }
        if (!narrowest && m_command.how == CutGrowth::How::Neck)
            return {};
        return leaving(narrowest.value_or(sketch), m_survey.greatest, leaves, looked);
    }

    static constexpr std::uint8_t leaves = 1; ///< marks what leaves

private:
    // Further marks:
    static constexpr std::uint8_t looked = 2; ///< for what leaves
    static constexpr std::uint8_t onWay = 4;
    static constexpr std::uint8_t beyond = 8;
    static constexpr std::uint8_t wouldLeave = 16; ///< if the neck were cut as it is
    static constexpr std::uint8_t wouldLooked = 32;

    struct Neck {
        std::uint32_t generation = 0;
        std::size_t wide = 0; ///< the numerator of q
        std::uint32_t wideFrom = 0; ///< the lowest later generation that is as wide
    };

    [[nodiscard]] bool isMember(std::uint32_t word) const
    {
        return (word & seedWord::notMember) == 0 && seedWord::label(word) == m_label;
    }
    [[nodiscard]] bool has(Voxel voxel, std::uint8_t mark) const
    {
        return (m_marks[voxel] & mark) != 0;
    }

    /// Adds to voxels of one generation all that their fronts hold.
    void completeFronts(Voxels& front, std::uint8_t mark)
    {
        for (std::size_t i = 0; i < front.size(); ++i) {
            const std::uint32_t claimed = m_words[front[i]] >> 5; // generation and label
            m_words.forNeighbours(front[i], 0, std::uint32_t(m_command.connectivity),
                [&](Voxel neighbour, std::uint32_t word, std::uint32_t) {
                    if (word >> 5 == claimed && !has(neighbour, mark)) {
                        m_marks[neighbour] |= mark;
                        front.push_back(neighbour);
                    }
                });
        }
    }

    template <class Visit> void forParents(Voxel voxel, const Visit& visit) const
    {
        const std::uint32_t own = m_words[voxel];
        if (isRoot(own))
            return;
        m_words.forNeighbours(
            voxel, 0, parentReach(own), [&](Voxel neighbour, std::uint32_t word, std::uint32_t) {
                if (isMember(word) && seedWord::generation(word) < seedWord::generation(own))
                    visit(neighbour);
            });
    }
    template <class Visit> void forChildren(Voxel voxel, const Visit& visit) const
    {
        const std::uint32_t own = seedWord::generation(m_words[voxel]);
        m_words.forNeighbours(voxel, 0, m_survey.reach,
            [&](Voxel neighbour, std::uint32_t word, std::uint32_t direction) {
                if (isMember(word) && seedWord::generation(word) > own && !isRoot(word)
                    && direction < parentReach(word))
                    visit(neighbour);
            });
    }

    /// Rule 4.
    Generations wayTo(const Voxels& sketch)
    {
        Generations way(m_survey.greatest);
        const auto add = [&](Voxel voxel) {
            if (has(voxel, onWay))
                return;
            m_marks[voxel] |= onWay;
            way[seedWord::generation(m_words[voxel])].push_back(voxel);
        };
        for (const Voxel voxel : sketch)
            add(voxel);
        for (std::uint32_t n = way.count(); n-- > 0;) {
            completeFronts(way[n], onWay);
            for (const Voxel voxel : way[n])
                forParents(voxel, add);
        }
        return way;
    }

    /// Rules 5 and 6. What lies beyond is followed as far as it can tell something.
    std::vector<Neck> findNecks(Generations& way, const Voxels& sketch)
    {
        std::size_t widest = 0;
        std::uint32_t last = 0;
        for (std::uint32_t n = 0; n < way.count(); ++n) {
            widest = std::max(widest, way.width(n));
            last = way.width(n) > 0 ? n : last;
        }
        Generations later(m_survey.greatest);
        const auto add = [&](Voxel voxel) {
            if (has(voxel, beyond))
                return;
            m_marks[voxel] |= beyond;
            later[seedWord::generation(m_words[voxel])].push_back(voxel);
        };
        std::map<std::uint32_t, Voxels> fronts;
        for (const Voxel voxel : sketch) {
            m_marks[voxel] |= beyond;
            fronts[seedWord::generation(m_words[voxel])].push_back(voxel);
        }
        for (auto& [n, front] : fronts) {
            completeFronts(front, beyond);
            later[n].insert(later[n].end(), front.begin(), front.end());
        }
        std::vector<std::size_t> width(way.count(), 0); // the greater of w and b
        for (std::uint32_t n = 0; n < way.count(); ++n) {
            for (const Voxel voxel : later[n])
                forChildren(voxel, add);
            width[n] = std::max(way.width(n), later.width(n));
            if (n > last && width[n] >= widest)
                break;
        }
        return necksOf(way, width);
    }

    static std::vector<Neck> necksOf(const Generations& way, const std::vector<std::size_t>& width)
    {
        std::vector<std::size_t> after(width.size() + 1, 0); // greatest width from here on
        for (std::size_t n = width.size(); n-- > 0;)
            after[n] = std::max(after[n + 1], width[n]);
        std::vector<Neck> all;
        std::size_t best = 0; // of them
        std::size_t before = 0;
        for (std::uint32_t n = 0; n < way.count(); ++n) {
            const std::size_t own = way.width(n);
            const std::size_t wide = std::min(before, after[n + 1]);
            before = std::max(before, own);
            if (own == 0 || 2 * wide < 3 * own)
                continue;
            all.push_back({.generation = n, .wide = wide, .wideFrom = n + 1});
            if (wide * way.width(all[best].generation) > all[best].wide * own)
                best = all.size() - 1;
        }
        std::vector<Neck> necks;
        for (std::size_t i = 0; i < all.size(); ++i) {
            Neck& neck = all[i];
            const std::size_t own = way.width(neck.generation);
            const std::size_t bestOwn = way.width(all[best].generation);
            const bool good = 2 * neck.wide * bestOwn >= all[best].wide * own;
            if (i != best && !(good && isNarrowest(way, neck.generation)))
                continue;
            while (width[neck.wideFrom] < neck.wide)
                ++neck.wideFrom;
            necks.push_back(neck);
        }
        return necks;
    }

    /// Among the generations around it on the way.
    static bool isNarrowest(const Generations& way, std::uint32_t n)
    {
        constexpr std::uint32_t around = 4;
        const std::size_t own = way.width(n);
        for (std::uint32_t m = n - std::min(n, around); m < way.count() && m <= n + around; ++m) {
            const std::size_t other = way.width(m);
            if (other != 0 && (m < n ? other <= own : other < own))
                return false;
        }
        return true;
    }

    /// Rule 7.
    Voxels cutAt(const Neck& neck, const Voxels& front)
    {
        if (front.size() > widestPassage)
            return front;
        const FrontSurroundings around(
            m_words, front, [this](std::uint32_t word) { return isMember(word); });
        std::uint32_t latest = 0;
        for (const Voxel voxel : around.voxels())
            latest = std::max(latest, seedWord::generation(m_words[voxel]));
        (void)leaving(front, latest, wouldLeave, wouldLooked);
        PassageGraph graph;
        graph.source.resize(around.voxels().size());
        graph.sink.resize(around.voxels().size());
        bool sources = false;
        bool sinks = false;
        for (std::size_t node = 0; node < around.voxels().size(); ++node) {
            const Voxel voxel = around.voxels()[node];
            const std::uint32_t word = m_words[voxel];
            const bool far = around.isFarthest(node);
            const bool within = has(voxel, wouldLeave);
            graph.source[node] = !within && (far || isRoot(word));
            graph.sink[node] = within && (far || seedWord::generation(word) >= neck.wideFrom);
            sources = sources || graph.source[node];
            sinks = sinks || graph.sink[node];
            m_words.forNeighbours(voxel, 0, seedWord::directions,
                [&](Voxel neighbour, std::uint32_t other, std::uint32_t) {
                    if (!isMember(other))
                        return;
                    const std::uint32_t next = around.nodeAt(m_words.positionOf(neighbour));
                    if (next != FrontSurroundings::none)
                        graph.next.push_back(next);
                });
            graph.first.push_back(std::uint32_t(graph.next.size()));
        }
        for (const Voxel voxel : m_seen)
            m_marks[voxel] &= std::uint8_t(~(wouldLeave | wouldLooked));
        if (!sources || !sinks)
            return front;
        Voxels cut;
        for (const std::uint32_t node : narrowestCut(graph)) {
            cut.push_back(around.voxels()[node]);
            if (isRoot(m_words[cut.back()]))
                return front;
        }
        return cut;
    }

    /// Rule 9, up to a generation.
    /// @param gone marks what leaves
    /// @param seen marks what was looked at
    Voxels leaving(const Voxels& cut, std::uint32_t latest, std::uint8_t gone, std::uint8_t seen)
    {
        Voxels all;
        std::map<std::uint32_t, Voxels> waiting; // children of what leaves, by generation
        const auto leave = [&](Voxel voxel) {
            m_marks[voxel] |= gone;
            all.push_back(voxel);
            forChildren(voxel, [&](Voxel child) {
                if (has(child, seen))
                    return;
                m_marks[child] |= seen;
                m_seen.push_back(child);
                waiting[seedWord::generation(m_words[child])].push_back(child);
            });
        };
        m_seen = cut;
        for (const Voxel voxel : cut) {
            if (seedWord::generation(m_words[voxel]) != 0)
                m_marks[voxel] |= std::uint8_t(gone | seen);
        }
        for (const Voxel voxel : cut) {
            if (has(voxel, gone))
                leave(voxel);
        }
        while (!waiting.empty() && waiting.begin()->first <= latest) {
            const Voxels next = std::move(waiting.begin()->second);
            waiting.erase(waiting.begin());
            for (const Voxel voxel : next) {
                bool stays = false;
                forParents(voxel, [&](Voxel parent) { stays = stays || !has(parent, gone); });
                if (!stays)
                    leave(voxel);
            }
        }
        return all;
    }

    const WordBricks& m_words;
    const CutGrowth& m_command;
    std::uint32_t m_label;
    Survey m_survey;
    std::vector<std::uint8_t>& m_marks; ///< of each voxel

    Voxels m_seen; ///< marked by the last leaving()
};

Survey survey(const WordBricks& words)
{
    Survey found;
    for (std::size_t voxel = 0; voxel < words.count(); ++voxel) {
        const std::uint32_t word = words[Voxel(voxel)];
        if (!seedWord::isMember(word))
            continue;
        found.greatest = std::max(found.greatest, seedWord::generation(word));
        if (!seedWord::isSeed(word))
            found.reach = std::max(found.reach, parentReach(word));
    }
    return found;
}

/// Rule 10, for the voxels of one label that leave.
void write(CutWriting& writing, const WordBricks& words, const std::vector<std::uint8_t>& marks,
    const Voxels& leaving, std::uint32_t label, bool barrier)
{
    std::vector<glm::ivec3> shut;
    for (const Voxel voxel : leaving) {
        writing.leave(voxel, seedWord::wasHeld(words[voxel]) ? 0 : label);
        bool bounds = false;
        words.forNeighbours(voxel, 0, barrier ? seedWord::directions : 0,
            [&](Voxel neighbour, std::uint32_t word, std::uint32_t) {
                bounds = bounds
                    || (seedWord::isMember(word) && seedWord::label(word) == label
                        && (marks[neighbour] & LabelCut::leaves) == 0);
            });
        if (bounds)
            shut.push_back(words.positionOf(voxel));
    }
    for (const glm::ivec3& place : shut)
        writing.shut(place);
    for (const glm::ivec3& place : shut)
        writing.shutEmptyAround(place);
}

/// @param marks of each voxel; LabelCut::leaves is set where it leaves
LeavingVoxels markLeaving(
    const WordBricks& words, const CutGrowth& command, std::vector<std::uint8_t>& marks)
{
    LeavingVoxels leaving; // the sketches at first
    for (const glm::ivec3& place : command.voxels) {
        const Voxel voxel = words.find(place);
        if (voxel == WordBricks::none)
            continue;
        const std::uint32_t word = words[voxel];
        if (seedWord::isMember(word) && seedWord::generation(word) != 0
            && !command.frozen[seedWord::label(word)])
            leaving[seedWord::label(word)].push_back(voxel);
    }
    if (leaving.empty())
        return leaving;
    const Survey found = survey(words);
    for (auto& [label, sketch] : leaving) {
        std::sort(sketch.begin(), sketch.end());
        sketch.erase(std::unique(sketch.begin(), sketch.end()), sketch.end());
        sketch = LabelCut(words, command, label, found, marks).run(sketch);
    }
    return leaving;
}

} // namespace

LeavingVoxels leavingVoxels(const WordBricks& words, const CutGrowth& command)
{
    std::vector<std::uint8_t> marks(words.count(), 0);
    return markLeaving(words, command, marks);
}

GrowthCutOutcome cutGrowth(const WordBricks& words, const CutGrowth& command)
{
    GrowthCutOutcome outcome{.bricks = {}, .generation = command.generation};
    std::vector<std::uint8_t> marks(words.count(), 0);
    const LeavingVoxels leaving = markLeaving(words, command, marks);
    CutWriting writing(words);
    for (const auto& [label, voxels] : leaving)
        write(writing, words, marks, voxels, label, command.barrier);
    outcome.bricks = writing.take();
    if (outcome.bricks.empty())
        return outcome;
    outcome.generation = 0;
    for (std::size_t voxel = 0; voxel < words.count(); ++voxel) {
        const std::uint32_t word = words[Voxel(voxel)];
        if (seedWord::isMember(word) && (marks[voxel] & LabelCut::leaves) == 0)
            outcome.generation = std::max(outcome.generation, seedWord::generation(word));
    }
    return outcome;
}

} // namespace core
