// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

namespace bench {

/// When the times of figures were taken, and what these have to move, for the profile of a run
/// (Profile.h). Nothing is noted before begin(). From the thread that measures.
class RowTimes {
public:
    using Clock = std::chrono::steady_clock;
    struct Turn {
        Clock::time_point begin;
        Clock::time_point end;
    };
    struct Row {
        std::vector<Turn> turns;
        double bytes = 0.0; ///< of a turn; 0: nobody has said it
        std::string what; ///< that the bytes are
    };

    static void begin();
    /// A turn of the figure began then and took so long.
    static void took(const std::string& id, Clock::time_point begin, double milliseconds);
    /// It has just ended.
    static void ended(const std::string& id, double milliseconds);
    /// What a turn reads and writes, by estimate: its input once and its output once.
    static void moves(const std::string& id, double bytes, const char* what);
    /// What was noted since begin(); then nothing is noted any more.
    [[nodiscard]] static std::map<std::string, Row> take();

private:
    static bool s_on;
    static std::map<std::string, Row> s_rows;
};

} // namespace bench
