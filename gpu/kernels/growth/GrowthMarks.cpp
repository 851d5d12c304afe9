// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/growth/GrowthMarks.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

namespace gpu {

void GrowthMarks::begin(std::optional<std::uint8_t> growing)
{
    m_keeps = false;
    const bool goesOn = growing && growing == m_plane;
    m_plane = growing;
    if (goesOn)
        return;
    hide();
    m_kept.clear();
}

void GrowthMarks::show(VoxelFields& fields, Bricks changed, bool keep)
{
    m_keeps = keep;
    m_marks.show(fields, marksAfter(m_kept, std::move(changed)), m_plane.value_or(0));
}

void GrowthMarks::keep(VoxelFields& fields, Bricks changed)
{
    m_keeps = false;
    m_kept = marksAfter(m_kept, std::move(changed));
    restore(fields);
}

void GrowthMarks::restore(VoxelFields& fields)
{
    if (m_kept.empty())
        hide();
    else
        m_marks.show(fields, m_kept, m_plane.value_or(0));
}

void GrowthMarks::forget()
{
    hide();
    m_kept.clear();
    m_keeps = false;
}

std::vector<PreviewMarks::Brick> marksAfter(
    const std::vector<PreviewMarks::Brick>& kept, std::vector<PreviewMarks::Brick> changed)
{
    std::map<std::uint32_t, std::vector<std::uint8_t>> marked;
    for (PreviewMarks::Brick& brick : changed)
        marked.emplace(brick.brick, std::move(brick.marks));
    for (const PreviewMarks::Brick& before : kept) {
        std::vector<std::uint8_t>& marks = marked[before.brick];
        marks.resize(before.marks.size(), PreviewMarks::None);
        for (std::size_t voxel = 0; voxel < marks.size(); ++voxel) {
            if (before.marks[voxel] != PreviewMarks::Suspended)
                continue;
            if (marks[voxel] == PreviewMarks::None)
                marks[voxel] = PreviewMarks::Suspended;
            else if (marks[voxel] == PreviewMarks::Reached)
                marks[voxel] = PreviewMarks::Reinstated;
        }
    }
    std::vector<PreviewMarks::Brick> bricks;
    for (auto& [brick, marks] : marked) {
        const bool isMarked = std::any_of(marks.begin(), marks.end(),
            [](std::uint8_t mark) { return mark != PreviewMarks::None; });
        if (isMarked)
            bricks.push_back({.brick = brick, .marks = std::move(marks)});
    }
    return bricks;
}

} // namespace gpu
