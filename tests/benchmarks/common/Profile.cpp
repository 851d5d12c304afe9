// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/common/Profile.h"

#include "core/base/trace/Trace.h"
#include "tests/benchmarks/common/Bandwidth.h"
#include "tests/support/program/TraceEvents.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace bench {

namespace {

/// By kind ("gpu": a kernel or draw; "task": work beside the caller) and name.
using Passes = std::map<std::pair<QString, QString>, double>;

/// @param begin of the trace
Passes passesDuring(const RowTimes::Row& row, const std::vector<test::TraceEvent>& events,
    RowTimes::Clock::time_point begin)
{
    const auto nanoseconds = [begin](RowTimes::Clock::time_point time) {
        return std::chrono::duration_cast<std::chrono::nanoseconds>(time - begin).count();
    };
    Passes passes;
    for (const RowTimes::Turn& turn : row.turns) {
        const qint64 from = nanoseconds(turn.begin);
        const qint64 until = nanoseconds(turn.end);
        for (const test::TraceEvent& event : events) {
            const qint64 both = std::min(until, event.end) - std::max(from, event.begin);
            const bool counts =
                event.category == QLatin1String("gpu") || event.category == QLatin1String("task");
            if (counts && both > 0)
                passes[{event.category, event.name}] +=
                    1e-6 * double(both) / double(row.turns.size());
        }
    }
    return passes;
}

double millisecondsOf(const RowTimes::Row& row)
{
    double sum = 0.0;
    for (const RowTimes::Turn& turn : row.turns)
        sum += std::chrono::duration<double, std::milli>(turn.end - turn.begin).count();
    return sum / double(row.turns.size());
}

} // namespace

void Profile::begin()
{
    RowTimes::begin();
    m_begin = RowTimes::Clock::now();
    core::Trace::begin();
}

void Profile::end()
{
    const std::string trace = core::Trace::end();
    const std::vector<test::TraceEvent> events =
        test::traceEvents(QByteArray::fromRawData(trace.data(), qsizetype(trace.size())));
    for (const auto& [id, row] : RowTimes::take()) {
        if (row.turns.empty())
            continue;
        QJsonArray passes;
        for (const auto& [pass, milliseconds] : passesDuring(row, events, m_begin))
            passes += QJsonObject{{QStringLiteral("kind"), pass.first},
                {QStringLiteral("name"), pass.second},
                {QStringLiteral("milliseconds"), milliseconds}};
        m_rows += QJsonObject{{QStringLiteral("id"), QString::fromStdString(id)},
            {QStringLiteral("turns"), int(row.turns.size())},
            {QStringLiteral("milliseconds"), millisecondsOf(row)},
            {QStringLiteral("bytes"), row.bytes},
            {QStringLiteral("moved"), QString::fromStdString(row.what)},
            {QStringLiteral("passes"), passes}};
    }
}

bool Profile::write(const QString& file) const
{
    const Bandwidth memory = measuredBandwidth();
    const QJsonObject all{{QStringLiteral("triadBytesPerSecond"), memory.triad},
        {QStringLiteral("copyBytesPerSecond"), memory.copy}, {QStringLiteral("rows"), m_rows}};
    const QByteArray text = QJsonDocument(all).toJson();
    QFile out(file);
    return out.open(QIODevice::WriteOnly) && out.write(text) == text.size();
}

} // namespace bench
