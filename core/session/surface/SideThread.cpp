// SPDX-License-Identifier: Apache-2.0
#include "core/session/surface/SideThread.h"

#include <utility>

namespace core {

SideThread::SideThread(std::function<void()> wakeUp)
    : m_wakeUp(std::move(wakeUp))
{
}

void SideThread::post(Work work, Failed failed)
{
    if (!m_thread)
        m_thread = std::make_unique<TaskThread>();
    m_thread->post(
        [this, work = std::move(work)] {
            if (Sequel sequel = work())
                add(std::move(sequel));
        },
        [this, failed = std::move(failed)](const Error& error) {
            add([failed, error](SessionState& state) { failed(state, error); });
        });
}

void SideThread::add(Sequel sequel)
{
    {
        const std::lock_guard lock(m_mutex);
        m_sequels.push_back(std::move(sequel));
    }
    if (m_wakeUp)
        m_wakeUp();
}

std::vector<SideThread::Sequel> SideThread::collect()
{
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_sequels, {});
}

void SideThread::finish()
{
    if (m_thread)
        m_thread->finish();
}

} // namespace core
