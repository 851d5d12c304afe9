// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>

#include <vector>

namespace test {

/// A complete event of a trace (core/base/trace/Trace.h).
struct TraceEvent {
    QString category;
    QString name;
    QString detail;
    QString lane;
    qint64 begin = 0; ///< nanoseconds
    qint64 end = 0;
    qint64 waitedMicroseconds = -1;
};

/// The events of a trace by lanes, those that begin first before others, and what holds another
/// before that; none if it is no trace.
[[nodiscard]] std::vector<TraceEvent> traceEvents(const QByteArray& json);

/// Two events of one lane of which neither holds the other, but which overlap; empty if there are
/// none.
[[nodiscard]] QString overlapIn(const std::vector<TraceEvent>& events);

/// Nanoseconds of all events of a category whose name begins so.
[[nodiscard]] qint64 timeIn(
    const std::vector<TraceEvent>& events, const char* category, const char* name = "");

} // namespace test
