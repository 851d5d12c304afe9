// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/frame/FrameMail.h"
#include "gpu/frame/ViewProgress.h"
#include "gpu/gl/Fence.h"

#include <map>

namespace gpu {

class VolumeTextures;

/// Pictures on their way from the GPU, at most one per view, until they are handed out. Engine
/// thread.
class FrameDelivery {
public:
    FrameDelivery(VolumeTextures& volume, FrameMail& mail);

    /// Reads the view's picture into its buffer: none may be on its way there.
    void send(ViewProgress& view, Frame::Quality quality);
    /// Waits until that of a view, if there is one, or the first of all is there.
    void await(ViewId view);
    void awaitFirst();
    /// Hands out what is there. @return how many
    int deliver(const std::map<ViewId, ViewProgress>& views);

    [[nodiscard]] bool empty() const { return m_sent.empty(); }
    [[nodiscard]] bool contains(ViewId view) const { return m_sent.contains(view); }
    void forget(ViewId view) { m_sent.erase(view); }
    void clear() { m_sent.clear(); }

private:
    struct Sent {
        Frame frame;
        Fence fence;
    };

    VolumeTextures& m_volume;
    FrameMail& m_mail;
    std::map<ViewId, Sent> m_sent;
};

} // namespace gpu
