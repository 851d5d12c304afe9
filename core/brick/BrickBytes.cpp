// SPDX-License-Identifier: Apache-2.0
#include "core/brick/BrickBytes.h"

#include "core/brick/ThreadWithoutVoxels.h"

#include <atomic>
#include <utility>

namespace core {

namespace {

/// Whoever let go of the bytes last, on whichever thread, has read them before they are written.
void orderAfterReaders([[maybe_unused]] const std::shared_ptr<std::vector<std::uint8_t>>& bytes)
{
    std::atomic_thread_fence(std::memory_order_acquire);
#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
    // The sanitizer knows no fences: one owner more, for a moment, orders the same for it.
    const std::shared_ptr<std::vector<std::uint8_t>> owner = bytes;
#endif
#endif
}

} // namespace

BrickBytes::BrickBytes(std::vector<std::uint8_t> bytes)
{
    if (!bytes.empty())
        m_bytes = std::make_shared<std::vector<std::uint8_t>>(std::move(bytes));
}

const std::vector<std::uint8_t>& BrickBytes::read() const
{
    static const std::vector<std::uint8_t> none;
    noteVoxelsLookedAt();
    return m_bytes ? *m_bytes : none;
}

std::vector<std::uint8_t>& BrickBytes::write()
{
    noteVoxelsLookedAt();
    if (!m_bytes)
        m_bytes = std::make_shared<std::vector<std::uint8_t>>();
    else if (m_bytes.use_count() > 1)
        m_bytes = std::make_shared<std::vector<std::uint8_t>>(*m_bytes);
    else
        orderAfterReaders(m_bytes);
    return *m_bytes;
}

bool operator==(const BrickBytes& one, const BrickBytes& other)
{
    return one.m_bytes == other.m_bytes || one.read() == other.read();
}

} // namespace core
