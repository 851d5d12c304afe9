// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/frame/FrameSource.h"

#include <map>
#include <mutex>
#include <set>

namespace gpu {

/// Between views and the thread that draws: requests in, finished frames out. Any thread; what is
/// handed out reaches the listener on the thread that hands it.
class FrameMail {
public:
    struct Incoming {
        FrameRequest request;
        bool fresh = false; ///< forgotten before: nothing of the view's past counts
    };
    struct Letters {
        std::map<ViewId, Incoming> requests; ///< the latest per view
        std::set<ViewId> forgotten; ///< and not asked for since
    };

    void request(FrameRequest request);
    /// Once this returns nothing of the view is handed out until it is asked for again.
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
