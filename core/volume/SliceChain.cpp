// SPDX-License-Identifier: Apache-2.0
#include "core/volume/SliceChain.h"

#include <utility>

namespace core {

SliceChain::SliceChain(int slices, std::function<void(int k)> work)
    : m_work(std::move(work))
    , m_there(std::size_t(slices))
{
}

void SliceChain::sliceIsThere(int k)
{
    m_there[std::size_t(k)] = true;
    const std::unique_lock lock(m_mutex, std::try_to_lock);
    if (lock)
        carryOn();
}

void SliceChain::finish()
{
    const std::lock_guard lock(m_mutex);
    carryOn();
}

void SliceChain::waitFor(int k) const
{
    for (int done = m_done; done <= k; done = m_done)
        m_done.wait(done);
}

void SliceChain::carryOn()
{
    for (int k = m_done; k < int(m_there.size()) && m_there[std::size_t(k)]; ++k) {
        m_work(k);
        m_done = k + 1;
        m_done.notify_all();
    }
}

} // namespace core
