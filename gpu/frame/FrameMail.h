// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/frame/FrameSource.h"

#include <map>
#include <mutex>
#include <set>

namespace gpu {

/// The exchange between the views and the thread that draws: requests go in, finished frames go
/// out. Any thread. The listener is called on the thread that calls hand().
class FrameMail {
public:
    struct Incoming {
        FrameRequest request;
        /// The view was forgotten before this request: its earlier pictures do not count.
        bool fresh = false;
    };
    struct Letters {
        std::map<ViewId, Incoming> requests; ///< the latest one of each view
        std::set<ViewId> forgotten; ///< and without a request since
    };

    void request(FrameRequest request);
    /// After this returns no frame of the view is handed out but those of its later requests.
    void forget(ViewId view);
    void setListener(FrameSource::Listener listener);

    [[nodiscard]] Letters take();
    void hand(const Frame& frame);

private:
    std::mutex m_inboxMutex;
    Letters m_inbox; ///< guarded by m_inboxMutex
    std::mutex m_listenerMutex; ///< held while the listener runs
    FrameSource::Listener m_listener; ///< guarded by m_listenerMutex
};

} // namespace gpu
