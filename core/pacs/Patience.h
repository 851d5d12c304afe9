// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QString>

#include <chrono>
#include <cstdint>
#include <mutex>

namespace core {

/// Answers to one question: no series has so many objects, and a list that is longer has no end.
constexpr int mostAnswers = 100'000;

/// How long another machine is waited for. It has lost it
///  - in silence: nothing went to or fro for as long as the timeout;
///  - by dripping: since the last whole thing (a message, an object) more time went by than the
///    timeout and one second for each KiB that went to or fro. So a large object may take as long
///    as it likes on a slow line, and a byte a second is given up as soon as silence is;
///  - by the whole: since the beginning, where there is such a limit. Questions have one, since an
///    endless answer to them is none.
/// Any thread may call.
class Patience {
public:
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::seconds;
    enum class Lost { No, Silence, Dripping, Whole };

    /// @param whole none: zero
    explicit Patience(Seconds timeout, Seconds whole = {}, Clock::time_point now = Clock::now());

    void passed(std::int64_t bytes, Clock::time_point now = Clock::now());
    void whole(Clock::time_point now = Clock::now());

    [[nodiscard]] Lost lost(Clock::time_point now = Clock::now()) const;
    /// NodeTimeout, of the machine of that name.
    [[nodiscard]] Error error(const QString& nodeName, Lost how) const;

    /// How long a question may take, answers and all, where one sign of life may take so long.
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
    Clock::time_point m_sign; ///< the last one of life; under m_mutex, as all that follow
    Clock::time_point m_whole; ///< the last whole thing
    std::int64_t m_bytes = 0; ///< since then
};

} // namespace core
