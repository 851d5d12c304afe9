// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/VoxelFields.h"

#include <iterator>

namespace gpu {

VoxelFields::VoxelFields(FieldPrograms& programs, VolumeTextures& shared, WorkBy by)
    : m_grid(shared.grid())
    , m_shared(shared)
    , m_radiation(shared.radiation().view(GL_R8UI, "radiation, integer"))
    , m_segmentation(shared.segmentation().view(GL_R8UI, "segmentation map, integer"))
    , m_copier(programs.copy, m_grid, by)
    , m_radiationKernel(programs.radiation, m_grid)
    , m_barriers(programs, m_grid, by)
    , m_programs(programs)
{
    // What a session begins with (core::initialDocument).
    coverage(1).reserve();
    seedWords(0).reserve();
    shareGrowth();
    m_shared.setBarriers(&m_barriers);
}

VoxelFields::~VoxelFields()
{
    m_shared.setGrowth(0, nullptr, {});
    m_shared.setBarriers(nullptr);
    m_shared.setTolerances(nullptr, 0);
    m_shared.setFurtherPlanes({}, nullptr);
}

BrickField& VoxelFields::coverage(std::uint8_t layer)
{
    BrickField& field = m_coverage[layer];
    if (!field.created())
        field =
            BrickField({.label = "coverage", .format = GL_R8UI, .emptyVoxel = 0, .grid = m_grid});
    return field;
}

BrickField& VoxelFields::seedWords(std::uint8_t plane)
{
    BrickField& field = m_seedWords[plane];
    if (!field.created()) {
        field = BrickField(
            {.label = "seed words", .format = GL_R32UI, .emptyVoxel = 0xFFFFFFFFu, .grid = m_grid});
        if (plane == m_growthPlane)
            shareGrowth();
    }
    return field;
}

std::optional<std::size_t> VoxelFields::placeOf(std::uint8_t plane) const
{
    if (plane == 0)
        return 0;
    const auto known = m_furtherPlanes.find(plane);
    if (known == m_furtherPlanes.end())
        return std::nullopt;
    return std::size_t(std::distance(m_furtherPlanes.begin(), known)) + 1;
}

void VoxelFields::shareGrowth()
{
    const auto words = m_seedWords.find(m_growthPlane);
    const bool has = words != m_seedWords.end() && words->second.created();
    m_shared.setGrowth(m_growthPlane, has ? &words->second : nullptr, placeOf(m_growthPlane));
}

void VoxelFields::showGrowth(std::uint8_t plane)
{
    if (plane == m_growthPlane)
        return;
    const std::optional<int> tolerance = shownTolerance();
    m_growthPlane = plane;
    shareGrowth();
    shareTolerances();
    noteTolerance(tolerance);
    const auto words = m_seedWords.find(plane);
    m_barriers.noteAll(
        words == m_seedWords.end() ? std::vector<std::uint32_t>() : words->second.heldBricks());
    m_shared.markDirty(VolumeField::Barriers, {glm::ivec3(0), m_grid.volumeSize});
}

BrickField& VoxelFields::overwritten(std::uint8_t plane)
{
    BrickField& field = m_overwritten[plane];
    if (!field.created())
        field = BrickField(
            {.label = "overwritten labels", .format = GL_R8UI, .emptyVoxel = 0, .grid = m_grid});
    return field;
}

bool VoxelFields::anyOverwritten(std::uint8_t plane) const
{
    const auto field = m_overwritten.find(plane);
    return field != m_overwritten.end() && !field->second.empty();
}

const Texture3D& VoxelFields::labels(std::uint8_t plane)
{
    if (plane == 0)
        return m_shared.labels();
    if (const auto known = m_furtherPlanes.find(plane); known != m_furtherPlanes.end())
        return known->second;
    // Both or neither: what an edit asks for may be refused, what pictures need must not be.
    Texture3D texture({.label = "label plane", .size = m_grid.volumeSize, .format = GL_R8UI});
    texture.clear();
    if (!m_seenLabels)
        m_seenLabels.emplace(m_grid, m_shared.labels());
    const Texture3D& made = m_furtherPlanes.emplace(plane, std::move(texture)).first->second;
    sharePlanes();
    return made;
}

std::array<const Texture3D*, core::mostLabelPlanes> VoxelFields::labelPlanes() const
{
    std::array<const Texture3D*, core::mostLabelPlanes> planes{&m_shared.labels()};
    for (const auto& [plane, texture] : m_furtherPlanes) {
        if (plane < planes.size())
            planes[plane] = &texture;
    }
    return planes;
}

void VoxelFields::sharePlanes()
{
    std::vector<const Texture3D*> further;
    for (const auto& [plane, texture] : m_furtherPlanes) {
        if (plane < core::mostLabelPlanes)
            further.push_back(&texture);
    }
    m_shared.setFurtherPlanes(std::move(further), &m_seenLabels->texture());
    shareGrowth();
    if (m_shownLabels.any())
        m_staleSegmentation.insert(m_labelledBricks.begin(), m_labelledBricks.end());
}

BrickField* VoxelFields::paged(core::Field field, std::uint8_t plane)
{
    switch (field) {
    case core::Field::Coverage:
        return &coverage(plane);
    case core::Field::SeedWords:
        return &seedWords(plane);
    case core::Field::Overwritten:
        return &overwritten(plane);
    case core::Field::Labels:
        return nullptr;
    }
    return nullptr;
}

FieldTextures VoxelFields::textures(core::Field field, std::uint8_t plane)
{
    if (BrickField* bricks = paged(field, plane))
        return texturesOf(*bricks, field);
    return {.voxels = &labels(plane), .field = field};
}

bool VoxelFields::hasData(const core::BrickKey& key)
{
    if (const BrickField* bricks = paged(key.field, key.plane))
        return bricks->holds(key.brick);
    // A plane that is not in use holds nothing. Asking for its texture would make it.
    const bool isInUse = key.plane == 0 || m_furtherPlanes.count(key.plane) != 0;
    return isInUse && m_labelledBricks.count(key.brick) != 0;
}

std::vector<std::uint32_t> VoxelFields::labelledBricks() const
{
    return {m_labelledBricks.begin(), m_labelledBricks.end()};
}

std::vector<core::VoxelBox> VoxelFields::boxesOf(std::span<const std::uint32_t> bricks) const
{
    std::vector<core::VoxelBox> boxes;
    for (const std::uint32_t brick : bricks)
        boxes.push_back(m_grid.boxOf(int(brick)));
    return boxes;
}

core::VoxelBox VoxelFields::boxOf(std::span<const std::uint32_t> bricks) const
{
    core::VoxelBox box;
    for (const std::uint32_t brick : bricks)
        box = box.united(m_grid.boxOf(int(brick)));
    return box;
}

std::vector<std::uint32_t> VoxelFields::withNeighbours(std::span<const std::uint32_t> bricks) const
{
    const glm::ivec3 count = m_grid.bricks();
    std::vector<bool> wanted(std::size_t(m_grid.brickCount()), false);
    for (const std::uint32_t brick : bricks) {
        const glm::ivec3 position = m_grid.brickPosition(int(brick));
        const glm::ivec3 low = glm::max(position - 1, glm::ivec3(0));
        const glm::ivec3 high = glm::min(position + 1, count - 1);
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x)
                    wanted[std::size_t(x + count.x * (y + count.y * z))] = true;
    }
    std::vector<std::uint32_t> result;
    for (std::uint32_t brick = 0; brick < wanted.size(); ++brick) {
        if (wanted[brick])
            result.push_back(brick);
    }
    return result;
}

void VoxelFields::noteChanged(core::Field field, std::span<const std::uint32_t> bricks)
{
    if (bricks.empty())
        return;
    if (field == core::Field::Coverage) {
        noteCoverage(boxesOf(bricks));
    } else if (field == core::Field::SeedWords) {
        m_shared.markDirty(VolumeField::Barriers, boxOf(bricks));
        m_barriers.note(bricks);
    } else if (field == core::Field::Labels) {
        m_labelledBricks.insert(bricks.begin(), bricks.end());
        m_shared.markDirty(VolumeField::Labels, boxOf(bricks));
        notePieces(false, withNeighbours(bricks));
        if (m_shownLabels.any()) {
            for (const std::uint32_t brick : withNeighbours(bricks))
                m_staleSegmentation.insert(brick);
        }
    }
}

std::vector<RadiationKernel::Region> VoxelFields::around(
    std::span<const core::VoxelBox> boxes) const
{
    constexpr int brickSide = core::BrickGrid::side;
    const glm::ivec3 bricks = m_grid.bricks();
    constexpr std::uint32_t absent = 0xFFFFFFFFu;
    std::vector<std::uint32_t> places(std::size_t(m_grid.brickCount()), absent);
    std::vector<RadiationKernel::Region> regions;
    for (const core::VoxelBox& box : boxes) {
        const glm::ivec3 low = glm::max(box.minimum - RadiationKernel::reach, glm::ivec3(0));
        const glm::ivec3 high = glm::min(box.maximum + RadiationKernel::reach, m_grid.volumeSize);
        const glm::ivec3 first = low / brickSide;
        const glm::ivec3 last = (high - 1) / brickSide;
        for (int z = first.z; z <= last.z; ++z) {
            for (int y = first.y; y <= last.y; ++y) {
                for (int x = first.x; x <= last.x; ++x) {
                    const glm::ivec3 origin = glm::ivec3(x, y, z) * brickSide;
                    const glm::ivec3 localLow = glm::max(low - origin, glm::ivec3(0));
                    const glm::ivec3 localHigh = glm::min(high - origin, glm::ivec3(brickSide));
                    const auto brick = std::uint32_t(x + bricks.x * (y + bricks.y * z));
                    if (places[brick] == absent) {
                        places[brick] = std::uint32_t(regions.size());
                        regions.push_back({brick, localLow, localHigh});
                        continue;
                    }
                    RadiationKernel::Region& region = regions[places[brick]];
                    region.low = glm::min(region.low, localLow);
                    region.high = glm::max(region.high, localHigh);
                }
            }
        }
    }
    return regions;
}

void VoxelFields::noteCoverage(std::span<const core::VoxelBox> boxes)
{
    const std::vector<RadiationKernel::Region> regions = around(boxes);
    std::vector<BrickField*> layers;
    for (auto& [layer, field] : m_coverage) {
        if (!m_mutedLayers[layer] && !field.empty())
            layers.push_back(&field);
    }
    m_radiationKernel.updateFromCoverage(layers, m_radiation, regions);
    core::VoxelBox dirty;
    for (const core::VoxelBox& box : boxes)
        dirty = dirty.united({glm::max(box.minimum - RadiationKernel::reach, glm::ivec3(0)),
            glm::min(box.maximum + RadiationKernel::reach, m_grid.volumeSize)});
    m_shared.markDirty(VolumeField::Radiation, dirty);
    std::vector<std::uint32_t> touched;
    for (const RadiationKernel::Region& region : regions)
        touched.push_back(region.brick);
    notePieces(true, touched);
}

void VoxelFields::setMutedLayers(const std::bitset<256>& muted)
{
    const std::bitset<256> switched = muted ^ m_mutedLayers;
    m_mutedLayers = muted;
    std::set<std::uint32_t> bricks;
    for (const auto& [layer, field] : m_coverage) {
        if (!switched[layer])
            continue;
        const std::vector<std::uint32_t> held = field.heldBricks();
        bricks.insert(held.begin(), held.end());
    }
    const std::vector<std::uint32_t> changed(bricks.begin(), bricks.end());
    if (!changed.empty())
        noteCoverage(boxesOf(changed));
}

void VoxelFields::setShownLabels(const std::bitset<256>& shown, const std::bitset<256>& translucent)
{
    const bool composedAnew = m_seenLabels && translucent != m_translucentLabels;
    m_translucentLabels = translucent;
    if (shown == m_shownLabels && !composedAnew)
        return;
    m_shownLabels = shown;
    const std::vector<std::uint32_t> labelled(m_labelledBricks.begin(), m_labelledBricks.end());
    for (const std::uint32_t brick : withNeighbours(labelled))
        m_staleSegmentation.insert(brick);
}

void VoxelFields::updateBarriers()
{
    const core::VoxelBox changed = m_barriers.update(seedWords(m_growthPlane));
    if (!changed.empty())
        m_shared.markDirty(VolumeField::BarrierBricks, changed);
}

std::vector<std::uint32_t> VoxelFields::bricksWithBarriers(std::uint8_t plane)
{
    const auto words = m_seedWords.find(plane);
    if (words == m_seedWords.end() || !words->second.created())
        return {};
    if (plane == m_growthPlane)
        return m_barriers.bricks(words->second);
    return m_barriers.found(words->second, words->second.heldBricks());
}

void VoxelFields::updateSegmentation(std::size_t maxBricks)
{
    std::vector<std::uint32_t> bricks;
    while (!m_staleSegmentation.empty() && bricks.size() < maxBricks)
        bricks.push_back(m_staleSegmentation.extract(m_staleSegmentation.begin()).value());
    std::vector<RadiationKernel::Region> regions;
    for (const std::uint32_t brick : bricks)
        regions.push_back({.brick = brick});
    const std::vector<const Texture3D*> planes = m_shared.labelPlanes();
    if (m_seenLabels)
        m_seenLabels->update(m_programs.composeLabels(), planes,
            {.shown = m_shownLabels, .translucent = m_translucentLabels}, bricks);
    const std::optional<int> tolerance = shownTolerance();
    if (tolerance)
        m_radiationKernel.updateFromLabels(planes,
            {.tolerances = m_tolerance.tolerances,
                .seedWords = seedWords(m_growthPlane),
                .label = m_tolerance.rule.label,
                .tolerance = *tolerance,
                .place = *placeOf(m_growthPlane)},
            m_shownLabels, m_segmentation, regions);
    else
        m_radiationKernel.updateFromLabels(planes, m_shownLabels, m_segmentation, regions);
    m_shared.markDirty(VolumeField::Segmentation, boxOf(bricks));
}

void VoxelFields::deriveAnew()
{
    const std::vector<std::uint32_t> labelled(m_labelledBricks.begin(), m_labelledBricks.end());
    for (const std::uint32_t brick : withNeighbours(labelled))
        m_staleSegmentation.insert(brick);
    if (const auto words = m_seedWords.find(m_growthPlane); words != m_seedWords.end())
        m_barriers.noteAll(words->second.heldBricks());
    m_arrangeAnew = m_arrangeAnew || !m_stalePieces.empty();
}

std::size_t VoxelFields::bytes() const
{
    std::size_t total = 0;
    for (const auto& layer : m_coverage)
        total += layer.second.bytes();
    for (const auto& words : m_seedWords)
        total += words.second.bytes();
    for (const auto& below : m_overwritten)
        total += below.second.bytes();
    for (const auto& plane : m_furtherPlanes)
        total += plane.second.bytes();
    total += m_seenLabels ? m_seenLabels->texture().bytes() : 0;
    total += m_shared.pieces().bytes();
    total += m_spread.bytes();
    total += m_tolerance.bytes();
    return total;
}

} // namespace gpu
