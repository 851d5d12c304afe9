// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/StatisticsText.h"
#include "tests/support/program/TestProgram.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <memory>

namespace statisticsTextTest {

using namespace core;

/// What a table of numbers says beside the numbers.
class StatisticsTextTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// All points of a series in time have its UIDs: numbers of one would be taken for another's.
    void jsonSaysWhichPointInTimeItIs()
    {
        const auto studyIn = [](const Volume& volume) {
            return QJsonDocument::fromJson(statisticsJson({}, volume, volume.identity))
                .object()[QStringLiteral("study")]
                .toObject();
        };
        Volume volume;
        volume.identity.seriesUid = QStringLiteral("1.2.3");
        QVERIFY(!studyIn(volume).contains(QStringLiteral("pointInTime")));
        SeriesAlternatives series;
        series.times = QStringList{QString()};
        volume.alternatives = std::make_shared<const SeriesAlternatives>(series);
        QVERIFY(!studyIn(volume).contains(QStringLiteral("pointInTime")));
        series.times = QStringList{QStringLiteral("0 ms"), QStringLiteral("40 ms"), QString()};
        series.time = 1;
        volume.alternatives = std::make_shared<const SeriesAlternatives>(series);
        const QJsonObject study = studyIn(volume);
        QCOMPARE(study[QStringLiteral("seriesUid")].toString(), QStringLiteral("1.2.3"));
        QCOMPARE(study[QStringLiteral("pointInTime")].toInt(), 2);
        QCOMPARE(study[QStringLiteral("pointsInTime")].toInt(), 3);
    }
};

BURIN_TEST(StatisticsTextTest)

} // namespace statisticsTextTest

#include "StatisticsTextTest.moc"
