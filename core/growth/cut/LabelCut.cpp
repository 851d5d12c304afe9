// SPDX-License-Identifier: Apache-2.0
#include "core/growth/cut/LabelCut.h"

#include "core/growth/cut/FrontSurroundings.h"
#include "core/growth/cut/NarrowestCut.h"
#include "core/growth/cut/NearerMembers.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace core {

/// Voxels by generation, each put in while a generation is worked at that lies on its near side.
class LabelCut::Generations {
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

LabelCut::LabelCut(const WordBricks& words, const CutGrowth& command, std::uint32_t label,
    std::vector<std::uint8_t>& marks)
    : m_words(words)
    , m_command(command)
    , m_members(words, label)
    , m_marks(marks)
{
}

LabelCut::Voxels LabelCut::run(const Voxels& sketch, WordChanges& changes)
{
    const bool here = m_command.how == CutGrowth::How::Here;
    std::optional<Voxels> cut;
    if (!here)
        cut = narrowestOf(sketch);
    if (!cut && m_command.how == CutGrowth::How::Neck)
        return {};
    Voxels from = cut.value_or(Voxels());
    if (m_command.how != CutGrowth::How::Neck)
        from.insert(from.end(), sketch.begin(), sketch.end());
    const Voxels all = behind(from, m_members.greatestGeneration());
    return leave(here                               ? sketch
            : m_command.how == CutGrowth::How::Neck ? all
                                                    : near(all, sketch),
        all, changes);
}

/// The cut of rule 8; none where there is no neck that all of the sketch lies behind.
std::optional<LabelCut::Voxels> LabelCut::narrowestOf(const Voxels& sketch)
{
    Generations way = wayTo(sketch);
    std::uint32_t latest = 0; // of the sketch
    for (const Voxel voxel : sketch)
        latest = std::max(latest, seedWord::generation(m_words[voxel]));
    std::optional<Voxels> narrowest;
    for (const Neck& neck : findNecks(way, sketch)) {
        Voxels cut = cutAt(neck, way[neck.generation]);
        if (narrowest && cut.size() >= narrowest->size())
            continue;
        (void)behind(cut, latest);
        const bool whole = std::all_of(
            sketch.begin(), sketch.end(), [this](Voxel voxel) { return has(voxel, liesBehind); });
        forgetBehind();
        if (whole)
            narrowest = std::move(cut);
    }
    return narrowest;
}

/// What is no nearer to the roots than to the sketch.
LabelCut::Voxels LabelCut::near(const Voxels& all, const Voxels& sketch) const
{
    const NearerMembers nearer(m_members, sketch);
    Voxels near;
    std::copy_if(all.begin(), all.end(), std::back_inserter(near),
        [&nearer](Voxel voxel) { return !nearer.nearerToRoots(voxel); });
    return near;
}

/// Adds to voxels of one generation all that their fronts hold.
void LabelCut::completeFronts(Voxels& front, std::uint8_t mark)
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

/// Rule 4.
LabelCut::Generations LabelCut::wayTo(const Voxels& sketch)
{
    Generations way(m_members.greatestGeneration());
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
            m_members.forParents(voxel, add);
    }
    return way;
}

/// Rules 5 and 6. What lies beyond is followed as far as it can tell something.
std::vector<LabelCut::Neck> LabelCut::findNecks(Generations& way, const Voxels& sketch)
{
    std::size_t widest = 0;
    std::uint32_t last = 0;
    for (std::uint32_t n = 0; n < way.count(); ++n) {
        widest = std::max(widest, way.width(n));
        last = way.width(n) > 0 ? n : last;
    }
    Generations later(m_members.greatestGeneration());
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
            m_members.forChildren(voxel, add);
        width[n] = std::max(way.width(n), later.width(n));
        if (n > last && width[n] >= widest)
            break;
    }
    return necksOf(way, width);
}

std::vector<LabelCut::Neck> LabelCut::necksOf(
    const Generations& way, const std::vector<std::size_t>& width)
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
bool LabelCut::isNarrowest(const Generations& way, std::uint32_t n)
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

/// Rule 8.
LabelCut::Voxels LabelCut::cutAt(const Neck& neck, const Voxels& front)
{
    if (front.size() > widestPassage)
        return front;
    const FrontSurroundings around(
        m_words, front, [this](std::uint32_t word) { return m_members.isMember(word); });
    std::uint32_t latest = 0;
    for (const Voxel voxel : around.voxels())
        latest = std::max(latest, seedWord::generation(m_words[voxel]));
    (void)behind(front, latest);
    PassageGraph graph;
    graph.source.resize(around.voxels().size());
    graph.sink.resize(around.voxels().size());
    bool sources = false;
    bool sinks = false;
    for (std::size_t node = 0; node < around.voxels().size(); ++node) {
        const Voxel voxel = around.voxels()[node];
        const std::uint32_t word = m_words[voxel];
        const bool far = around.isFarthest(node);
        const bool within = has(voxel, liesBehind);
        graph.source[node] = !within && (far || LabelMembers::isRoot(word));
        graph.sink[node] = within && (far || seedWord::generation(word) >= neck.wideFrom);
        sources = sources || graph.source[node];
        sinks = sinks || graph.sink[node];
        m_words.forNeighbours(voxel, 0, seedWord::directions,
            [&](Voxel neighbour, std::uint32_t other, std::uint32_t) {
                if (!m_members.isMember(other))
                    return;
                const std::uint32_t next = around.nodeAt(m_words.positionOf(neighbour));
                if (next != FrontSurroundings::none)
                    graph.next.push_back(next);
            });
        graph.first.push_back(std::uint32_t(graph.next.size()));
    }
    forgetBehind();
    if (!sources || !sinks)
        return front;
    Voxels cut;
    for (const std::uint32_t node : narrowestCut(graph)) {
        cut.push_back(around.voxels()[node]);
        if (LabelMembers::isRoot(m_words[cut.back()]))
            return front;
    }
    return cut;
}

} // namespace core
