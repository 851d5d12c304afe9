// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/growth/CutPromises.h"

#include "core/growth/SeedWord.h"
#include "tests/support/cases/EngineConformance.h"

#include <algorithm>
#include <array>
#include <climits>
#include <set>

namespace test {

namespace seedWord = core::seedWord;

namespace {

constexpr int unreached = INT_MAX;

bool isRoot(std::uint32_t word)
{
    return seedWord::isSeed(word) || seedWord::generation(word) == 0;
}

template <class Visit>
void forNeighbours(const Words& words, const glm::ivec3& place, int directions, const Visit& visit)
{
    for (int direction = 0; direction < directions; ++direction) {
        const auto& offset = seedWord::offsets[std::size_t(direction)];
        const glm::ivec3 next = place + glm::ivec3(offset[0], offset[1], offset[2]);
        if (words.contains(next))
            visit(next, direction);
    }
}

template <class Visit> void forVoxels(const Words& words, const Visit& visit)
{
    for (int z = 0; z < words.size.z; ++z) {
        for (int y = 0; y < words.size.y; ++y) {
            for (int x = 0; x < words.size.x; ++x)
                visit(glm::ivec3(x, y, z));
        }
    }
}

/// The members of one label.
class Tribe {
public:
    Tribe(const Words& before, std::uint32_t label)
        : m_words(before)
        , m_label(label)
    {
        forVoxels(before, [&](const glm::ivec3& place) {
            if (has(place) && !isRoot(before.at(place)))
                m_steps = std::max(m_steps, stepsOf(place));
        });
    }

    [[nodiscard]] int steps() const { return m_steps; }
    [[nodiscard]] bool has(const glm::ivec3& place) const { return isMember(m_words, place); }
    [[nodiscard]] bool isMember(const Words& words, const glm::ivec3& place) const
    {
        return seedWord::isMember(words.at(place)) && seedWord::label(words.at(place)) == m_label;
    }
    /// Over members of @p words, from those of them that @p from says.
    template <class From>
    [[nodiscard]] std::vector<int> distances(const Words& words, const From& from) const
    {
        std::vector<int> distances(words.values.size(), unreached);
        std::vector<glm::ivec3> queue;
        forVoxels(words, [&](const glm::ivec3& place) {
            if (!isMember(words, place) || !from(place))
                return;
            distances[words.offset(place)] = 0;
            queue.push_back(place);
        });
        for (std::size_t i = 0; i < queue.size(); ++i) {
            const int distance = distances[words.offset(queue[i])] + 1;
            forNeighbours(words, glm::ivec3(queue[i]), m_steps, [&](const glm::ivec3& next, int) {
                if (!isMember(words, next) || distances[words.offset(next)] != unreached)
                    return;
                distances[words.offset(next)] = distance;
                queue.push_back(next);
            });
        }
        return distances;
    }
    [[nodiscard]] bool hasParent(const Words& words, const glm::ivec3& place) const
    {
        bool found = false;
        forNeighbours(
            words, place, parentDirections(words.at(place)), [&](const glm::ivec3& next, int) {
                found = found
                    || (isMember(words, next)
                        && seedWord::generation(words.at(next))
                            < seedWord::generation(words.at(place)));
            });
        return found;
    }

private:
    static int parentDirections(std::uint32_t word)
    {
        const std::uint32_t direction = seedWord::direction(word);
        return direction < 6 ? 6 : direction < 18 ? 18 : 26;
    }
    [[nodiscard]] int stepsOf(const glm::ivec3& place) const
    {
        const std::uint32_t word = m_words.at(place);
        if (!seedWord::wasHeld(word))
            return parentDirections(word);
        int lowest = 26;
        forNeighbours(m_words, place, 26, [&](const glm::ivec3& next, int direction) {
            if (has(next) && seedWord::generation(m_words.at(next)) < seedWord::generation(word))
                lowest = std::min(lowest, direction);
        });
        return lowest < 6 || lowest == 26 ? 6 : lowest < 18 ? 18 : 26;
    }

    const Words& m_words;
    std::uint32_t m_label;
    int m_steps = 6;
};

QString at(const char* what, const glm::ivec3& place)
{
    return QStringLiteral("%1 at %2 %3 %4")
        .arg(QLatin1String(what))
        .arg(place.x)
        .arg(place.y)
        .arg(place.z);
}

QString brokenOfLabel(const Words& before, const Words& after, const core::CutGrowth& command,
    std::uint32_t label, const std::set<std::size_t>& sketch)
{
    using How = core::CutGrowth::How;
    const Tribe tribe(before, label);
    const auto sketched = [&](const glm::ivec3& place) {
        return sketch.count(before.offset(place)) != 0;
    };
    const auto rootBefore = [&](const glm::ivec3& place) { return isRoot(before.at(place)); };
    const std::vector<int> toSketch = tribe.distances(before, sketched);
    const std::vector<int> toRoots = tribe.distances(before, rootBefore);
    const std::vector<int> stillToRoots = tribe.distances(after, rootBefore);
    bool anyLeft = false;
    forVoxels(before, [&](const glm::ivec3& place) {
        anyLeft = anyLeft || (tribe.has(place) && !tribe.isMember(after, place));
    });
    const bool noNeck = !anyLeft && command.how == How::Neck;
    QString broken;
    forVoxels(before, [&](const glm::ivec3& place) {
        if (!broken.isEmpty() || !tribe.has(place))
            return;
        const std::size_t voxel = before.offset(place);
        const bool left = !tribe.isMember(after, place);
        if (noNeck)
            broken = before.at(place) == after.at(place)
                ? QString()
                : at("no neck, and yet something changes", place);
        else if (sketched(place) && !left)
            broken = at("a sketched member stays", place);
        else if (left && isRoot(before.at(place)))
            broken = at("a root leaves", place);
        else if (left && command.how == How::Here && !sketched(place))
            broken = at("what was not sketched leaves", place);
        else if (left && command.how != How::Neck && toRoots[voxel] < toSketch[voxel])
            broken = at("what is nearer to the roots leaves", place);
        else if (!left && isRoot(before.at(place)) && after.at(place) != before.at(place))
            broken = at("a root becomes another", place);
        else if (!left && seedWord::wasHeld(before.at(place)) != seedWord::wasHeld(after.at(place)))
            broken = at("it is forgotten, or made up, that a label was there before", place);
        else if (!left && !isRoot(before.at(place)) && stillToRoots[voxel] != unreached
            && !tribe.hasParent(after, place)
            && (toRoots[voxel] == unreached || tribe.hasParent(before, place)))
            broken = at("a member has lost its parents", place);
        else if (!left && command.how != How::Here && !isRoot(before.at(place))
            && tribe.hasParent(before, place) && !tribe.hasParent(after, place))
            broken = at("a member hangs in the air", place);
    });
    return broken;
}

} // namespace

QString brokenPromise(const Words& before, const Words& after, const core::CutGrowth& command)
{
    std::array<std::set<std::size_t>, 256> sketches;
    for (const glm::ivec3& place : command.voxels) {
        const std::uint32_t word = before.at(place);
        if (seedWord::isMember(word) && !command.lockedLabels[seedWord::label(word)])
            sketches[seedWord::label(word)].insert(before.offset(place));
    }
    for (std::uint32_t label = 1; label < 256; ++label) {
        if (sketches[label].empty())
            continue;
        if (const QString broken = brokenOfLabel(before, after, command, label, sketches[label]);
            !broken.isEmpty())
            return QStringLiteral("label %1: %2").arg(label).arg(broken);
    }
    for (std::size_t voxel = 0; voxel < before.values.size(); ++voxel) {
        const std::uint32_t word = before.values[voxel];
        if (seedWord::isMember(word) && sketches[seedWord::label(word)].empty()
            && after.values[voxel] != word)
            return QStringLiteral("a label that was not sketched changes");
    }
    return {};
}

Words seedWordsOf(core::EditEngine& engine, const glm::ivec3& size)
{
    Words words{size,
        std::vector<std::uint32_t>(
            std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), seedWord::unvisited)};
    core::ReadBricks read;
    for (int brick = 0; brick < core::BrickGrid{size}.brickCount(); ++brick)
        read.keys.push_back({core::Field::SeedWords, 0, std::uint32_t(brick)});
    engine.submit(read);
    for (const core::BrickChange& brick : lastResult(engine).changes) {
        if (brick.after.empty())
            continue;
        std::vector<std::uint32_t> held(core::BrickGrid::voxelsPerBrick, 0);
        for (std::size_t i = 0; i < brick.after.size(); ++i)
            held[i / 4] |= std::uint32_t(brick.after.read()[i]) << (8 * (i % 4));
        putBrick(words, brick.key.brick, held);
    }
    return words;
}

void putBrick(Words& words, std::uint32_t brick, const std::vector<std::uint32_t>& held)
{
    const core::VoxelBox box = core::BrickGrid{words.size}.boxOf(int(brick));
    for (int z = box.minimum.z; z < box.maximum.z; ++z) {
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            for (int x = box.minimum.x; x < box.maximum.x; ++x)
                words.at({x, y, z}) = held[std::size_t(core::BrickGrid::offsetInBrick({x, y, z}))];
        }
    }
}

Sketched sketchedMembers(const Words& words, const core::CutGrowth& command)
{
    std::set<std::size_t> members;
    std::set<std::size_t> roots;
    for (const glm::ivec3& place : command.voxels) {
        const std::uint32_t word = words.at(place);
        if (!seedWord::isMember(word) || command.lockedLabels[seedWord::label(word)])
            continue;
        members.insert(words.offset(place));
        if (isRoot(word))
            roots.insert(words.offset(place));
    }
    return {.members = int(members.size()), .roots = int(roots.size())};
}

std::vector<glm::ivec3> strokeOverMembers(const Words& words, int length, Random& random)
{
    std::vector<glm::ivec3> members;
    forVoxels(words, [&](const glm::ivec3& place) {
        if (seedWord::isMember(words.at(place)))
            members.push_back(place);
    });
    if (members.empty())
        return {};
    std::vector<glm::ivec3> stroke{members[random() % members.size()]};
    // It keeps its direction where it can.
    int direction = randomInt(random, 0, 25);
    for (int tries = 0; int(stroke.size()) < length && tries < 20 * length; ++tries) {
        const auto& offset = seedWord::offsets[std::size_t(direction)];
        const glm::ivec3 next = stroke.back() + glm::ivec3(offset[0], offset[1], offset[2]);
        if (words.contains(next) && seedWord::isMember(words.at(next)))
            stroke.push_back(next);
        if (stroke.back() != next || random() % 8 == 0)
            direction = randomInt(random, 0, 25);
    }
    return stroke;
}

} // namespace test
