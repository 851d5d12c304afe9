// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/stack/TimePoints.h"

#include "core/dicom/header/PhaseAttributes.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace timePointsTest {

using core::ImageHeader;
using core::SlicePlace;
using core::TimeAxis;

namespace {

/// Places of some images each, 3 mm apart; @p tell names or numbers them.
template <typename Tell> std::vector<SlicePlace> places(int count, int images, const Tell& tell)
{
    std::vector<SlicePlace> all;
    for (int place = 0; place < count; ++place) {
        SlicePlace& here = all.emplace_back(SlicePlace{.along = 3.0 * place});
        for (int index = 0; index < images; ++index) {
            ImageHeader image;
            image.file = QStringLiteral("%1-%2").arg(place).arg(index);
            image.position = glm::dvec3(0.0, 0.0, here.along);
            image.spacing = glm::dvec2(1.0, 1.0);
            image.phases.resize(core::phaseAttributeCount());
            tell(image, place, index);
            here.images.push_back(std::move(image));
        }
    }
    return all;
}

std::size_t attribute(const char* name)
{
    const QString wanted = QString::fromLatin1(name);
    for (std::size_t index = 0; index < core::phaseAttributeCount(); ++index) {
        if (core::phaseText(index, QString()).startsWith(wanted))
            return index;
    }
    qFatal("no such attribute");
}

QStringList labels(const TimeAxis& axis)
{
    QStringList all;
    for (const core::TimePoint& point : axis.points)
        all.append(point.label);
    return all;
}

QStringList files(const core::TimePoint& point)
{
    QStringList all;
    for (const ImageHeader& image : point.slices)
        all.append(image.file);
    return all;
}

} // namespace

/// Images that share their places: which attribute tells them apart, and how sure that is.
class TimePointsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void numbersAreSortedAsNumbers();
    void anAttributeMustTellEveryPlace();
    void twoAttributesTogether();
    void numbersThatRunAreCertain();
    void numbersThatDoNotRunAreDoubtful();
    void unequalPlacesAreNoTimeAxis();
    void imagesBesideEachOtherAreNoTimeAxis();
    void timesOfDayAreReadable();
};

void TimePointsTest::numbersAreSortedAsNumbers()
{
    const std::size_t trigger = attribute("trigger time");
    const QStringList times{QStringLiteral("1000"), QStringLiteral("80"), QStringLiteral("160")};
    const TimeAxis axis = core::findTimeAxis(places(
        2, 3, [&](ImageHeader& image, int, int index) { image.phases[trigger] = times[index]; }));
    QVERIFY(axis.complete);
    QVERIFY(axis.certain);
    QCOMPARE(labels(axis),
        (QStringList{QStringLiteral("trigger time 80 ms"), QStringLiteral("trigger time 160 ms"),
            QStringLiteral("trigger time 1000 ms")}));
    QCOMPARE(files(axis.points[0]), (QStringList{QStringLiteral("0-1"), QStringLiteral("1-1")}));
}

void TimePointsTest::anAttributeMustTellEveryPlace()
{
    const std::size_t trigger = attribute("trigger time");
    const std::size_t acquisition = attribute("acquisition");
    const TimeAxis axis =
        core::findTimeAxis(places(3, 2, [&](ImageHeader& image, int place, int index) {
            // Trigger times differ from slice to slice, as cardiac scans have them.
            image.phases[trigger] = QString::number(100 * place + index);
            image.phases[acquisition] = QString::number(7 - index);
            image.instanceNumber = 10 + index;
        }));
    // Numbers of acquisitions need not follow time: instance numbers order them.
    QCOMPARE(labels(axis),
        (QStringList{QStringLiteral("acquisition 7"), QStringLiteral("acquisition 6")}));
    QCOMPARE(files(axis.points[0]),
        (QStringList{QStringLiteral("0-0"), QStringLiteral("1-0"), QStringLiteral("2-0")}));
}

void TimePointsTest::twoAttributesTogether()
{
    const std::size_t echo = attribute("echo");
    const std::size_t bValue = attribute("b-value");
    const TimeAxis axis = core::findTimeAxis(places(2, 4, [&](ImageHeader& image, int, int index) {
        image.phases[echo] = QString::number(index % 2 + 1);
        image.phases[bValue] = QString::number(index / 2 * 800);
    }));
    QVERIFY(axis.complete);
    QVERIFY(axis.certain);
    QCOMPARE(labels(axis),
        (QStringList{QStringLiteral("echo 1, b-value 0 s/mm²"),
            QStringLiteral("echo 1, b-value 800 s/mm²"), QStringLiteral("echo 2, b-value 0 s/mm²"),
            QStringLiteral("echo 2, b-value 800 s/mm²")}));
}

void TimePointsTest::numbersThatRunAreCertain()
{
    const TimeAxis axis =
        core::findTimeAxis(places(4, 3, [](ImageHeader& image, int place, int index) {
            image.instanceNumber = 4 * (2 - index) + place + 1;
        }));
    QVERIFY(axis.complete);
    QVERIFY(axis.certain);
    QCOMPARE(labels(axis), (QStringList{QString(), QString(), QString()}));
    QCOMPARE(files(axis.points[0]).front(), QStringLiteral("0-2"));
}

void TimePointsTest::numbersThatDoNotRunAreDoubtful()
{
    const TimeAxis axis =
        core::findTimeAxis(places(4, 3, [](ImageHeader& image, int place, int index) {
            image.instanceNumber = 3 * place + index;
        }));
    QVERIFY(axis.complete);
    QVERIFY(!axis.certain);
}

void TimePointsTest::unequalPlacesAreNoTimeAxis()
{
    std::vector<SlicePlace> uneven =
        places(3, 2, [](ImageHeader& image, int, int index) { image.instanceNumber = index; });
    uneven[1].images.pop_back();
    const TimeAxis axis = core::findTimeAxis(std::move(uneven));
    QVERIFY(!axis.complete);
    QCOMPARE(axis.points.size(), std::size_t(2));
    QCOMPARE(axis.points[0].slices.size() + axis.points[1].slices.size(), std::size_t(5));
}

void TimePointsTest::imagesBesideEachOtherAreNoTimeAxis()
{
    const std::size_t acquisition = attribute("acquisition");
    const TimeAxis axis = core::findTimeAxis(places(3, 2, [&](ImageHeader& image, int, int index) {
        image.position->x += 40.0 * index;
        image.phases[acquisition] = QString::number(index);
    }));
    QVERIFY(!axis.complete);
    QCOMPARE(axis.points.size(), std::size_t(2));
}

void TimePointsTest::timesOfDayAreReadable()
{
    const std::size_t time = attribute("acquired at");
    QCOMPARE(core::phaseText(time, QStringLiteral("103045.120000")).english(),
        QStringLiteral("acquired at 10:30:45.12"));
    QCOMPARE(core::phaseText(time, QStringLiteral("20181022083634.000000")).english(),
        QStringLiteral("acquired at 08:36:34"));
    QCOMPARE(core::phaseText(time, QStringLiteral("noon")).english(),
        QStringLiteral("acquired at noon"));
}

BURIN_TEST(TimePointsTest)

} // namespace timePointsTest

#include "TimePointsTest.moc"
