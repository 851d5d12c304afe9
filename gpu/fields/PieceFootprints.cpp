// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/VoxelFields.h"

#include "core/base/Log.h"
#include "gpu/gl/GlFailure.h"

namespace gpu {

// VoxelFields, the part that keeps footprints of pieces.

void VoxelFields::setPieces(const std::vector<PieceSource>& sources)
{
    std::map<PieceSource, std::set<std::uint32_t>> wanted;
    bool same = sources.size() == m_stalePieces.size();
    for (const PieceSource& source : sources) {
        wanted[source];
        same = same && m_stalePieces.contains(source);
    }
    if (same)
        return;
    m_stalePieces = std::move(wanted);
    m_arrangeAnew = true;
    m_piecesRefused = false;
}

bool VoxelFields::piecesStale() const
{
    if (m_arrangeAnew)
        return true;
    for (const auto& [source, bricks] : m_stalePieces) {
        if (!bricks.empty())
            return true;
    }
    return false;
}

core::VoxelBox VoxelFields::roomFor(const PieceSource& source)
{
    std::vector<std::uint32_t> bricks;
    if (source.layer == 0)
        bricks = labelledBricks();
    else if (const auto field = m_coverage.find(std::uint8_t(source.layer));
             field != m_coverage.end())
        bricks = field->second.heldBricks();
    core::VoxelBox room = boxOf(bricks);
    if (room.empty())
        return room;
    room.minimum = glm::max(room.minimum - core::BrickGrid::side, glm::ivec3(0));
    room.maximum = glm::min(room.maximum + core::BrickGrid::side, m_grid.volumeSize);
    return room;
}

void VoxelFields::arrangePieces()
{
    std::map<PieceSource, core::VoxelBox> rooms;
    for (const auto& [source, bricks] : m_stalePieces)
        rooms[source] = roomFor(source);
    const bool isThere = makeRoomFor(rooms);
    for (auto& [source, bricks] : m_stalePieces) {
        bricks.clear();
        const core::VoxelBox& room = rooms[source];
        if (room.empty() || !isThere)
            continue;
        const glm::ivec3 count = m_grid.bricks();
        const glm::ivec3 first = room.minimum / core::BrickGrid::side;
        const glm::ivec3 last = (room.maximum - 1) / core::BrickGrid::side;
        for (int z = first.z; z <= last.z; ++z)
            for (int y = first.y; y <= last.y; ++y)
                for (int x = first.x; x <= last.x; ++x)
                    bricks.insert(std::uint32_t(x + count.x * (y + count.y * z)));
    }
    m_arrangeAnew = false;
    m_shared.markDirty(VolumeField::Pieces, {glm::ivec3(0), m_grid.volumeSize});
}

bool VoxelFields::makeRoomFor(const std::map<PieceSource, core::VoxelBox>& rooms)
{
    try {
        m_shared.pieces().arrange(rooms);
        m_piecesRefused = false;
    } catch (const ContextLost&) {
        throw;
    } catch (const GlFailure& refused) {
        qCWarning(core::log, "Pieces are not shown: %s",
            qUtf8Printable(refused.error().arguments.join(QStringLiteral(": "))));
        m_shared.pieces().arrange({});
        m_piecesRefused = true;
    }
    return !m_piecesRefused;
}

void VoxelFields::notePieces(bool ofLayers, std::span<const std::uint32_t> bricks)
{
    bool outgrown = false;
    for (auto& [source, stale] : m_stalePieces) {
        if ((source.layer != 0) != ofLayers)
            continue;
        const core::VoxelBox room = roomFor(source);
        const PieceTextures::Entry* entry = m_shared.pieces().entry(source);
        if (!entry) {
            // What was refused is not asked for again with every edit.
            outgrown = outgrown || (!room.empty() && !m_piecesRefused);
            continue;
        }
        const core::VoxelBox& own = entry->box;
        outgrown = outgrown
            || (!room.empty()
                && (glm::any(glm::lessThan(room.minimum, own.minimum))
                    || glm::any(glm::greaterThan(room.maximum, own.maximum))));
        for (const std::uint32_t brick : bricks) {
            const core::VoxelBox box = m_grid.boxOf(int(brick));
            if (glm::all(glm::greaterThanEqual(box.minimum, own.minimum))
                && glm::all(glm::lessThanEqual(box.maximum, own.maximum)))
                stale.insert(brick);
        }
    }
    m_arrangeAnew = m_arrangeAnew || outgrown;
}

void VoxelFields::updatePieces(std::size_t maxBricks)
{
    if (m_arrangeAnew)
        arrangePieces();
    for (auto& [source, stale] : m_stalePieces) {
        if (stale.empty())
            continue;
        std::vector<RadiationKernel::Region> regions;
        while (!stale.empty() && regions.size() < maxBricks)
            regions.push_back({.brick = stale.extract(stale.begin()).value()});
        updatePiece(source, regions);
        if (stale.empty()) {
            m_shared.pieces().updateCells(m_programs.pieceCells, source);
            if (const PieceTextures::Entry* entry = m_shared.pieces().entry(source))
                m_shared.markDirty(VolumeField::Pieces, entry->box);
        }
        return;
    }
}

void VoxelFields::updatePiece(
    const PieceSource& source, std::span<const RadiationKernel::Region> regions)
{
    const PieceTextures::Entry* entry = m_shared.pieces().entry(source);
    if (!entry)
        return;
    const RadiationKernel::Footprint footprint{
        .target = m_shared.pieces().footprintBytes(), .shift = entry->place - entry->box.minimum};
    if (source.layer == 0) {
        m_radiationKernel.updateFootprint(
            m_shared.labelPlanes(), source.segment, footprint, regions);
        return;
    }
    std::vector<BrickField*> before;
    for (auto& [layer, field] : m_coverage) {
        if (layer < source.layer && !m_mutedLayers[layer] && !field.empty())
            before.push_back(&field);
    }
    m_radiationKernel.updateFootprint(
        coverage(std::uint8_t(source.layer)), before, footprint, regions);
}

} // namespace gpu
