// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>

#include <vector>

namespace test {

/// A complete event in a trace (core/base/trace/Trace.h).
struct TraceEvent {
    QString category;
    QString name;
    QString detail;
    QString lane;
    qint64 begin = 0; ///< nanoseconds
    qint64 end = 0;
    qint64 waitedMicroseconds = -1;
};

/// Returns the events of a trace by lane, sorted by their beginning; an event comes before those
/// that it contains. Empty if @p json is no trace.
[[nodiscard]] std::vector<TraceEvent> traceEvents(const QByteArray& json);

/// Returns two events of one lane that overlap although neither contains the other; empty if there
/// are none.
[[nodiscard]] QString overlapIn(const std::vector<TraceEvent>& events);

/// Returns the total time in nanoseconds of the events of a category whose names begin with @p
/// name.
[[nodiscard]] qint64 timeIn(
    const std::vector<TraceEvent>& events, const char* category, const char* name = "");

} // namespace test
