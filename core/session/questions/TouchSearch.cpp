// SPDX-License-Identifier: Apache-2.0
#include "core/session/questions/TouchSearch.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/growth/SeedWord.h"

#include <algorithm>
#include <utility>

namespace core {

namespace {

/// The segment that a voxel belongs to or waits for, or that would have it back; 0: none.
int labelAt(Field field, const std::uint8_t* voxel)
{
    if (field != Field::SeedWords)
        return *voxel;
    const std::uint32_t word = std::uint32_t(voxel[0]) | std::uint32_t(voxel[1]) << 8
        | std::uint32_t(voxel[2]) << 16 | std::uint32_t(voxel[3]) << 24;
    return word == seedWord::unvisited ? 0 : int(seedWord::label(word));
}

} // namespace

TouchSearch::TouchSearch(const Touch& touch, Answer answer)
    : m_touch(touch)
    , m_answer(std::move(answer))
{
}

void TouchSearch::start(SessionState& state)
{
    const History& history = state.history;
    m_rows = history.pathTo(history.position());
    for (const RowId row : history.standing()) {
        const Edit& edit = history.row(row).edit;
        if (!changesDocumentOnly(edit) && !edit.is<RevertRows>())
            m_standing.push_back(row);
    }
    loadNext(state);
}

void TouchSearch::loadNext(SessionState& state)
{
    // Rows before the first that may be the answer are not looked at.
    while (!m_rows.empty() && !m_standing.empty() && m_rows.back() >= m_standing.front()) {
        if (!changesDocumentOnly(state.history.row(m_rows.back()).edit))
            return state.worker->load(m_rows.back());
        m_rows.pop_back();
    }
    answer(state, 0);
}

void TouchSearch::takeDifferences(
    SessionState& state, Result<std::vector<BrickImage>>&& differences)
{
    if (!differences) {
        state.fail(differences.error());
        return answer(state, 0);
    }
    m_differences = *std::move(differences);
    ReadBricks read;
    for (const BrickImage& difference : m_differences) {
        if (m_touch.segment != 0 && difference.key.field != Field::Coverage
            && m_images.count(difference.key) == 0)
            read.keys.push_back(difference.key);
    }
    if (read.keys.empty())
        look(state);
    else
        m_reading = state.engine.submit(std::move(read));
}

void TouchSearch::takeResult(SessionState& state, EngineResult&& result)
{
    if (m_reading == 0 || result.ticket != m_reading)
        return;
    m_reading = 0;
    if (result.error) {
        state.fail(*result.error);
        return answer(state, 0);
    }
    for (BrickChange& brick : result.changes)
        m_images[brick.key] = {brick.key, std::move(brick.after)};
    look(state);
}

void TouchSearch::look(SessionState& state)
{
    const BrickGrid grid{state.document.volumes.front().geometry.size};
    const RowId row = m_rows.back();
    m_rows.pop_back();
    if (std::binary_search(m_standing.begin(), m_standing.end(), row)
        && std::any_of(m_differences.begin(), m_differences.end(),
            [&](const BrickImage& difference) { return touches(grid, difference); }))
        return answer(state, row);
    for (const BrickImage& difference : m_differences) {
        if (const auto image = m_images.find(difference.key); image != m_images.end())
            image->second = exclusiveOr(image->second, difference);
    }
    loadNext(state);
}

bool TouchSearch::touches(const BrickGrid& grid, const BrickImage& difference) const
{
    if (m_touch.segment != 0)
        return difference.key.field != Field::Coverage
            && touchesSegment(difference, m_images.at(difference.key));
    const VoxelBox brick = grid.boxOf(int(difference.key.brick));
    const glm::ivec3 low = glm::max(brick.minimum, m_touch.box.minimum);
    const glm::ivec3 high = glm::min(brick.maximum, m_touch.box.maximum);
    const int width = bytesPerVoxel(difference.key.field);
    for (int z = low.z; z < high.z; ++z) {
        for (int y = low.y; y < high.y; ++y) {
            for (int x = low.x; x < high.x; ++x) {
                const auto voxel = difference.bytes.begin()
                    + std::ptrdiff_t(BrickGrid::offsetInBrick({x, y, z})) * width;
                if (std::any_of(voxel, voxel + width, [](std::uint8_t byte) { return byte != 0; }))
                    return true;
            }
        }
    }
    return false;
}

bool TouchSearch::touchesSegment(const BrickImage& difference, const BrickImage& after) const
{
    const Field field = difference.key.field;
    const auto width = std::size_t(bytesPerVoxel(field));
    const std::vector<std::uint8_t> empty(difference.bytes.size(), emptyByte(field));
    const BrickImage undone = exclusiveOr(after, difference);
    const std::vector<std::uint8_t>& now = after.bytes.empty() ? empty : after.bytes;
    const std::vector<std::uint8_t>& before = undone.bytes.empty() ? empty : undone.bytes;
    for (std::size_t voxel = 0; voxel < now.size(); voxel += width) {
        const int has = labelAt(field, &now[voxel]);
        const int had = labelAt(field, &before[voxel]);
        const bool changed = !std::equal(&now[voxel], &now[voxel] + width, &before[voxel]);
        if (changed && (has == m_touch.segment || had == m_touch.segment))
            return true;
    }
    return false;
}

void TouchSearch::answer(SessionState& state, RowId row)
{
    m_done = true;
    state.answers.push_back([answer = std::move(m_answer), row] { answer(row); });
}

} // namespace core
