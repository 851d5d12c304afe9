// SPDX-License-Identifier: Apache-2.0
#include "core/growth/cut/BackwardCut.h"

#include "core/growth/cut/BackwardSteps.h"

#include <algorithm>

namespace core {

using Bound = BackwardProgress::Bound;

struct BackwardCut::Label {
    Label(const WordBricks& words, const CutGrowth& command, std::uint32_t number,
        const std::vector<WordBricks::Voxel>& sketch, std::vector<std::uint8_t>& marks)
        : label(number)
        , cut(words, command, number, marks)
        , steps(cut.members(), sketch)
    {
    }
    std::uint32_t label;
    LabelCut cut;
    BackwardSteps steps;
    bool advanced = true; ///< by the last step
};

BackwardCut::BackwardCut(const WordBricks& words, const CutGrowth& command)
    : m_words(words)
    , m_command(command)
    , m_marks(words.count(), 0)
{
}

BackwardCut::~BackwardCut() = default;

Result<std::unique_ptr<BackwardCut>> BackwardCut::begin(
    const WordBricks& words, const CutGrowth& command)
{
    const Result<LeavingVoxels> sketches = sketchedVoxels(words, command);
    if (!sketches)
        return tl::unexpected(sketches.error());
    std::unique_ptr<BackwardCut> begun(new BackwardCut(words, command));
    for (const auto& [label, sketch] : *sketches)
        begun->m_labels.push_back(
            std::make_unique<Label>(words, begun->m_command, label, sketch, begun->m_marks));
    const bool everything = std::any_of(begun->m_labels.begin(), begun->m_labels.end(),
        [](const auto& label) { return label->steps.takesEverything(); });
    begun->advanceTo(everything ? 0 : command.steps);
    if (everything || (begun->m_bound == Bound::Everything && begun->m_steps < command.steps))
        return failure(ErrorCode::EverythingGrown);
    return begun;
}

void BackwardCut::advanceTo(std::uint32_t steps)
{
    while (m_bound == Bound::None && m_steps < steps)
        advance();
}

/// One step of all labels, or of none.
void BackwardCut::advance()
{
    bool any = false;
    bool everything = false;
    for (const auto& label : m_labels) {
        label->advanced = label->advanced && label->steps.advance();
        any = any || label->advanced;
        everything = everything || label->steps.takesEverything();
    }
    if (everything) {
        for (const auto& label : m_labels) {
            if (label->advanced)
                label->steps.stepBack();
        }
        m_bound = Bound::Everything;
        return;
    }
    if (any)
        ++m_steps;
    else
        m_bound = Bound::Seeds;
}

BackwardProgress BackwardCut::progress() const
{
    BackwardProgress progress{.steps = m_steps, .bound = m_bound};
    for (const auto& label : m_labels)
        progress.members += std::int64_t(label->steps.leaving().size());
    return progress;
}

LeavingVoxels BackwardCut::leaving(LabelCut::WordChanges& changes)
{
    LeavingVoxels leaving;
    for (const auto& label : m_labels)
        leaving[label->label] =
            label->cut.takeOut(label->steps.leaving(), label->steps.rim(), changes);
    return leaving;
}

GrowthCutOutcome BackwardCut::outcome()
{
    LabelCut::WordChanges changes;
    const LeavingVoxels gone = leaving(changes);
    return cutOutcome(m_words, m_command, gone, m_marks, changes);
}

} // namespace core
