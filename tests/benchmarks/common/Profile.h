// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/common/RowTimes.h"

#include <QJsonArray>
#include <QString>

namespace bench {

/// Where the time of figures goes: during their turns the program's own trace (core::Trace) tells
/// which kernels and draws the graphics processor worked at. As the stamps of a trace cost time,
/// the figures themselves come from a run without.
class Profile {
public:
    /// The trace is on, and turns are noted, from now on; an engine that is to be in it is made
    /// later.
    void begin();
    /// Adds the rows whose turns were noted since begin().
    void end();
    /// Writes {"triadBytesPerSecond","copyBytesPerSecond","rows":[{"id","turns","milliseconds",
    /// "bytes","moved","passes":[{"kind","name","milliseconds"}]}]}; milliseconds and bytes of a
    /// turn.
    [[nodiscard]] bool write(const QString& file) const;

private:
    RowTimes::Clock::time_point m_begin;
    QJsonArray m_rows;
};

} // namespace bench
