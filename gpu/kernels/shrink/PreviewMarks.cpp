// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/shrink/PreviewMarks.h"

#include "gpu/fields/VoxelFields.h"

#include <algorithm>
#include <map>
#include <utility>

namespace gpu {

namespace {

/// In whole bricks; empty if nothing is suspended.
core::VoxelBox suspendedBox(
    const std::vector<PreviewMarks::Brick>& bricks, const core::BrickGrid& grid)
{
    core::VoxelBox box;
    for (const PreviewMarks::Brick& brick : bricks) {
        const auto first =
            std::find(brick.marks.begin(), brick.marks.end(), PreviewMarks::Suspended);
        if (first != brick.marks.end())
            box = box.united(grid.boxOf(int(brick.brick)));
    }
    return box;
}

} // namespace

PreviewMarks::PreviewMarks(VolumeTextures& textures)
    : m_textures(textures)
{
}

void PreviewMarks::show(VoxelFields& fields, std::vector<Brick> bricks, std::uint8_t plane)
{
    const core::BrickGrid& grid = fields.grid();
    if (!m_marks.created())
        m_marks = BrickField(
            {.label = "preview marks", .format = GL_R8UI, .emptyVoxel = 0, .grid = grid});
    std::map<std::uint32_t, const Brick*> before;
    for (const Brick& brick : m_shown)
        before[brick.brick] = &brick;
    core::VoxelBox dirty;
    std::vector<std::uint32_t> written;
    std::vector<const std::vector<std::uint8_t>*> contents;
    for (const Brick& brick : bricks) {
        const auto known = before.find(brick.brick);
        const bool same = known != before.end() && known->second->marks == brick.marks;
        if (known != before.end())
            before.erase(known);
        if (same)
            continue;
        dirty = dirty.united(grid.boxOf(int(brick.brick)));
        written.push_back(brick.brick);
        contents.push_back(&brick.marks);
    }
    std::vector<std::uint32_t> gone;
    for (const auto& [brick, marks] : before) {
        dirty = dirty.united(grid.boxOf(int(brick)));
        gone.push_back(brick);
    }
    m_marks.release(gone);
    if (!written.empty()) {
        m_marks.ensure(written, BrickField::NewPages::AnyContent);
        fields.copier().write(texturesOf(m_marks, core::Field::Coverage), written, contents);
    }
    m_shown = std::move(bricks);
    m_textures.setCutPreview(
        m_shown.empty() ? nullptr : &m_marks, plane, suspendedBox(m_shown, grid));
    if (!dirty.empty())
        m_textures.markDirty(VolumeField::CutPreview, dirty);
}

void PreviewMarks::hide()
{
    m_textures.dropCutPreview(m_marks);
    if (!m_shown.empty()) {
        core::VoxelBox dirty;
        for (const Brick& brick : m_shown)
            dirty = dirty.united(m_textures.grid().boxOf(int(brick.brick)));
        m_textures.markDirty(VolumeField::CutPreview, dirty);
    }
    m_shown.clear();
    m_marks = {};
}

std::size_t PreviewMarks::bytes() const
{
    return m_marks.created() ? m_marks.bytes() : 0;
}

} // namespace gpu
