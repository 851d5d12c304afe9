// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/engine/GpuEngine.h"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <vector>

namespace bench {

/// The pictures that an engine hands out, as the views of a window receive them: tells how long
/// after something was done they show it.
class WatchedViews {
public:
    /// @param engine outlives the views, and has no other listener meanwhile
    explicit WatchedViews(gpu::GpuEngine& engine);
    ~WatchedViews();
    WatchedViews(const WatchedViews&) = delete;
    WatchedViews& operator=(const WatchedViews&) = delete;

    /// @param poll called while this waits, after each wake(); none: never
    void setPoll(std::function<void()> poll) { m_poll = std::move(poll); }
    void wake(); ///< any thread

    /// What a view shows from now on.
    void show(const gpu::FrameRequest& request);
    /// Waits until the pictures of all views are as they stay.
    /// @param quiet the first picture after a change is there sooner
    void rest(std::chrono::milliseconds quiet = std::chrono::milliseconds(300));
    /// Milliseconds from the beginning of what is done until each of these views has a new picture;
    /// none if that takes longer than @p patience, since nothing that they show has changed. Call
    /// it at rest.
    [[nodiscard]] std::optional<double> untilSeen(const std::function<void()>& done,
        const std::vector<gpu::ViewId>& views,
        std::chrono::milliseconds patience = std::chrono::seconds(60));
    /// The last picture of a view.
    [[nodiscard]] gpu::Frame latest(gpu::ViewId view);

private:
    using Clock = std::chrono::steady_clock;
    void arrived(const gpu::Frame& frame);
    [[nodiscard]] bool allFinal() const; ///< m_guard is held
    void pollIfWoken(std::unique_lock<std::mutex>& lock);

    gpu::FrameSource& m_frames;
    std::function<void()> m_poll;
    std::mutex m_guard; ///< of all below
    std::condition_variable m_changed;
    std::map<gpu::ViewId, bool> m_moving; ///< whether so the view was requested
    std::map<gpu::ViewId, gpu::Frame> m_latest;
    std::set<gpu::ViewId> m_awaited;
    Clock::time_point m_lastSeen; ///< of those that were awaited
    bool m_arrived = false;
    bool m_woken = false;
};

} // namespace bench
