// SPDX-License-Identifier: Apache-2.0
#include "core/engine/ChangeFacts.h"

#include "core/base/ParallelFor.h"
#include "core/growth/SeedWord.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <set>
#include <utility>

namespace core {

namespace {

constexpr std::size_t voxelsPerBrick = BrickGrid::voxelsPerBrick;
constexpr std::size_t wordBytes = 4;

/// A brick's bytes, whether it has any or not.
const std::uint8_t* bytesOf(const BrickBytes& image, Field field)
{
    static const std::array<std::vector<std::uint8_t>, 2> empty{
        std::vector<std::uint8_t>(voxelsPerBrick, 0),
        std::vector<std::uint8_t>(wordBytes * voxelsPerBrick, emptyByte(Field::SeedWords))};
    return image.empty() ? empty[field == Field::SeedWords ? 1 : 0].data() : image.read().data();
}

/// What one part of the bricks adds up to.
struct Sums {
    struct Flow {
        std::int64_t gained = 0;
        std::int64_t lost = 0;
    };
    std::map<std::uint8_t, std::array<Flow, 256>> flows; ///< by plane
    std::set<std::uint32_t> seedGenerations;
    ChangeFacts facts; ///< all else

    void addValues(const BrickChange& change)
    {
        const std::uint8_t* before = bytesOf(change.before, change.key.field);
        const std::uint8_t* after = bytesOf(change.after, change.key.field);
        ++facts.bricks;
        for (std::size_t i = 0; i < voxelsPerBrick; ++i)
            facts.voxelsChanged += before[i] != after[i] ? 1 : 0;
    }

    /// @param overwritten the change of what these labels have overwritten; null: it has not
    ///     changed
    void addLabels(const BrickChange& change, const BrickChange* overwritten)
    {
        const std::uint8_t* before = bytesOf(change.before, Field::Labels);
        const std::uint8_t* after = bytesOf(change.after, Field::Labels);
        const std::uint8_t* lay =
            overwritten ? bytesOf(overwritten->before, Field::Overwritten) : nullptr;
        const std::uint8_t* lies =
            overwritten ? bytesOf(overwritten->after, Field::Overwritten) : nullptr;
        std::array<Flow, 256>& flow = flows[change.key.plane];
        for (std::size_t i = 0; i < voxelsPerBrick; ++i) {
            if (before[i] == after[i])
                continue;
            ++flow[after[i]].gained;
            ++flow[before[i]].lost;
            const bool isGivenBack = lay && after[i] == lay[i] && lies[i] == 0;
            ++(after[i] == 0 || isGivenBack ? facts.labelsLost : facts.labelsGrown);
        }
    }

    void addWords(const BrickChange& change)
    {
        std::uint32_t& greatest = facts.greatestGenerations[change.key.plane];
        const std::uint8_t* before = bytesOf(change.before, Field::SeedWords);
        const std::uint8_t* after = bytesOf(change.after, Field::SeedWords);
        for (std::size_t i = 0; i < voxelsPerBrick; ++i) {
            const std::uint32_t word = seedWord::wordAt(after + wordBytes * i);
            facts.seedWordsChanged += word != seedWord::wordAt(before + wordBytes * i) ? 1 : 0;
            if (!seedWord::isMember(word))
                continue;
            const std::uint32_t generation = seedWord::generation(word);
            greatest = std::max(greatest, generation);
            if (seedWord::isSeed(word))
                seedGenerations.insert(generation);
        }
    }

    void add(Sums&& other)
    {
        facts.bricks += other.facts.bricks;
        facts.voxelsChanged += other.facts.voxelsChanged;
        facts.seedWordsChanged += other.facts.seedWordsChanged;
        facts.labelsLost += other.facts.labelsLost;
        facts.labelsGrown += other.facts.labelsGrown;
        for (const auto& [plane, generation] : other.facts.greatestGenerations) {
            std::uint32_t& greatest = facts.greatestGenerations[plane];
            greatest = std::max(greatest, generation);
        }
        seedGenerations.merge(other.seedGenerations);
        for (const auto& [plane, flow] : other.flows) {
            std::array<Flow, 256>& sum = flows[plane];
            for (std::size_t label = 0; label < flow.size(); ++label) {
                sum[label].gained += flow[label].gained;
                sum[label].lost += flow[label].lost;
            }
        }
    }
};

using Overwritten = std::map<std::pair<std::uint8_t, std::uint32_t>, const BrickChange*>;

void add(Sums& sums, const BrickChange& change, const Overwritten& overwritten)
{
    switch (change.key.field) {
    case Field::Coverage:
        sums.addValues(change);
        break;
    case Field::Labels: {
        const auto below = overwritten.find({change.key.plane, change.key.brick});
        sums.addValues(change);
        sums.addLabels(change, below == overwritten.end() ? nullptr : below->second);
        break;
    }
    case Field::SeedWords:
        sums.addWords(change);
        break;
    case Field::Overwritten: // nothing that is seen
        break;
    }
}

Sums summed(const std::vector<BrickChange>& changes, const Overwritten& overwritten)
{
    constexpr std::size_t portion = 256; // bricks; fewer are not worth a thread
    const std::size_t parts = (changes.size() + portion - 1) / portion;
    std::vector<Sums> sums(std::max<std::size_t>(parts, 1));
    const auto sumPart = [&](std::size_t part) {
        const std::size_t end = std::min((part + 1) * portion, changes.size());
        for (std::size_t i = part * portion; i < end; ++i)
            add(sums[part], changes[i], overwritten);
    };
    if (parts > 1)
        parallelFor(int(parts), [&](int part) { sumPart(std::size_t(part)); });
    else if (parts == 1)
        sumPart(0);
    for (std::size_t part = 1; part < parts; ++part)
        sums.front().add(std::move(sums[part]));
    return std::move(sums.front());
}

} // namespace

LabelFlow ChangeFacts::flow(std::uint8_t plane, int label) const
{
    for (const LabelFlow& known : flows) {
        if (known.plane == plane && known.label == label)
            return known;
    }
    return {.plane = plane, .label = std::uint8_t(label)};
}

std::uint32_t ChangeFacts::greatestGeneration(std::uint8_t plane) const
{
    const auto known = greatestGenerations.find(plane);
    return known == greatestGenerations.end() ? 0 : known->second;
}

bool ChangeFacts::admittedSeedsAt(std::uint32_t generation) const
{
    return std::binary_search(seedGenerations.begin(), seedGenerations.end(), generation);
}

ChangeFacts factsOf(const std::vector<BrickChange>& changes, const BrickGrid& grid)
{
    Overwritten overwritten;
    for (const BrickChange& change : changes) {
        if (change.key.field == Field::Overwritten)
            overwritten[{change.key.plane, change.key.brick}] = &change;
    }
    Sums sums = summed(changes, overwritten);
    ChangeFacts facts = std::move(sums.facts);
    facts.bricksOfAllFields = int(changes.size());
    facts.seedGenerations.assign(sums.seedGenerations.begin(), sums.seedGenerations.end());
    for (const auto& [plane, flow] : sums.flows) {
        for (std::size_t label = 1; label < flow.size(); ++label) {
            if (flow[label].gained != 0 || flow[label].lost != 0)
                facts.flows.push_back({.plane = plane,
                    .label = std::uint8_t(label),
                    .gained = flow[label].gained,
                    .lost = flow[label].lost});
        }
    }
    for (const BrickChange& change : changes) {
        const VoxelBox box = grid.boxOf(int(change.key.brick));
        if (change.key.field == Field::Coverage)
            facts.coverage = facts.coverage.united(box);
        else if (change.key.field == Field::Labels)
            facts.labels = facts.labels.united(box);
        else if (change.key.field == Field::SeedWords)
            facts.seedWords = facts.seedWords.united(box);
    }
    return facts;
}

} // namespace core
