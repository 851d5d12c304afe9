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

/// A CutGrowth with How::Backwards (GrowthCut.h, rule 12) that can be taken further while it is
/// open.
class BackwardCut {
public:
    /// Begins the cut and carries out the steps of the command.
    /// @param words linked; contain all bricks of the plane with seed words; must outlive this
    /// Errors: SeedsStay, NothingGrown (rule 1), EverythingGrown (rule 12).
    static Result<std::unique_ptr<BackwardCut>> begin(
        const WordBricks& words, const CutGrowth& command);
    ~BackwardCut();
    BackwardCut(const BackwardCut&) = delete;
    BackwardCut& operator=(const BackwardCut&) = delete;

    /// Continues until this number of steps is done, the steps end, or the next one would remove
    /// everything that has grown. It cannot go back.
    void advanceTo(std::uint32_t steps);
    [[nodiscard]] BackwardProgress progress() const;

    /// All members that leave by the steps so far, by label.
    /// @param changes receives the new words of members that stay (rule 10)
    [[nodiscard]] LeavingVoxels leaving(LabelCut::WordChanges& changes);
    /// What the growth becomes, the same as if it had been cut in one go.
    [[nodiscard]] GrowthCutOutcome outcome();

private:
    struct Label;

    BackwardCut(const WordBricks& words, const CutGrowth& command);
    void advance();

    const WordBricks& m_words;
    CutGrowth m_command;
    std::vector<std::uint8_t> m_marks; ///< for each voxel, the marks that LabelCut uses
    std::vector<std::unique_ptr<Label>> m_labels; ///< one for each label that has a sketch
    std::uint32_t m_steps = 1;
    BackwardProgress::Bound m_bound = BackwardProgress::Bound::None;
};

} // namespace core
