// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/frame/FrameTargets.h"
#include "gpu/frame/ViewPainter.h"
#include "gpu/scene/TilePlan.h"

#include <cstdint>
#include <optional>

namespace gpu {

/// How far the pictures of a view are, one of which is drawn at a time: a coarse one where a full
/// one would take too long, a full one, then a finer one.
struct ViewProgress {
    enum class Stage { Coarse, Full, Refine, Done };

    FrameRequest request;
    Stage stage = Stage::Done;
    int sample = 0; ///< of Refine
    std::optional<TilePlan> tiles; ///< of the picture being drawn; none: about to begin
    bool stale = false; ///< changed while its coarse picture was drawn
    double milliseconds = 0.0;
    std::uint64_t turn = 0; ///< in which it was drawn last
    FrameTargets targets;
    ViewPictures pictures; ///< of the picture being drawn

    /// What it shows is another picture.
    void restart();
    /// What it shows has changed.
    void changed();
    /// Of no picture under way is it known what it shows.
    void giveUp();

    /// @param editing edits are running: only coarse pictures meanwhile
    [[nodiscard]] bool wants(bool editing) const;
    /// Whether it is drawn before a view that wants it, too. @param now the present turn
    [[nodiscard]] bool comesBefore(const ViewProgress& other, std::uint64_t now) const;

    /// A picture of which more are to be summed: goes on to the next of them.
    [[nodiscard]] bool goesOnToNextSample();
    /// Goes on to what is drawn next. @param drawn size of the picture that is ready
    [[nodiscard]] Frame::Quality finishStage(const glm::ivec2& drawn);

private:
    [[nodiscard]] bool isOverdue(std::uint64_t now) const;
    [[nodiscard]] bool isFlat() const;
};

} // namespace gpu
