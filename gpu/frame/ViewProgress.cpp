// SPDX-License-Identifier: Apache-2.0
#include "gpu/frame/ViewProgress.h"

#include "gpu/scene/DirtyVoxels.h"

#include <variant>

namespace gpu {

namespace {

/// Slices that others may draw before it is this view's turn, whoever holds the pointer.
constexpr std::uint64_t longestWait = 8;
constexpr int accumulated = 8;

} // namespace

void ViewProgress::restart()
{
    stage = Stage::Coarse;
    tiles.reset();
    stale = false;
    failed = false;
    sample = 0;
    milliseconds = 0.0;
    begun.reset();
}

void ViewProgress::changed()
{
    // A coarse picture under way is finished first, or a long edit would never show.
    if (drawsCoarse())
        stale = true;
    else
        restart();
}

void ViewProgress::giveUp()
{
    stage = Stage::Done;
    tiles.reset();
    stale = false;
    awaited.reset();
    failed = true;
    begun.reset();
    targets = {};
    pictures = {};
}

bool ViewProgress::wants(bool editing) const
{
    if (stage == Stage::Done)
        return false;
    return stage == Stage::Coarse || !(request.interacting || editing);
}

bool ViewProgress::isOverdue(std::uint64_t now) const
{
    return stage == Stage::Coarse && now - turn > longestWait;
}

bool ViewProgress::comesBefore(const ViewProgress& other, std::uint64_t now) const
{
    if (isOverdue(now) != other.isOverdue(now))
        return isOverdue(now);
    if (stage != other.stage)
        return stage < other.stage;
    if (request.interacting != other.request.interacting)
        return request.interacting;
    return turn < other.turn;
}

bool ViewProgress::isFlat() const
{
    return std::holds_alternative<SliceScene>(request.scene);
}

bool ViewProgress::goesOnToNextSample()
{
    if (stage != Stage::Refine || isFlat() || sample + 1 >= accumulated)
        return false;
    ++sample;
    return true;
}

Frame::Quality ViewProgress::finishStage(const glm::ivec2& drawn)
{
    const bool flat = isFlat();
    const bool cubics = wantsCubics(request.scene);
    // What could be drawn whole at once needs no second time.
    if (stage == Stage::Coarse && drawn == targets.size)
        stage = Stage::Full;
    switch (stage) {
    case Stage::Coarse:
        stage = Stage::Full;
        return Frame::Quality::Coarse;
    case Stage::Full:
        // With cubics the first of the pictures is another one, too.
        sample = cubics || flat ? 0 : 1;
        stage = flat && !cubics ? Stage::Done : Stage::Refine;
        return flat && !cubics ? Frame::Quality::Refined : Frame::Quality::Full;
    case Stage::Refine:
    case Stage::Done:
        break;
    }
    stage = Stage::Done;
    return Frame::Quality::Refined;
}

} // namespace gpu
