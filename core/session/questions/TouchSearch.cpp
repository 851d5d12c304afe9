// SPDX-License-Identifier: Apache-2.0
#include "core/session/questions/TouchSearch.h"

#include "core/edits/EditNames.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/engine/EngineCommands.h"
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
    const std::uint32_t word = seedWord::wordAt(voxel);
    return word == seedWord::unvisited ? 0 : int(seedWord::label(word));
}

bool touchesSegment(int segment, const BrickImage& difference, const BrickImage& after)
{
    const Field field = difference.key.field;
    const auto width = std::size_t(bytesPerVoxel(field));
    const std::vector<std::uint8_t> empty(difference.bytes.size(), emptyByte(field));
    const BrickImage undone = exclusiveOr(after, difference);
    const std::vector<std::uint8_t>& now = after.bytes.empty() ? empty : after.bytes.read();
    const std::vector<std::uint8_t>& before = undone.bytes.empty() ? empty : undone.bytes.read();
    for (std::size_t voxel = 0; voxel < now.size(); voxel += width) {
        const int has = labelAt(field, &now[voxel]);
        const int had = labelAt(field, &before[voxel]);
        const bool changed = !std::equal(&now[voxel], &now[voxel] + width, &before[voxel]);
        if (changed && (has == segment || had == segment))
            return true;
    }
    return false;
}

bool touchesBox(const VoxelBox& box, const BrickGrid& grid, const BrickImage& difference)
{
    const VoxelBox brick = grid.boxOf(int(difference.key.brick));
    const glm::ivec3 low = glm::max(brick.minimum, box.minimum);
    const glm::ivec3 high = glm::min(brick.maximum, box.maximum);
    const int width = bytesPerVoxel(difference.key.field);
    const std::vector<std::uint8_t>& bytes = difference.bytes.read();
    for (int z = low.z; z < high.z; ++z) {
        for (int y = low.y; y < high.y; ++y) {
            for (int x = low.x; x < high.x; ++x) {
                const auto voxel =
                    bytes.begin() + std::ptrdiff_t(BrickGrid::offsetInBrick({x, y, z})) * width;
                if (std::any_of(voxel, voxel + width, [](std::uint8_t byte) { return byte != 0; }))
                    return true;
            }
        }
    }
    return false;
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
        if (!changesDocumentOnly(edit) && rowUseOf(edit) != RowUse::TakesBack)
            m_standing.push_back(row);
    }
    loadNext(state);
}

void TouchSearch::loadNext(SessionState& state)
{
    // Rows before the first that may be the answer are not looked at.
    while (!m_rows.empty() && !m_standing.empty() && m_rows.back() >= m_standing.front()) {
        if (!changesDocumentOnly(state.history.row(m_rows.back()).edit)) {
            m_isLoading = true;
            return state.worker->load(m_rows.back());
        }
        m_rows.pop_back();
    }
    answer(state, 0);
}

void TouchSearch::takeDifferences(SessionState& state, Result<RowDifferences>&& differences)
{
    m_isLoading = false;
    if (!differences) {
        state.fail(differences.error());
        return answer(state, 0);
    }
    m_differences = std::move(differences->images);
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
    const RowId row = m_rows.back();
    m_rows.pop_back();
    const bool mayAnswer = std::binary_search(m_standing.begin(), m_standing.end(), row);
    const BrickGrid grid{state.document.volumes.front().geometry.size};
    const auto work = std::make_shared<Looking>(
        Looking{.differences = std::move(m_differences), .images = std::move(m_images)});
    m_aside.post(
        *state.side,
        [this, touch = m_touch, grid, row, mayAnswer, work] {
            work->touched = mayAnswer && work->touches(touch, grid);
            work->goBack();
            return SideThread::Sequel(
                [this, row, work](SessionState& known) { goOn(known, row, *work); });
        },
        [this](SessionState& known, const Error& error) {
            known.fail(error);
            answer(known, 0);
        });
}

void TouchSearch::goOn(SessionState& state, RowId row, Looking& looked)
{
    m_images = std::move(looked.images);
    if (looked.touched)
        answer(state, row);
    else
        loadNext(state);
}

bool TouchSearch::Looking::touches(const Touch& touch, const BrickGrid& grid) const
{
    return std::any_of(differences.begin(), differences.end(), [&](const BrickImage& difference) {
        if (touch.segment == 0)
            return touchesBox(touch.box, grid, difference);
        return difference.key.field != Field::Coverage
            && touchesSegment(touch.segment, difference, images.at(difference.key));
    });
}

void TouchSearch::Looking::goBack()
{
    for (const BrickImage& difference : differences) {
        if (const auto image = images.find(difference.key); image != images.end())
            image->second = exclusiveOr(image->second, difference);
    }
}

bool TouchSearch::abandon(SessionState& state, const Error& error)
{
    if (m_done || m_isLoading)
        return false;
    state.fail(error);
    m_aside.giveUp([this, &state] { answer(state, 0); });
    return true;
}

void TouchSearch::answer(SessionState& state, RowId row)
{
    m_done = true;
    state.answers.push_back([answer = std::move(m_answer), row] { answer(row); });
}

} // namespace core
