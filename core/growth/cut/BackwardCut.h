// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/growth/GrowthProgress.h"
#include "core/growth/cut/GrowthCut.h"
#include "core/growth/cut/LabelCut.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace core {

/// A cut backwards (GrowthCut.h, rule 12) that can be taken further while it is open.
class BackwardCut {
public:
    /// Does the steps of the command.
    /// @param words linked; all bricks of the plane that hold any words; must outlive this
    /// Errors: SeedsStay, NothingGrown (rule 1), EverythingGrown (rule 12).
    static Result<std::unique_ptr<BackwardCut>> begin(
        const WordBricks& words, const CutGrowth& command);
    ~BackwardCut();
    BackwardCut(const BackwardCut&) = delete;
    BackwardCut& operator=(const BackwardCut&) = delete;

    /// Goes on until so many steps are done, the steps end, or the next one would take everything.
    void advanceTo(std::uint32_t steps);
    [[nodiscard]] BackwardProgress progress() const;

    /// All that leaves by the steps so far, and the new words of members that stay.
    [[nodiscard]] LeavingVoxels leaving(LabelCut::WordChanges& changes);
    /// What becomes of the growth, as if it had been cut at once.
    [[nodiscard]] GrowthCutOutcome outcome();

private:
    struct Label;

    BackwardCut(const WordBricks& words, const CutGrowth& command);
    void advance();

    const WordBricks& m_words;
    CutGrowth m_command;
    std::vector<std::uint8_t> m_marks; ///< of each voxel, those of LabelCut
    std::vector<std::unique_ptr<Label>> m_labels; ///< that have a sketch
    std::uint32_t m_steps = 1;
    BackwardProgress::Bound m_bound = BackwardProgress::Bound::None;
};

} // namespace core
