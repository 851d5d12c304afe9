// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/frame/FrameSource.h"

#include <mutex>

namespace gpu {

/// The pictures of whichever engine thread there is: views keep this one while the source behind it
/// is made anew. What they had requested has to be requested again then. Any thread.
class LastingFrames final : public FrameSource {
public:
    /// Hands on to @p source, which outlives this or is replaced; no call is under way in the one
    /// before once this returns. Null: what is asked is dropped.
    void setSource(FrameSource* source);

    void request(FrameRequest request) override;
    void forget(ViewId view) override;
    void setListener(Listener listener) override;
    void updateSurface(core::SurfaceUpdate update) override;

private:
    std::mutex m_mutex; ///< never taken by who listens
    FrameSource* m_source = nullptr; ///< guarded by m_mutex
    Listener m_listener; ///< guarded by m_mutex
};

} // namespace gpu
