// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/GrowthTrace.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/sculpt/SculptEdits.h"

#include <algorithm>

namespace core {

namespace {

/// The voxels of a brick whose words differ.
VoxelBox boxOfWords(const BrickImage& difference, const VoxelBox& brick)
{
    const int width = bytesPerVoxel(Field::SeedWords);
    const std::vector<std::uint8_t>& bytes = difference.bytes.read();
    VoxelBox box{.minimum = brick.maximum, .maximum = brick.minimum};
    for (int z = brick.minimum.z; z < brick.maximum.z; ++z) {
        for (int y = brick.minimum.y; y < brick.maximum.y; ++y) {
            for (int x = brick.minimum.x; x < brick.maximum.x; ++x) {
                const auto word =
                    bytes.begin() + std::ptrdiff_t(BrickGrid::offsetInBrick({x, y, z})) * width;
                if (std::all_of(word, word + width, [](std::uint8_t byte) { return byte == 0; }))
                    continue;
                box.minimum = glm::min(box.minimum, glm::ivec3(x, y, z));
                box.maximum = glm::max(box.maximum, glm::ivec3(x, y, z) + 1);
            }
        }
    }
    return box;
}

} // namespace

std::vector<ChangedWords> changedWords(
    const std::vector<BrickImage>& differences, const BrickGrid& grid)
{
    std::vector<ChangedWords> words;
    for (const BrickImage& difference : differences) {
        if (difference.key.field != Field::SeedWords || difference.bytes.empty())
            continue;
        const VoxelBox box = boxOfWords(difference, grid.boxOf(int(difference.key.brick)));
        if (box.minimum.x < box.maximum.x)
            words.push_back({.key = difference.key, .box = box});
    }
    return words;
}

bool GrowthTrace::isOf(const Edit& edit)
{
    const GrowCriteria* criteria = growCriteriaOf(edit);
    return criteria && !criteria->passage;
}

bool GrowthTrace::mayNeed(const Edit& edit)
{
    return !changesDocumentOnly(edit) && !isSculptEdit(edit) && !writesSomeLayer(edit);
}

void GrowthTrace::note(RowId row, const std::vector<ChangedWords>& words, const BrickGrid& grid)
{
    ByPlane& byPlane = m_besideWords[row];
    for (const ChangedWords& changed : words) {
        std::set<std::uint32_t>& beside = byPlane[changed.key.plane];
        const glm::ivec3 first = glm::max(changed.box.minimum - 1, glm::ivec3(0)) / BrickGrid::side;
        const glm::ivec3 last =
            glm::min(changed.box.maximum, grid.volumeSize - 1) / BrickGrid::side;
        for (int z = first.z; z <= last.z; ++z) {
            for (int y = first.y; y <= last.y; ++y) {
                for (int x = first.x; x <= last.x; ++x)
                    beside.insert(
                        std::uint32_t(grid.brickOf(glm::ivec3(x, y, z) * int(BrickGrid::side))));
            }
        }
    }
}

std::set<std::uint32_t> GrowthTrace::bricksUpTo(RowId row, std::uint8_t plane) const
{
    std::set<std::uint32_t> bricks;
    for (const auto& [earlier, byPlane] : m_besideWords) {
        const auto beside = byPlane.find(plane);
        if (earlier <= row && beside != byPlane.end())
            bricks.insert(beside->second.begin(), beside->second.end());
    }
    return bricks;
}

} // namespace core
