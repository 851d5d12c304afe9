// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/trace/Trace.h"
#include "gpu/frame/FrameTargets.h"
#include "gpu/frame/ViewPainter.h"
#include "gpu/scene/TilePlan.h"

#include <cstdint>
#include <optional>

namespace gpu {

/// The progress of the pictures of one view, which are drawn one after the other: a coarse one if a
/// full one would take too long, a full one, then a refined one.
struct ViewProgress {
    enum class Stage { Coarse, Full, Refine, Done };

    FrameRequest request;
    Stage stage = Stage::Done;
    int sample = 0; ///< which of the summed pictures of stage Refine is drawn
    std::optional<TilePlan> tiles; ///< tiles of the picture being drawn; none if it has not begun
    bool stale = false; ///< the content changed while its coarse picture was drawn
    /// The request that begins once the coarse picture under way is finished; none: no newer one.
    std::optional<FrameRequest> awaited;
    bool failed = false; ///< its last picture did
    double milliseconds = 0.0;
    std::optional<core::Trace::Clock::time_point> begun; ///< when the picture being drawn was
    std::optional<core::TraceLane> lane; ///< of its pictures, if a trace is on
    std::uint64_t turn = 0; ///< the turn in which it was last drawn
    FrameTargets targets;
    ViewPictures pictures; ///< of the picture being drawn

    /// The view shows something else: starts again with the first picture.
    void restart();
    /// The content has changed: starts again, but lets a coarse picture under way be finished
    /// first.
    void changed();
    /// After a failure: drops the picture under way and its textures, and draws nothing until the
    /// next request, be it the same.
    void giveUp();

    /// Whether a coarse picture has begun.
    [[nodiscard]] bool drawsCoarse() const { return stage == Stage::Coarse && tiles; }
    /// Whether there is a picture to draw now.
    /// @param editing edits are running; only coarse pictures are drawn meanwhile
    [[nodiscard]] bool wants(bool editing) const;
    /// Whether this view is drawn before another that also wants to.
    /// @param now the present turn
    [[nodiscard]] bool comesBefore(const ViewProgress& other, std::uint64_t now) const;

    /// If more pictures are to be added to the sum, goes on to the next of them and returns true.
    [[nodiscard]] bool goesOnToNextSample();
    /// Goes on to the next stage.
    /// @param drawn size in pixels of the picture that is ready
    /// @return the quality of that picture
    [[nodiscard]] Frame::Quality finishStage(const glm::ivec2& drawn);

private:
    [[nodiscard]] bool isOverdue(std::uint64_t now) const;
    [[nodiscard]] bool isFlat() const;
};

} // namespace gpu
