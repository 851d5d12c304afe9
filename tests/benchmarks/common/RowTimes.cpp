// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/common/RowTimes.h"

#include <utility>

namespace bench {

namespace {

RowTimes::Clock::duration lasting(double milliseconds)
{
    return std::chrono::duration_cast<RowTimes::Clock::duration>(
        std::chrono::duration<double, std::milli>(milliseconds));
}

} // namespace

bool RowTimes::s_on = false;
std::map<std::string, RowTimes::Row> RowTimes::s_rows;

void RowTimes::begin()
{
    s_on = true;
    s_rows.clear();
}

void RowTimes::took(const std::string& id, Clock::time_point begin, double milliseconds)
{
    if (s_on)
        s_rows[id].turns.push_back({.begin = begin, .end = begin + lasting(milliseconds)});
}

void RowTimes::ended(const std::string& id, double milliseconds)
{
    took(id, Clock::now() - lasting(milliseconds), milliseconds);
}

void RowTimes::moves(const std::string& id, double bytes, const char* what)
{
    if (!s_on)
        return;
    s_rows[id].bytes = bytes;
    s_rows[id].what = what;
}

std::map<std::string, RowTimes::Row> RowTimes::take()
{
    s_on = false;
    return std::exchange(s_rows, {});
}

} // namespace bench
