// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/WireWatch.h"

#include <utility>

#include <sys/socket.h>

namespace core {

WireWatch::WireWatch(int socket, const Progress* progress, std::shared_ptr<const Patience> patience)
    : m_socket(socket)
    , m_progress(progress)
    , m_patience(std::move(patience))
{
    m_thread.post([this] { work(); }, [](const Error&) {});
}

void WireWatch::end()
{
    {
        const std::lock_guard lock(m_mutex);
        m_ending = true;
    }
    m_changed.notify_all();
    m_thread.finish();
}

void WireWatch::work()
{
    constexpr std::chrono::milliseconds step(100);
    std::unique_lock lock(m_mutex);
    while (!m_ending) {
        m_changed.wait_for(lock, step, [this] { return m_ending; });
        if (m_ending)
            return;
        m_cancelled = m_progress && m_progress->cancelled();
        m_lost = m_patience->lost();
        if (m_cancelled || m_lost != Patience::Lost::No) {
            ::shutdown(m_socket, SHUT_RDWR);
            return;
        }
    }
}

} // namespace core
