// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/parts/ChunkTextures.h"

#include <algorithm>
#include <utility>

namespace gpu {

bool ChunkTextures::update(const SceneChunks* chunks, Drawn drawn)
{
    if (!chunks) {
        if (m_voxels && m_leaves.expired())
            drop();
        return false;
    }
    if (!chunks->leaves || chunks->box.empty() || chunks->argb.empty()
        || glm::any(glm::lessThan(chunks->cell, glm::ivec3(1))))
        return false;
    const glm::ivec3 size = chunks->cells();
    if (chunks->leaves->size() != std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z)
        || chunks->opacity <= 0.0f)
        return false;
    const std::size_t width = chunks->argb.size();
    if (!m_voxels || m_leaves.lock() != chunks->leaves || m_voxels.size() != size)
        takeLeaves(*chunks);
    // A leaf beyond the colours would be read from nowhere.
    if (m_boxes.size() > width)
        return false;
    if (drawn == Drawn::Areas) {
        takeColours(m_areas, *chunks);
        return true;
    }
    const bool begins = !m_bodies;
    const core::VoxelBox changed = changedBy(chunks->argb);
    takeColours(m_bodyColours, *chunks);
    if (begins || !changed.empty()) {
        m_bodies.update(size, *chunks->leaves, m_bodyColours.row, changed);
        m_changed = true;
    }
    return true;
}

void ChunkTextures::takeLeaves(const SceneChunks& chunks)
{
    drop();
    m_changed = true;
    const glm::ivec3 size = chunks.cells();
    m_voxels = Texture3D({.label = "chunks", .size = size, .format = GL_R16UI});
    m_voxels.upload(std::span<const std::uint16_t>(*chunks.leaves));
    m_leaves = chunks.leaves;
    const std::uint16_t* leaf = chunks.leaves->data();
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x;) {
                int end = x + 1;
                while (end < size.x && leaf[end - x] == *leaf)
                    ++end;
                if (*leaf != 0) {
                    if (m_boxes.size() < *leaf)
                        m_boxes.resize(*leaf);
                    core::VoxelBox& box = m_boxes[*leaf - 1U];
                    box = box.united({{x, y, z}, {end, y + 1, z + 1}});
                }
                leaf += end - x;
                x = end;
            }
        }
    }
}

core::VoxelBox ChunkTextures::changedBy(const std::vector<std::uint32_t>& argb) const
{
    core::VoxelBox changed;
    for (std::size_t leaf = 0; leaf < m_boxes.size(); ++leaf) {
        if (leaf >= m_bodyColours.argb.size() || m_bodyColours.argb[leaf] != argb[leaf])
            changed = changed.united(m_boxes[leaf]);
    }
    return changed;
}

/// The texture has two rows: the colours, and above them the rims.
void ChunkTextures::takeColours(Colours& colours, const SceneChunks& chunks)
{
    if (colours.texture && colours.argb == chunks.argb && colours.rims == chunks.rims)
        return;
    colours.argb = chunks.argb;
    colours.rims = chunks.rims;
    const auto seen = [](std::uint32_t argb) {
        const auto alpha = std::uint8_t(argb >> 24);
        return alpha == 0 ? ChunkBodies::Colour{}
                          : ChunkBodies::Colour{std::uint8_t(argb >> 16), std::uint8_t(argb >> 8),
                              std::uint8_t(argb), alpha};
    };
    colours.row.assign(1, {});
    for (const std::uint32_t colour : chunks.argb)
        colours.row.push_back(seen(colour));
    std::vector<ChunkBodies::Colour> rows = colours.row;
    rows.resize(2 * colours.row.size());
    for (std::size_t leaf = 0; leaf < std::min(chunks.rims.size(), chunks.argb.size()); ++leaf)
        rows[colours.row.size() + leaf + 1] = seen(chunks.rims[leaf]);
    const glm::ivec2 size(int(colours.row.size()), 2);
    if (colours.texture.size() != size)
        colours.texture = Texture2D({.label = "chunk colours", .size = size, .format = GL_RGBA8});
    colours.texture.upload(std::span<const ChunkBodies::Colour>(rows));
}

void ChunkTextures::drop()
{
    m_leaves.reset();
    m_boxes.clear();
    m_voxels = {};
    m_areas = {};
    m_bodyColours = {};
    m_bodies = {};
}

bool ChunkTextures::takeChanged()
{
    return std::exchange(m_changed, false);
}

void ChunkTextures::bind(Program& program, const SceneChunks& chunks, Drawn drawn) const
{
    m_voxels.bindUnit(24);
    (drawn == Drawn::Areas ? m_areas : m_bodyColours).texture.bindUnit(25);
    if (drawn == Drawn::Bodies)
        m_bodies.bind(26, 27);
    // One that no code comes to stands for none.
    const core::CodeRange codes = chunks.codes.value_or(
        core::CodeRange{.lowest = 0, .highest = core::VoxelEncoding::codeCount});
    program.set("chunkOrigin", chunks.box.minimum)
        .set("chunkEnd", chunks.box.maximum)
        .set("chunkCell", chunks.cell)
        .set("chunkCodes", glm::ivec2(codes.lowest, codes.highest))
        .set("chunkOpacity", chunks.opacity);
}

} // namespace gpu
