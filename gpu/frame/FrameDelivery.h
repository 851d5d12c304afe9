// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/frame/FrameMail.h"
#include "gpu/frame/ViewProgress.h"
#include "gpu/gl/Fence.h"

#include <map>

namespace gpu {

class VolumeTextures;

/// Pictures that are being copied from the GPU to memory, at most one per view, until they are
/// handed to the listener. Engine thread.
class FrameDelivery {
public:
    FrameDelivery(VolumeTextures& volume, FrameMail& mail);

    /// Starts copying the view's picture into its buffer. No copy into that buffer may be under
    /// way.
    void send(ViewProgress& view, Frame::Quality quality);
    /// Waits until the picture of this view has arrived, if one is under way. awaitFirst() waits
    /// for one picture of any view.
    void await(ViewId view);
    void awaitFirst();
    /// Hands out the pictures that have arrived.
    /// @return how many
    int deliver(const std::map<ViewId, ViewProgress>& views);

    [[nodiscard]] bool empty() const { return m_sent.empty(); }
    [[nodiscard]] bool contains(ViewId view) const { return m_sent.contains(view); }
    void forget(ViewId view) { m_sent.erase(view); }
    void clear() { m_sent.clear(); }

private:
    struct Sent {
        Frame frame;
        Fence fence;
        core::Trace::Clock::time_point begun; ///< ViewProgress::begun
    };

    VolumeTextures& m_volume;
    FrameMail& m_mail;
    std::map<ViewId, Sent> m_sent;
};

} // namespace gpu
