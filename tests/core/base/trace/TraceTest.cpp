// SPDX-License-Identifier: Apache-2.0
#include "core/base/trace/Trace.h"

#include "core/base/Background.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/program/TraceEvents.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

#include <malloc.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace traceTest {

using namespace core;
using test::TraceEvent;

namespace {

std::vector<TraceEvent> ended()
{
    return test::traceEvents(QByteArray::fromStdString(Trace::end()));
}

} // namespace

/// What a run of the program tells of itself.
class TraceTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void nothingIsRecordedWhileItIsOff();
    void spansNestOnTheLaneOfTheirThread();
    void whatIsTooShortIsLeftOut();
    void whatIsTooMuchIsCounted();
    void lanesAreContinued();
    void tasksAreNamedAfterWhoStartsThem();
};

void TraceTest::nothingIsRecordedWhileItIsOff()
{
    QVERIFY(!Trace::isOn());
    const std::size_t before = mallinfo2().uordblks;
    for (int i = 0; i < 10'000; ++i) {
        const TraceSpan span("test", "span", {.detail = TraceName(typeid(int))});
        Trace::add({.category = "test", .name = "event", .begin = {}, .end = {}});
    }
    const std::size_t after = mallinfo2().uordblks;
    QCOMPARE(after, before);
    Trace::begin();
    {
        const TraceSpan first("test", "first");
    }
    const std::vector<TraceEvent> events = ended();
    QCOMPARE(events.size(), std::size_t(1));
    QVERIFY(!Trace::isOn());
    // Nor is what was recorded once there again.
    Trace::begin();
    QVERIFY(ended().empty());
}

void TraceTest::spansNestOnTheLaneOfTheirThread()
{
    Trace::begin();
    {
        const TraceSpan outer("a \"word\"", "outer", {.waitedMicroseconds = 12});
        for (int i = 0; i < 3; ++i)
            const TraceSpan inner("test", "inner", {.detail = TraceName(typeid(TraceTest))});
        std::thread other([] {
            Trace::nameThread("other");
            const TraceSpan span("test", "elsewhere");
        });
        other.join();
    }
    const std::vector<TraceEvent> events = ended();
    QCOMPARE(events.size(), std::size_t(5));
    QVERIFY2(test::overlapIn(events).isEmpty(), qPrintable(test::overlapIn(events)));
    int inner = 0;
    QString mainLane;
    for (const TraceEvent& event : events) {
        QVERIFY(event.begin >= 0 && event.end >= event.begin);
        if (event.name == QLatin1String("elsewhere")) {
            QVERIFY(event.lane.endsWith(QLatin1String(" other")));
            continue;
        }
        QVERIFY(event.lane.endsWith(QLatin1String(" main")));
        QVERIFY(mainLane.isEmpty() || mainLane == event.lane);
        mainLane = event.lane;
        if (event.name == QLatin1String("outer")) {
            QCOMPARE(event.category, QStringLiteral("a \"word\""));
            QCOMPARE(event.waitedMicroseconds, qint64(12));
            QVERIFY(event.detail.isEmpty());
        } else {
            ++inner;
            QCOMPARE(event.detail, QStringLiteral("traceTest::TraceTest"));
            QCOMPARE(event.waitedMicroseconds, qint64(-1));
        }
    }
    QCOMPARE(inner, 3);
    // What overlaps is found.
    const std::vector<TraceEvent> crossed{{.category = {},
                                              .name = {},
                                              .detail = {},
                                              .lane = QStringLiteral("a"),
                                              .begin = 0,
                                              .end = 5},
        {.category = {},
            .name = {},
            .detail = {},
            .lane = QStringLiteral("a"),
            .begin = 3,
            .end = 6}};
    QVERIFY(!test::overlapIn(crossed).isEmpty());
}

void TraceTest::whatIsTooShortIsLeftOut()
{
    Trace::begin();
    {
        const TraceSpan instant("test", "short", {.least = std::chrono::hours(1)});
        const TraceSpan longer("test", "long", {.least = std::chrono::milliseconds(1)});
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    const std::vector<TraceEvent> events = ended();
    QCOMPARE(events.size(), std::size_t(1));
    QCOMPARE(events.front().name, QStringLiteral("long"));
    QVERIFY(events.front().end - events.front().begin >= 2'000'000);
}

void TraceTest::whatIsTooMuchIsCounted()
{
    Trace::begin(3);
    for (int i = 0; i < 10; ++i)
        const TraceSpan span("test", "span");
    const QByteArray json = QByteArray::fromStdString(Trace::end());
    QCOMPARE(test::traceEvents(json).size(), std::size_t(3));
    const QJsonArray lines = QJsonDocument::fromJson(json).array();
    const QJsonValue last = lines.last();
    QCOMPARE(last[QLatin1String("name")].toString(), QStringLiteral("events left out"));
    QCOMPARE(last[QLatin1String("args")][QLatin1String("count")].toInt(), 7);
}

/// Threads that come and go do not make the picture taller, those at the same time do.
void TraceTest::lanesAreContinued()
{
    const std::string name = "lanes that are continued";
    int first = 0;
    {
        const TraceLane lane(name);
        const TraceLane beside(name);
        first = lane.id();
        QVERIFY(beside.id() != first);
    }
    const TraceLane again(name);
    QCOMPARE(again.id(), first);
}

void TraceTest::tasksAreNamedAfterWhoStartsThem()
{
    Trace::begin();
    bool told = false;
    Background background;
    background.start(
        this, [] { std::this_thread::sleep_for(std::chrono::milliseconds(1)); },
        [&told](const Result<void>&) { told = true; });
    background.finish();
    QVERIFY(told);
    const std::vector<TraceEvent> events = ended();
    QCOMPARE(events.size(), std::size_t(1));
    QCOMPARE(events.front().category, QStringLiteral("task"));
    QCOMPARE(events.front().name,
        QStringLiteral("traceTest::TraceTest::tasksAreNamedAfterWhoStartsThem"));
    QVERIFY(events.front().lane.endsWith(QLatin1String(" tasks")));
    QVERIFY(events.front().end - events.front().begin >= 1'000'000);
}

BURIN_TEST(TraceTest)

} // namespace traceTest

#include "TraceTest.moc"
