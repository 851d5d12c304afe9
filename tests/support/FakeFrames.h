// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/frame/FrameSource.h"

#include <map>
#include <vector>

namespace test {

/// Pictures without a GPU, for tests of the window: each pixel's colour tells the LPS position it
/// shows, so that a picture can be read back. Delivers a coarse and then a refined frame at once.
class FakeFrames : public gpu::FrameSource {
public:
    /// Red, green and blue are x, y and z, one step per millimetre, 128 at the origin.
    [[nodiscard]] static glm::ivec3 colourAt(const glm::dvec3& lps);

    void request(gpu::FrameRequest request) override;
    void forget(gpu::ViewId view) override;
    void setListener(Listener listener) override;
    void updateSurface(core::SurfaceUpdate update) override;

    [[nodiscard]] int requestCount() const { return m_requestCount; }
    [[nodiscard]] const gpu::FrameRequest& lastRequest(gpu::ViewId view) const;
    /// Those of the surface that were told, in their order.
    [[nodiscard]] const std::vector<core::SurfaceUpdate>& surfaceUpdates() const
    {
        return m_surfaceUpdates;
    }

private:
    void deliver(const gpu::FrameRequest& request, gpu::Frame::Quality quality) const;

    Listener m_listener;
    std::map<gpu::ViewId, gpu::FrameRequest> m_requests;
    std::vector<core::SurfaceUpdate> m_surfaceUpdates;
    int m_requestCount = 0;
};

} // namespace test
