// SPDX-License-Identifier: Apache-2.0
#include "gpu/edit/DrillKernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gpu {

namespace {

constexpr int tileSide = 16;
constexpr std::size_t elementsPerTile = tileSide * tileSide;
constexpr std::int32_t nowhere = std::numeric_limits<std::int32_t>::max();
constexpr std::size_t brickBytes = core::BrickGrid::voxelsPerBrick;

std::int64_t round14(std::int64_t value)
{
    return (value + (1 << 13)) >> 14;
}

glm::ivec3 round14(const core::Fixed3& v)
{
    return {int(round14(v[0])), int(round14(v[1])), int(round14(v[2]))};
}

int floorDivide(int value, int divisor)
{
    return value >= 0 ? value / divisor : -((-value + divisor - 1) / divisor);
}

Program program(const ShaderLibrary& library, const char* path)
{
    return Program(library, ComputeProgramOptions{.label = path, .path = path, .defines = {}});
}

template <class T> Buffer bufferOf(const char* label, const std::vector<T>& values)
{
    Buffer buffer({.label = label, .bytes = std::max<std::size_t>(values.size() * sizeof(T), 16)});
    buffer.write(std::span<const T>(values));
    return buffer;
}

} // namespace

DrillPrograms::DrillPrograms(const ShaderLibrary& library)
    : cast(program(library, "edit/drillCast.comp"))
    , cut(program(library, "edit/drillCut.comp"))
{
}

DrillKernel::DrillKernel(
    DrillPrograms& programs, VoxelFields& fields, BeforeImages& before, const core::DrillCut& cut)
    : m_programs(programs)
    , m_fields(fields)
    , m_before(before)
    , m_cut(cut)
    , m_perI(round14(cut.frame.planePerI))
    , m_perJ(round14(cut.frame.planePerJ))
    , m_perK(round14(cut.frame.planePerK))
    , m_snapshotOf(std::size_t(fields.grid().brickCount()), 0)
{
    const core::DrillFrame& frame = cut.frame;
    const core::BrickGrid& grid = fields.grid();

    // Elements outside the volume's shadow on the mask plane meet no voxel: the tile directory
    // covers the shadow only. A brick of margin covers the rounding.
    glm::ivec2 low(std::numeric_limits<int>::max());
    glm::ivec2 high(std::numeric_limits<int>::lowest());
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 voxel = glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1)
            * grid.bricks() * core::BrickGrid::side;
        glm::ivec2 plane;
        for (int axis = 0; axis < 2; ++axis) {
            plane[axis] = int(round14(frame.planeOrigin[std::size_t(axis)]
                + voxel.x * frame.planePerI[std::size_t(axis)]
                + voxel.y * frame.planePerJ[std::size_t(axis)]
                + voxel.z * frame.planePerK[std::size_t(axis)]));
        }
        low = glm::min(low, plane);
        high = glm::max(high, plane);
    }
    const int tileMm16 = frame.pitch * tileSide;
    m_firstTile = {floorDivide(low.x, tileMm16) - 1, floorDivide(low.y, tileMm16) - 1};
    m_tileCount =
        glm::ivec2(floorDivide(high.x, tileMm16), floorDivide(high.y, tileMm16)) + 2 - m_firstTile;
    m_tileSlots = Buffer({.label = "drill tile slots",
        .bytes = std::size_t(m_tileCount.x) * std::size_t(m_tileCount.y) * sizeof(std::uint32_t)});
    m_tileSlots.fill(0);
    m_snapshotSlots = bufferOf("drill snapshot slots", m_snapshotOf);
    m_snapshots = Buffer({.label = "drill snapshots", .bytes = brickBytes});

    m_programs.cast.set("volumeSize", grid.volumeSize)
        .set("volumeBricks", grid.bricks())
        .set("stepPerSample", round14(frame.rayPerSample))
        .set("sampleCount", frame.sampleCount)
        .set("zStart", frame.zStart)
        .set("zPerSample", frame.zPerSample)
        .set("thresholdCode", frame.thresholdCode)
        .set("maxDepth", frame.maxDepth)
        .set("gapSamples", frame.gapSamples)
        .set("throughGaps", frame.throughGaps);
    m_programs.cut.set("volumeSize", grid.volumeSize)
        .set("volumeBricks", grid.bricks())
        .set("planePerI", m_perI)
        .set("planePerJ", m_perJ)
        .set("planePerK", m_perK)
        .set("pitch", frame.pitch)
        .set("rampHalfWidth", frame.rampHalfWidth)
        .set("firstTile", m_firstTile)
        .set("tileCount", m_tileCount);
}

DrillKernel::Tile& DrillKernel::tileOf(const glm::ivec2& at)
{
    const std::pair<int, int> key(floorDivide(at.x, tileSide), floorDivide(at.y, tileSide));
    Tile& tile = m_tiles[key];
    if (tile.elements.empty()) {
        tile.elements.resize(elementsPerTile);
        tile.slot = std::uint32_t(m_tiles.size()) - 1;
    }
    m_staleTiles.insert(key);
    return tile;
}

DrillKernel::Element& DrillKernel::element(const glm::ivec2& at)
{
    return tileOf(at).elements[std::size_t((at.x & 15) + tileSide * (at.y & 15))];
}

std::vector<glm::ivec2> DrillKernel::deepen(const std::vector<core::DrillSample>& samples)
{
    const glm::ivec2 first = m_firstTile * tileSide;
    const glm::ivec2 last = (m_firstTile + m_tileCount) * tileSide - 1;
    std::vector<glm::ivec2> deeper;
    for (const core::DrillSample& sample : samples) {
        const core::ElementBox box = core::elementsUnder(m_cut.frame, sample);
        const glm::ivec2 low = glm::max(box.minimum, first);
        const glm::ivec2 high = glm::min(box.maximum, last);
        for (int b = low.y; b <= high.y; ++b) {
            for (int a = low.x; a <= high.x; ++a) {
                const std::int32_t depth = core::elementDepth(m_cut.frame, sample, {a, b});
                if (depth == 0)
                    continue;
                Element& at = element({a, b});
                if (depth <= at.depth)
                    continue;
                if (at.depth == 0)
                    m_uncast.emplace_back(a, b);
                at.depth = depth;
                deeper.emplace_back(a, b);
            }
        }
    }
    return deeper;
}

void DrillKernel::castNew()
{
    const core::DrillFrame& frame = m_cut.frame;
    std::vector<glm::ivec2> elements;
    std::vector<glm::ivec4> rays;
    for (const glm::ivec2& at : m_uncast) {
        glm::ivec4 origin(0);
        bool near = true;
        for (int axis = 0; axis < 3; ++axis) {
            const auto i = std::size_t(axis);
            const std::int64_t position =
                round14(frame.rayOrigin[i] + at.x * frame.rayPerA[i] + at.y * frame.rayPerB[i]);
            near = near && std::abs(position) <= std::int64_t(1) << 30;
            origin[axis] = int(std::clamp<std::int64_t>(position, -(1 << 30), 1 << 30));
        }
        if (near) {
            elements.push_back(at);
            rays.push_back(origin);
        } else {
            element(at).surface = nowhere;
        }
    }
    m_uncast.clear();
    if (rays.empty())
        return;

    const Buffer rayBuffer = bufferOf("drill rays", rays);
    Buffer hitBuffer({.label = "drill hits", .bytes = rays.size() * sizeof(glm::ivec2)});
    m_fields.codes().bindUnit(0);
    m_fields.radiation().bindUnit(1);
    rayBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    hitBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    m_snapshotSlots.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
    m_snapshots.bindBase(GL_SHADER_STORAGE_BUFFER, 3);
    m_programs.cast.set("rayCount", unsigned(rays.size()));
    m_programs.cast.dispatch({unsigned(rays.size() + 63) / 64, 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    std::vector<glm::ivec2> hits(rays.size());
    hitBuffer.read(std::span<glm::ivec2>(hits));
    for (std::size_t i = 0; i < hits.size(); ++i) {
        Element& at = element(elements[i]);
        at.surface = hits[i].x;
        at.exit = hits[i].y;
    }
}

void DrillKernel::mirrorTiles()
{
    const auto needed = std::uint32_t(m_tiles.size());
    if (needed > m_elementSlots) {
        const std::uint32_t slots = std::max(needed * 2, 64u);
        Buffer larger(
            {.label = "drill elements", .bytes = slots * elementsPerTile * sizeof(Element)});
        if (m_elements)
            m_elements.copyTo(larger, m_elements.bytes());
        m_elements = std::move(larger);
        m_elementSlots = slots;
    }
    for (const auto& key : m_staleTiles) {
        const Tile& tile = m_tiles.at(key);
        m_elements.write(
            std::span<const Element>(tile.elements), tile.slot * elementsPerTile * sizeof(Element));
        const std::uint32_t entry = tile.slot + 1;
        const auto position =
            std::size_t(key.first - m_firstTile.x + m_tileCount.x * (key.second - m_firstTile.y));
        m_tileSlots.write(std::span<const std::uint32_t>(&entry, 1), position * sizeof(entry));
    }
    m_staleTiles.clear();
}

std::vector<DrillKernel::PlaneBox> DrillKernel::boxesOf(const std::vector<glm::ivec2>& elements)
{
    const core::DrillFrame& frame = m_cut.frame;
    std::map<std::pair<int, int>, PlaneBox> boxes; // one a tile
    for (const glm::ivec2& at : elements) {
        const Element& e = element(at);
        if (e.surface == nowhere)
            continue;
        const int end = std::min(e.surface + e.depth, e.exit);
        const PlaneBox box{
            {at.x * frame.pitch, at.y * frame.pitch, e.surface - 3 * frame.rampHalfWidth},
            {(at.x + 1) * frame.pitch, (at.y + 1) * frame.pitch, end + frame.rampHalfWidth}};
        const std::pair<int, int> key(floorDivide(at.x, tileSide), floorDivide(at.y, tileSide));
        const auto [entry, isNew] = boxes.try_emplace(key, box);
        if (!isNew) {
            entry->second.minimum = glm::min(entry->second.minimum, box.minimum);
            entry->second.maximum = glm::max(entry->second.maximum, box.maximum);
        }
    }
    std::vector<PlaneBox> result;
    for (const auto& box : boxes)
        result.push_back(box.second);
    return result;
}

glm::ivec3 DrillKernel::planeBase(std::uint32_t brick) const
{
    const core::DrillFrame& frame = m_cut.frame;
    const glm::ivec3 voxel = m_fields.grid().boxOf(int(brick)).minimum;
    glm::ivec3 base;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = std::size_t(axis);
        base[axis] = int(round14(frame.planeOrigin[i] + voxel.x * frame.planePerI[i]
            + voxel.y * frame.planePerJ[i] + voxel.z * frame.planePerK[i]));
    }
    return base;
}

std::vector<std::uint32_t> DrillKernel::candidateBricks(const std::vector<PlaneBox>& boxes) const
{
    const core::BrickGrid& grid = m_fields.grid();
    const glm::ivec3 bricks = grid.bricks();
    // Plane → index, in doubles with margin: this only picks bricks that kernels then decide on.
    const glm::dmat3 indexToPlane{glm::dvec3(m_perI), glm::dvec3(m_perJ), glm::dvec3(m_perK)};
    const glm::dmat3 planeToIndex = glm::inverse(indexToPlane);
    const glm::dvec3 origin(planeBase(0));
    const glm::dvec3 halfBrick(core::BrickGrid::side / 2.0);
    glm::dvec3 brickReach(0.0);
    for (int axis = 0; axis < 3; ++axis)
        brickReach += glm::abs(indexToPlane[axis]) * (halfBrick.x + 1.0);

    std::set<std::uint32_t> found;
    for (const PlaneBox& box : boxes) {
        glm::dvec3 low(std::numeric_limits<double>::max());
        glm::dvec3 high(std::numeric_limits<double>::lowest());
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 plane((corner & 1) ? box.maximum.x : box.minimum.x,
                (corner & 2) ? box.maximum.y : box.minimum.y,
                (corner & 4) ? box.maximum.z : box.minimum.z);
            const glm::dvec3 index = planeToIndex * (plane - origin);
            low = glm::min(low, index);
            high = glm::max(high, index);
        }
        const glm::ivec3 first =
            glm::clamp(glm::ivec3(glm::floor((low - 2.0) / 16.0)), glm::ivec3(0), bricks - 1);
        const glm::ivec3 last =
            glm::clamp(glm::ivec3(glm::floor((high + 2.0) / 16.0)), glm::ivec3(0), bricks - 1);
        for (int z = first.z; z <= last.z; ++z) {
            for (int y = first.y; y <= last.y; ++y) {
                for (int x = first.x; x <= last.x; ++x) {
                    const glm::dvec3 centre =
                        origin + indexToPlane * (glm::dvec3(x, y, z) * 16.0 + halfBrick);
                    const bool apart =
                        glm::any(glm::lessThan(centre + brickReach, glm::dvec3(box.minimum)))
                        || glm::any(glm::greaterThan(centre - brickReach, glm::dvec3(box.maximum)));
                    if (!apart)
                        found.insert(std::uint32_t(x + bricks.x * (y + bricks.y * z)));
                }
            }
        }
    }
    return {found.begin(), found.end()};
}

void DrillKernel::keepRadiation(const std::vector<std::uint32_t>& bricks)
{
    std::vector<std::uint32_t> fresh;
    for (const std::uint32_t brick : m_fields.withNeighbours(bricks)) {
        if (m_snapshotOf[brick] == 0)
            fresh.push_back(brick);
    }
    if (fresh.empty())
        return;
    const std::uint32_t needed = m_snapshotCount + std::uint32_t(fresh.size());
    if (needed > m_snapshotCapacity) {
        m_snapshotCapacity = std::max(needed * 2, 256u);
        Buffer larger({.label = "drill snapshots", .bytes = m_snapshotCapacity * brickBytes});
        m_snapshots.copyTo(larger, m_snapshotCount * brickBytes);
        m_snapshots = std::move(larger);
    }
    const FieldTextures radiation{.voxels = &m_fields.radiation()};
    const Buffer packed = m_fields.copier().packed(radiation, fresh);
    packed.copyTo(m_snapshots, fresh.size() * brickBytes, 0, m_snapshotCount * brickBytes);
    for (const std::uint32_t brick : fresh)
        m_snapshotOf[brick] = ++m_snapshotCount;
    m_snapshotSlots.write(std::span<const std::uint32_t>(m_snapshotOf));
}

std::vector<std::uint32_t> DrillKernel::cutBricks(const std::vector<std::uint32_t>& candidates)
{
    BrickField& coverage = m_fields.coverage(m_cut.layer);
    std::vector<std::uint32_t> fresh;
    for (const std::uint32_t brick : candidates) {
        if (!coverage.holds(brick))
            fresh.push_back(brick);
    }
    m_before.capture(core::Field::Coverage, m_cut.layer, candidates);
    coverage.ensure(candidates);

    std::vector<glm::ivec4> bases;
    for (const std::uint32_t brick : candidates)
        bases.emplace_back(planeBase(brick), int(brick));
    const Buffer baseBuffer = bufferOf("drill candidates", bases);
    Buffer changedBuffer(
        {.label = "drill changed", .bytes = candidates.size() * sizeof(std::uint32_t)});
    changedBuffer.fill(0);
    coverage.pageTable().bindUnit(1);
    coverage.atlas().bindImage(0, GL_READ_WRITE);
    baseBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    m_tileSlots.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    m_elements.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
    changedBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 3);
    m_programs.cut.dispatch({unsigned(candidates.size()), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);

    std::vector<std::uint32_t> flags(candidates.size());
    changedBuffer.read(std::span<std::uint32_t>(flags));
    std::vector<std::uint32_t> changed;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (flags[i] != 0)
            changed.push_back(candidates[i]);
    }
    std::vector<std::uint32_t> unused;
    std::set_difference(
        fresh.begin(), fresh.end(), changed.begin(), changed.end(), std::back_inserter(unused));
    coverage.release(unused);
    return changed;
}

void DrillKernel::extend(const std::vector<core::DrillSample>& samples)
{
    const std::vector<glm::ivec2> deeper = deepen(samples);
    castNew();
    if (deeper.empty())
        return;
    const std::vector<PlaneBox> boxes = boxesOf(deeper);
    mirrorTiles();
    const std::vector<std::uint32_t> candidates = candidateBricks(boxes);
    if (candidates.empty())
        return;
    const std::vector<std::uint32_t> changed = cutBricks(candidates);
    keepRadiation(changed);
    m_fields.noteChanged(core::Field::Coverage, changed);
    m_touched.insert(changed.begin(), changed.end());
}

std::vector<std::uint32_t> DrillKernel::touchedBricks() const
{
    return {m_touched.begin(), m_touched.end()};
}

} // namespace gpu
