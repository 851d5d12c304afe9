// SPDX-License-Identifier: Apache-2.0
#include "gpu/frame/FrameMail.h"

#include <utility>

namespace gpu {

void FrameMail::request(FrameRequest request)
{
    const std::lock_guard lock(m_inboxMutex);
    const ViewId view = request.view;
    auto& requests = m_inbox.requests;
    const bool fresh =
        m_inbox.forgotten.erase(view) > 0 || (requests.contains(view) && requests[view].fresh);
    requests.insert_or_assign(view, Incoming{std::move(request), fresh});
}

void FrameMail::forget(ViewId view)
{
    {
        const std::lock_guard lock(m_inboxMutex);
        m_inbox.requests.erase(view);
        m_inbox.forgotten.insert(view);
    }
    // Whoever delivers looks at what is forgotten under this lock: after it nothing follows.
    const std::lock_guard wait(m_listenerMutex);
}

void FrameMail::setListener(FrameSource::Listener listener)
{
    const std::lock_guard lock(m_listenerMutex);
    m_listener = std::move(listener);
}

FrameMail::Letters FrameMail::take()
{
    const std::lock_guard lock(m_inboxMutex);
    return {.requests = std::exchange(m_inbox.requests, {}), .forgotten = m_inbox.forgotten};
}

void FrameMail::hand(const Frame& frame)
{
    const std::lock_guard listening(m_listenerMutex);
    bool wanted = true;
    {
        const std::lock_guard lock(m_inboxMutex);
        // Of a view that asks again what is handed out here was begun before it was forgotten.
        const auto waiting = m_inbox.requests.find(frame.view);
        const bool asksAgain = waiting != m_inbox.requests.end() && waiting->second.fresh;
        wanted = !asksAgain && !m_inbox.forgotten.contains(frame.view);
    }
    if (wanted && m_listener)
        m_listener(frame);
}

} // namespace gpu
