// SPDX-License-Identifier: Apache-2.0
#include "core/growth/cut/GrowthCut.h"

#include "core/growth/cut/BackwardCut.h"
#include "core/growth/cut/CutWriting.h"
#include "core/growth/cut/LabelCut.h"

#include <algorithm>

namespace core {

namespace {

using Voxel = WordBricks::Voxel;
using Voxels = std::vector<Voxel>;
using WordChanges = LabelCut::WordChanges;

/// Rule 11, for the voxels of one label that leave.
void write(CutWriting& writing, const WordBricks& words, const std::vector<std::uint8_t>& marks,
    const Voxels& leaving, std::uint32_t label, bool barrier)
{
    std::vector<glm::ivec3> barriers;
    for (const Voxel voxel : leaving) {
        writing.leave(voxel, seedWord::wasHeld(words[voxel]) ? 0 : label);
        bool bounds = false;
        words.forNeighbours(voxel, 0, barrier ? seedWord::directions : 0,
            [&](Voxel neighbour, std::uint32_t word, std::uint32_t) {
                bounds = bounds
                    || (seedWord::isMember(word) && seedWord::label(word) == label
                        && (marks[neighbour] & LabelCut::leaves) == 0);
            });
        if (bounds)
            barriers.push_back(words.positionOf(voxel));
    }
    for (const glm::ivec3& place : barriers)
        writing.setBarrier(place);
    for (const glm::ivec3& place : barriers)
        writing.setBarrierAround(place);
}

/// @param marks of each voxel; LabelCut::leaves is set where it leaves
Result<LeavingVoxels> markLeaving(const WordBricks& words, const CutGrowth& command,
    std::vector<std::uint8_t>& marks, WordChanges& retimed)
{
    Result<LeavingVoxels> leaving = sketchedVoxels(words, command);
    if (!leaving)
        return leaving;
    for (auto& [label, sketch] : *leaving)
        sketch = LabelCut(words, command, label, marks).run(sketch, retimed);
    return leaving;
}

} // namespace

/// Rule 1.
Result<LeavingVoxels> sketchedVoxels(const WordBricks& words, const CutGrowth& command)
{
    LeavingVoxels sketches;
    Voxels roots;
    for (const glm::ivec3& place : command.voxels) {
        const Voxel voxel = words.find(place);
        if (voxel == WordBricks::none)
            continue;
        const std::uint32_t word = words[voxel];
        if (!seedWord::isMember(word) || command.lockedLabels[seedWord::label(word)])
            continue;
        if (LabelMembers::isRoot(word))
            roots.push_back(voxel);
        else
            sketches[seedWord::label(word)].push_back(voxel);
    }
    const auto once = [](Voxels& voxels) {
        std::sort(voxels.begin(), voxels.end());
        voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
    };
    once(roots);
    if (!roots.empty())
        return failure(ErrorCode::SeedsStay, QString::number(roots.size()));
    if (sketches.empty())
        return failure(ErrorCode::NothingGrown);
    for (auto& [label, sketch] : sketches)
        once(sketch);
    return sketches;
}

Result<LeavingVoxels> leavingVoxels(const WordBricks& words, const CutGrowth& command)
{
    if (command.how == CutGrowth::How::Backwards) {
        const Result<std::unique_ptr<BackwardCut>> cut = BackwardCut::begin(words, command);
        if (!cut)
            return tl::unexpected(cut.error());
        WordChanges changes;
        return (*cut)->leaving(changes);
    }
    std::vector<std::uint8_t> marks(words.count(), 0);
    WordChanges retimed;
    return markLeaving(words, command, marks, retimed);
}

GrowthCutOutcome cutOutcome(const WordBricks& words, const CutGrowth& command,
    const LeavingVoxels& leaving, const std::vector<std::uint8_t>& marks,
    const WordChanges& retimed)
{
    GrowthCutOutcome outcome{.bricks = {}, .generation = command.generation};
    CutWriting writing(words);
    for (const auto& [voxel, word] : retimed)
        writing.replace(voxel, word);
    for (const auto& [label, voxels] : leaving)
        write(writing, words, marks, voxels, label, command.barrier);
    outcome.bricks = writing.take();
    if (outcome.bricks.empty())
        return outcome;
    outcome.generation = 0;
    for (std::size_t voxel = 0; voxel < words.count(); ++voxel) {
        const std::uint32_t word = words[Voxel(voxel)];
        if (seedWord::isMember(word) && (marks[voxel] & LabelCut::leaves) == 0)
            outcome.generation = std::max(outcome.generation, seedWord::generation(word));
    }
    for (const auto& [voxel, word] : retimed)
        outcome.generation = std::max(outcome.generation, seedWord::generation(word));
    return outcome;
}

Result<GrowthCutOutcome> cutGrowth(const WordBricks& words, const CutGrowth& command)
{
    if (command.how == CutGrowth::How::Backwards) {
        const Result<std::unique_ptr<BackwardCut>> cut = BackwardCut::begin(words, command);
        if (!cut)
            return tl::unexpected(cut.error());
        return (*cut)->outcome();
    }
    std::vector<std::uint8_t> marks(words.count(), 0);
    WordChanges retimed;
    const Result<LeavingVoxels> leaving = markLeaving(words, command, marks, retimed);
    if (!leaving)
        return tl::unexpected(leaving.error());
    return cutOutcome(words, command, *leaving, marks, retimed);
}

} // namespace core
