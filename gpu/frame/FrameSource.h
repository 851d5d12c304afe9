// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SurfaceUpdate.h"
#include "gpu/scene/Scene.h"

#include <functional>

namespace gpu {

/// Draws pictures on request. A view requests one; finished frames come to the listener, first a
/// coarse one, then a full one, then a refined (anti-aliased) one. While nothing changes nothing is
/// drawn. When an edit changes voxels, the last request of every affected view is drawn again
/// without a new request. If the GPU refuses to draw, one frame with a failure is delivered,
/// and the same request may be made again.
class FrameSource {
public:
    using Listener = std::function<void(const Frame&)>;

    virtual ~FrameSource() = default;

    /// Replaces the request of the view. Never waits.
    virtual void request(FrameRequest request) = 0;
    /// Forgets a view; no frame of it is delivered after this returns.
    virtual void forget(ViewId view) = 0;
    /// Sets the function that receives frames. It is called on the engine thread; set it before the
    /// first request.
    virtual void setListener(Listener listener) = 0;
    /// Sends what has changed of the one surface that is being refined; scenes say whether they
    /// show it. Updates that were not taken yet are merged. The views that see a change are drawn
    /// again. The surface stays, whatever volume is open, until a complete update without faces.
    /// Never waits for a picture; any thread.
    virtual void updateSurface(core::SurfaceUpdate update) = 0;
};

} // namespace gpu
