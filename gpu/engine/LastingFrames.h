// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/frame/FrameSource.h"

#include <mutex>

namespace gpu {

/// A frame source that lasts when the engine thread is replaced (GpuEngine::renew()): views keep
/// this one while the source behind it changes. After a change views have to repeat their requests.
/// Any thread.
class LastingFrames final : public FrameSource {
public:
    /// Forwards all calls to @p source, which must outlive this object or its next setSource().
    /// When this returns no call to the previous source is running. With null, requests are
    /// dropped.
    void setSource(FrameSource* source);

    void request(FrameRequest request) override;
    void forget(ViewId view) override;
    void setListener(Listener listener) override;
    void updateSurface(core::SurfaceUpdate update) override;

private:
    std::mutex m_mutex; ///< never locked by the listener
    FrameSource* m_source = nullptr; ///< guarded by m_mutex
    Listener m_listener; ///< guarded by m_mutex
};

} // namespace gpu
