// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/TraceEvents.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMap>

#include <algorithm>
#include <tuple>

namespace test {

namespace {

qint64 nanoseconds(const QJsonValue& microseconds)
{
    return qRound64(microseconds.toDouble() * 1000.0);
}

} // namespace

std::vector<TraceEvent> traceEvents(const QByteArray& json)
{
    const QJsonArray lines = QJsonDocument::fromJson(json).array();
    QMap<int, QString> lanes;
    std::vector<TraceEvent> events;
    for (const QJsonValue& line : lines) {
        const QString phase = line[QLatin1String("ph")].toString();
        const int lane = line[QLatin1String("tid")].toInt(-1);
        const QJsonValue arguments = line[QLatin1String("args")];
        if (phase == QLatin1String("M")) {
            if (line[QLatin1String("name")] == QLatin1String("thread_name"))
                lanes[lane] = QString::number(lane) + QLatin1Char(' ')
                    + arguments[QLatin1String("name")].toString();
            continue;
        }
        if (phase != QLatin1String("X") || !lanes.contains(lane))
            return {};
        TraceEvent event{.category = line[QLatin1String("cat")].toString(),
            .name = line[QLatin1String("name")].toString(),
            .detail = arguments[QLatin1String("of")].toString(),
            .lane = lanes[lane],
            .begin = nanoseconds(line[QLatin1String("ts")])};
        event.end = event.begin + nanoseconds(line[QLatin1String("dur")]);
        event.waitedMicroseconds = arguments[QLatin1String("waitedMicroseconds")].toInteger(-1);
        events.push_back(event);
    }
    std::stable_sort(events.begin(), events.end(), [](const TraceEvent& a, const TraceEvent& b) {
        return std::tuple(a.lane, a.begin, -a.end) < std::tuple(b.lane, b.begin, -b.end);
    });
    return events;
}

QString overlapIn(const std::vector<TraceEvent>& events)
{
    std::vector<const TraceEvent*> around;
    for (const TraceEvent& event : events) {
        while (!around.empty()
            && (around.back()->lane != event.lane || around.back()->end <= event.begin))
            around.pop_back();
        if (!around.empty() && event.end > around.back()->end)
            return QStringLiteral("%1: %2 (%3 to %4) and %5 (%6 to %7)")
                .arg(event.lane, around.back()->name)
                .arg(around.back()->begin)
                .arg(around.back()->end)
                .arg(event.name)
                .arg(event.begin)
                .arg(event.end);
        around.push_back(&event);
    }
    return {};
}

qint64 timeIn(const std::vector<TraceEvent>& events, const char* category, const char* name)
{
    qint64 sum = 0;
    for (const TraceEvent& event : events) {
        if (event.category == QLatin1String(category) && event.name.startsWith(QLatin1String(name)))
            sum += event.end - event.begin;
    }
    return sum;
}

} // namespace test
