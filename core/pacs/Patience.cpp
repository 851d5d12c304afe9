// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/Patience.h"

namespace core {

Patience::Patience(Seconds timeout, Seconds whole, Clock::time_point now)
    : m_timeout(timeout)
    , m_most(whole)
    , m_begin(now)
    , m_sign(now)
    , m_whole(now)
{
}

void Patience::passed(std::int64_t bytes, Clock::time_point now)
{
    const std::lock_guard lock(m_mutex);
    m_sign = now;
    m_bytes += bytes;
}

void Patience::whole(Clock::time_point now)
{
    const std::lock_guard lock(m_mutex);
    m_sign = now;
    m_whole = now;
    m_bytes = 0;
}

Patience::Lost Patience::lost(Clock::time_point now) const
{
    constexpr std::int64_t bytesASecond = 1024;
    const std::lock_guard lock(m_mutex);
    if (now - m_sign >= m_timeout)
        return Lost::Silence;
    if (now - m_whole >= m_timeout + Seconds(m_bytes / bytesASecond))
        return Lost::Dripping;
    return m_most > Seconds::zero() && now - m_begin >= m_most ? Lost::Whole : Lost::No;
}

Patience::Clock::time_point Patience::lastSign() const
{
    const std::lock_guard lock(m_mutex);
    return m_sign;
}

Error Patience::error(const QString& nodeName, Lost how) const
{
    const Seconds limit = how == Lost::Whole ? m_most : m_timeout;
    Error error{ErrorCode::NodeTimeout, {nodeName, QString::number(limit.count())}};
    if (how == Lost::Dripping)
        error.arguments += Clause::saying("it says less than a KiB a second");
    else if (how == Lost::Whole)
        error.arguments += Clause::saying("its answer has not come to an end");
    return error;
}

} // namespace core
