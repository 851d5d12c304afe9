// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QString>

#include <chrono>
#include <cstdint>
#include <mutex>

namespace core {

/// Limit for the answers to one query: no series has so many objects, so a longer list is taken for
/// an endless one.
constexpr int mostAnswers = 100'000;

/// Decides when to stop waiting for another machine. There are three limits:
///  - silence: nothing was transferred in either direction for the duration of the timeout;
///  - dripping: since the last complete message or object, more time has passed than the timeout
///    plus one second for each KiB transferred. So a large object may take any time on a slow line,
///    while one byte per second is given up as soon as silence is;
///  - whole: the total time, if there is such a limit. Queries have one, to end endless answers.
/// Any thread may call.
class Patience {
public:
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::seconds;
    enum class Lost { No, Silence, Dripping, Whole };

    /// @param whole zero: no limit
    explicit Patience(Seconds timeout, Seconds whole = {}, Clock::time_point now = Clock::now());

    void passed(std::int64_t bytes, Clock::time_point now = Clock::now());
    void whole(Clock::time_point now = Clock::now());

    [[nodiscard]] Lost lost(Clock::time_point now = Clock::now()) const;
    /// When something was transferred last; silence counts from there.
    [[nodiscard]] Clock::time_point lastSign() const;
    /// The error NodeTimeout for the machine of that name.
    [[nodiscard]] Error error(const QString& nodeName, Lost how) const;

    /// The limit for a whole query, derived from the timeout.
    [[nodiscard]] static Seconds ofQuestion(int timeoutSeconds)
    {
        constexpr int often = 10;
        return Seconds(often * std::int64_t(timeoutSeconds));
    }

private:
    Seconds m_timeout;
    Seconds m_most;
    Clock::time_point m_begin;
    mutable std::mutex m_mutex;
    Clock::time_point m_sign; ///< the last transfer; under m_mutex, as all that follow
    Clock::time_point m_whole; ///< the last complete message or object
    std::int64_t m_bytes = 0; ///< since then
};

} // namespace core
