// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/fronts/ProcessorFront.h"

#include "core/base/ParallelFor.h"
#include "core/growth/SeedWord.h"
#include "gpu/fields/bricks/BrickVoxels.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace gpu {

namespace {

constexpr std::size_t voxelsOfBrick = core::BrickGrid::voxelsPerBrick;
constexpr std::size_t ownPlace = 13; // in core::FrontsAround
/// Fewer bricks are worked on by one thread: to start others would take more time than they save.
constexpr std::size_t muchWork = 1000;
/// To claim so many voxels takes as long as to look at a brick.
constexpr std::size_t voxelsLikeABrick = 64;
constexpr std::uint32_t never = 0xFFFFFFFFu; // no generation

glm::ivec3 offsetOf(std::size_t place)
{
    return glm::ivec3(int(place % 3), int(place / 3 % 3), int(place / 9)) - 1;
}

/// Whether a front may come over from a neighbour brick at this offset.
bool isNeighbour(const glm::ivec3& offset, int connectivity)
{
    const int axes = std::abs(offset.x) + std::abs(offset.y) + std::abs(offset.z);
    return axes == 1 || (axes == 2 && connectivity > 6) || (axes == 3 && connectivity > 18);
}

/// The sides (core::sidesReached()) that voxels must reach to be beside the brick at this offset.
unsigned sidesTowards(const glm::ivec3& offset)
{
    unsigned sides = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (offset[axis] != 0)
            sides |= 1u << (2 * axis + (offset[axis] > 0 ? 1 : 0));
    }
    return sides;
}

/// Calls work(0) … work(count - 1), one for each brick, on several threads where that is worth it.
/// @param voxels that are claimed in all of them, about
template <typename Work> void forEach(std::size_t count, std::size_t voxels, const Work& work)
{
    if (count + voxels / voxelsLikeABrick < muchWork) {
        for (std::size_t i = 0; i < count; ++i)
            work(i);
        return;
    }
    constexpr std::size_t part = 32;
    core::parallelFor(int((count + part - 1) / part), [&](int number) {
        const std::size_t first = part * std::size_t(number);
        for (std::size_t i = first; i < std::min(first + part, count); ++i)
            work(i);
    });
}

template <typename T> std::span<std::byte> bytesOf(std::vector<T>& values)
{
    return std::as_writable_bytes(std::span<T>(values));
}

} // namespace

/// What the fields hold in a brick, and what is to be written into them.
struct ProcessorFront::Images {
    bool isFetched = false;
    // These two take no memory before they are fetched: many bricks are only looked at.
    std::vector<std::uint32_t> words;
    std::vector<std::uint8_t> labels;
    std::vector<std::uint8_t> overwritten; ///< empty: not kept here
    core::BrickClaims claims;
};

struct ProcessorFront::Brick {
    std::uint32_t number = 0;
    bool isOpenKnown = false;
    int open = 0; ///< number of open voxels
    core::VoxelBits openVoxels{};
    // The fronts of even and of odd generations. One of another generation than the one that is
    // looked for counts as none.
    core::VoxelBits fronts[2]{};
    std::uint32_t frontGeneration[2]{never, never};
    unsigned sides = 0; ///< that the newest front reaches
    std::uint32_t reachedBy = never; ///< the last generation that might change it
    std::array<std::int32_t, 27> neighbours{}; ///< bricks as in core::FrontsAround; -1: none
    std::unique_ptr<Images> images; ///< while it holds the front, or may be claimed in
};

ProcessorFront::ProcessorFront(VoxelFields& fields, const Options& options,
    std::span<const core::LeakGuard::Voxel> front, std::uint32_t generation)
    : m_fields(fields)
    , m_options(options)
    , m_bricks(std::size_t(fields.grid().brickCount()))
    , m_generation(generation)
    , m_size(front.size())
{
    for (std::size_t place = 0; place < core::FrontsAround().size(); ++place) {
        const glm::ivec3 offset = offsetOf(place);
        if (isNeighbour(offset, options.connectivity))
            m_ways.push_back({.place = place, .sides = sidesTowards(offset)});
    }
    for (const core::LeakGuard::Voxel voxel : front) {
        Brick& brick = known(voxel.brick);
        std::uint32_t& frontOf = brick.frontGeneration[generation & 1u];
        if (frontOf != generation)
            m_front.push_back(&brick);
        frontOf = generation;
        brick.fronts[generation & 1u][voxel.offset >> 4] |=
            std::uint16_t(1u << (voxel.offset & 15u));
    }
    for (Brick* const brick : m_front)
        brick->sides = core::sidesReached(brick->fronts[generation & 1u]);
}

ProcessorFront::~ProcessorFront() = default;

ProcessorFront::Brick& ProcessorFront::known(std::uint32_t number)
{
    std::unique_ptr<Brick>& brick = m_bricks[number];
    if (brick)
        return *brick;
    brick = std::make_unique<Brick>();
    brick->number = number;
    const core::BrickGrid& grid = m_fields.grid();
    const glm::ivec3 place = grid.brickPosition(int(number));
    const glm::ivec3 bricks = grid.bricks();
    for (std::size_t i = 0; i < brick->neighbours.size(); ++i) {
        const glm::ivec3 at = place + offsetOf(i);
        const bool isInside = glm::all(glm::greaterThanEqual(at, glm::ivec3(0)))
            && glm::all(glm::lessThan(at, bricks));
        brick->neighbours[i] = isInside ? at.x + bricks.x * (at.y + bricks.y * at.z) : -1;
    }
    return *brick;
}

std::vector<std::uint32_t> ProcessorFront::unknown(std::span<const std::uint32_t> bricks) const
{
    std::vector<std::uint32_t> unknown;
    for (const std::uint32_t brick : bricks) {
        if (!m_bricks[brick] || !m_bricks[brick]->isOpenKnown)
            unknown.push_back(brick);
    }
    return unknown;
}

void ProcessorFront::setOpen(
    std::span<const std::uint32_t> bricks, std::span<const core::VoxelBits> openVoxels)
{
    for (std::size_t i = 0; i < bricks.size(); ++i) {
        Brick& brick = known(bricks[i]);
        brick.isOpenKnown = true;
        brick.openVoxels = openVoxels[i];
        brick.open = 0;
        for (const std::uint16_t row : brick.openVoxels)
            brick.open += std::popcount(row);
    }
}

/// Lists the bricks that the next generation may change.
void ProcessorFront::findReached(std::uint32_t generation)
{
    m_reached.clear();
    const auto reach = [&](Brick& brick) {
        if (brick.reachedBy == generation || brick.open == 0)
            return;
        brick.reachedBy = generation;
        m_reached.push_back(&brick);
    };
    for (Brick* const brick : m_front) {
        reach(*brick);
        for (const Way& way : m_ways) {
            const std::int32_t beside = brick->neighbours[way.place];
            if ((brick->sides & way.sides) == way.sides && beside >= 0
                && m_bricks[std::size_t(beside)])
                reach(*m_bricks[std::size_t(beside)]);
        }
    }
}

int ProcessorFront::claimIn(Brick& brick, int ring) const
{
    const std::uint32_t generation = m_generation;
    const std::uint32_t before = generation - 1;
    core::FrontsAround fronts{};
    const auto look = [&](const Brick* from, std::size_t place) {
        if (from && from->frontGeneration[before & 1u] == before)
            fronts[place] = &from->fronts[before & 1u];
    };
    look(&brick, ownPlace);
    for (const Way& way : m_ways) {
        const std::int32_t beside = brick.neighbours[way.place];
        if (beside >= 0)
            look(m_bricks[std::size_t(beside)].get(), way.place);
    }
    const core::Claimed claimed = core::claimVoxels(m_options.connectivity, ring, fronts,
        brick.openVoxels, brick.fronts[generation & 1u], brick.images->claims);
    if (claimed.voxels > 0) {
        brick.open -= claimed.voxels;
        brick.frontGeneration[generation & 1u] = generation;
        brick.sides = claimed.sides;
    }
    return claimed.voxels;
}

void ProcessorFront::claim(int ring)
{
    m_claimed.assign(m_reached.size(), 0);
    // About as many as in the generation before.
    forEach(m_reached.size(), m_size,
        [&](std::size_t i) { m_claimed[i] = claimIn(*m_reached[i], ring); });
}

void ProcessorFront::takeImages(Brick& brick)
{
    if (brick.images)
        return;
    if (m_spare.empty()) {
        brick.images = std::make_unique<Images>();
    } else {
        brick.images = std::move(m_spare.back());
        m_spare.pop_back();
    }
    brick.images->isFetched = false;
    m_imaged.push_back(&brick);
}

void ProcessorFront::fetch(Brick& brick, std::span<const std::uint32_t> newPages)
{
    Images& images = *brick.images;
    if (images.isFetched)
        return;
    images.isFetched = true;
    images.words.resize(voxelsOfBrick);
    images.labels.resize(voxelsOfBrick);
    const std::uint8_t plane = m_options.plane;
    if (std::binary_search(newPages.begin(), newPages.end(), brick.number))
        std::fill(images.words.begin(), images.words.end(), core::seedWord::unvisited);
    else
        m_fields.seedWords(plane).read(brick.number, bytesOf(images.words));
    if (m_fields.hasData({.field = core::Field::Labels, .plane = plane, .brick = brick.number}))
        readDense(m_fields.labels(plane), m_fields.grid(), brick.number, images.labels);
    else
        std::fill(images.labels.begin(), images.labels.end(), std::uint8_t(0));
    images.overwritten.clear();
    if (!m_options.keepsOverwritten || !m_fields.overwritten(plane).holds(brick.number))
        return;
    images.overwritten.resize(voxelsOfBrick);
    m_fields.overwritten(plane).read(brick.number, bytesOf(images.overwritten));
}

std::vector<std::uint32_t> ProcessorFront::advance(std::uint32_t generation, int rings)
{
    std::vector<std::uint32_t> sizes;
    m_rule = {.label = m_options.label, .tellsHeld = m_options.tellsHeld, .generation = generation};
    for (int ring = 1; ring <= std::min(rings, mostRings); ++ring) {
        m_generation = generation + std::uint32_t(ring);
        findReached(m_generation);
        for (Brick* const brick : m_reached)
            takeImages(*brick);
        claim(ring);
        m_size = 0;
        m_front.clear();
        for (std::size_t i = 0; i < m_reached.size(); ++i) {
            if (m_claimed[i] > 0)
                m_front.push_back(m_reached[i]);
            m_size += std::size_t(m_claimed[i]);
        }
        if (m_size == 0)
            break;
        sizes.push_back(std::uint32_t(m_size));
    }
    return sizes;
}

std::vector<std::uint32_t> ProcessorFront::claimedBricks() const
{
    std::vector<std::uint32_t> bricks;
    for (const Brick* const brick : m_imaged) {
        if (!brick->images->claims.empty())
            bricks.push_back(brick->number);
    }
    std::sort(bricks.begin(), bricks.end());
    return bricks;
}

void ProcessorFront::write(
    std::span<const std::uint32_t> bricks, std::span<const std::uint32_t> newPages)
{
    std::size_t claimed = 0;
    for (const std::uint32_t number : bricks) {
        fetch(*m_bricks[number], newPages);
        claimed += m_bricks[number]->images->claims.size();
    }
    forEach(bricks.size(), claimed, [&](std::size_t i) {
        Images& images = *m_bricks[bricks[i]]->images;
        core::writeClaims(m_rule, images.claims,
            {.words = images.words.data(),
                .labels = images.labels.data(),
                .overwritten = images.overwritten.empty() ? nullptr : images.overwritten.data()});
        images.claims.clear();
    });
    BrickField& words = m_fields.seedWords(m_options.plane);
    const Texture3D& labels = m_fields.labels(m_options.plane);
    for (const std::uint32_t number : bricks) {
        Brick& brick = *m_bricks[number];
        Images& images = *brick.images;
        words.write(number, bytesOf(images.words));
        writeDense(labels, m_fields.grid(), number, images.labels);
        if (!images.overwritten.empty())
            m_fields.overwritten(m_options.plane).write(number, bytesOf(images.overwritten));
    }
    std::erase_if(m_imaged, [this](Brick* brick) {
        const bool holdsFront = brick->frontGeneration[m_generation & 1u] == m_generation;
        if (!holdsFront)
            m_spare.push_back(std::move(brick->images));
        return !holdsFront;
    });
    // A front that has become small needs few.
    m_spare.resize(std::min(m_spare.size(), m_imaged.size()));
}

std::vector<std::uint32_t> ProcessorFront::frontBricks() const
{
    std::vector<std::uint32_t> bricks;
    bricks.reserve(m_front.size());
    for (const Brick* const brick : m_front)
        bricks.push_back(brick->number);
    std::sort(bricks.begin(), bricks.end());
    return bricks;
}

std::vector<core::LeakGuard::Voxel> ProcessorFront::voxels() const
{
    std::vector<core::LeakGuard::Voxel> voxels;
    for (const std::uint32_t number : frontBricks())
        core::appendVoxels(m_bricks[number]->fronts[m_generation & 1u], number, voxels);
    return voxels;
}

} // namespace gpu
