// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/common/WatchedViews.h"

#include <algorithm>
#include <utility>

namespace bench {

WatchedViews::WatchedViews(gpu::GpuEngine& engine)
    : m_frames(engine.frames())
{
    m_frames.setListener([this](const gpu::Frame& frame) { arrived(frame); });
}

WatchedViews::~WatchedViews()
{
    for (const auto& [view, moving] : m_moving)
        m_frames.forget(view);
    m_frames.setListener({});
}

void WatchedViews::wake()
{
    const std::lock_guard lock(m_guard);
    m_woken = true;
    m_changed.notify_all();
}

void WatchedViews::show(const gpu::FrameRequest& request)
{
    {
        const std::lock_guard lock(m_guard);
        m_moving[request.view] = request.interacting;
    }
    m_frames.request(request);
}

void WatchedViews::arrived(const gpu::Frame& frame)
{
    const std::lock_guard lock(m_guard);
    m_latest[frame.view] = frame;
    m_arrived = true;
    if (m_awaited.erase(frame.view) > 0)
        m_lastSeen = Clock::now();
    m_changed.notify_all();
}

bool WatchedViews::allFinal() const
{
    return std::all_of(m_moving.begin(), m_moving.end(), [this](const auto& shown) {
        const auto frame = m_latest.find(shown.first);
        return frame != m_latest.end()
            && (shown.second || frame->second.quality == gpu::Frame::Quality::Refined);
    });
}

void WatchedViews::pollIfWoken(std::unique_lock<std::mutex>& lock)
{
    if (!std::exchange(m_woken, false) || !m_poll)
        return;
    lock.unlock();
    m_poll();
    lock.lock();
}

void WatchedViews::rest(std::chrono::milliseconds quiet)
{
    std::unique_lock lock(m_guard);
    for (bool still = false; !still;) {
        still =
            !m_changed.wait_for(lock, quiet, [this] { return m_arrived || m_woken; }) && allFinal();
        m_arrived = false;
        pollIfWoken(lock);
    }
}

std::optional<double> WatchedViews::untilSeen(const std::function<void()>& done,
    const std::vector<gpu::ViewId>& views, std::chrono::milliseconds patience)
{
    std::unique_lock lock(m_guard);
    m_awaited = std::set<gpu::ViewId>(views.begin(), views.end());
    lock.unlock();
    const Clock::time_point start = Clock::now();
    done();
    lock.lock();
    while (!m_awaited.empty()) {
        const bool news = m_changed.wait_until(
            lock, start + patience, [this] { return m_awaited.empty() || m_woken; });
        if (!news) {
            m_awaited.clear();
            return std::nullopt;
        }
        pollIfWoken(lock);
    }
    return std::chrono::duration<double, std::milli>(m_lastSeen - start).count();
}

gpu::Frame WatchedViews::latest(gpu::ViewId view)
{
    const std::lock_guard lock(m_guard);
    return m_latest[view];
}

} // namespace bench
