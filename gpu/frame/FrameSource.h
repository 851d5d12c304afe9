// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SurfaceUpdate.h"
#include "gpu/scene/Scene.h"

#include <functional>

namespace gpu {

/// Pictures on demand. A view asks; finished frames come to the listener, first a coarse one, then
/// a full one, then a refined (anti-aliased) one. While nothing changes nothing is drawn; when an
/// edit changes voxels, the last request of every affected view is drawn again by itself. What the
/// GPU refuses to draw comes as a frame with a failure, once.
class FrameSource {
public:
    using Listener = std::function<void(const Frame&)>;

    virtual ~FrameSource() = default;

    /// Replaces the view's request. Never waits.
    virtual void request(FrameRequest request) = 0;
    /// The view is gone; no frame of it follows after this returns.
    virtual void forget(ViewId view) = 0;
    /// Called on the engine's thread; set it before the first request.
    virtual void setListener(Listener listener) = 0;
    /// Tells what to draw anew of the one surface that is being refined; scenes say whether they
    /// show it. What was not taken in yet is merged with it. The views that see a change are drawn
    /// again. It stays, whatever volume is open, until a whole update without faces. Never waits
    /// for a picture; any thread.
    virtual void updateSurface(core::SurfaceUpdate update) = 0;
};

} // namespace gpu
