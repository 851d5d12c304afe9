// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/SessionStudy.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/SyntheticSeries.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <memory>
#include <string>

namespace sessionInTimeTest {

using namespace core;

namespace {

/// As many points in time as asked for, all with the very same voxels, such as a phantom gives or a
/// field of view without the patient: only its number tells one from another.
test::SyntheticSeries writeTimes(const QString& folder, int count)
{
    const test::SyntheticSeries series;
    for (int time = 1; time <= count; ++time) {
        test::SyntheticSeries point = series;
        point.fileName = [time](int k) { return QStringLiteral("t%1s%2").arg(time).arg(k); };
        point.adjust = [time](DcmDataset& set, int k) {
            set.putAndInsertString(DCM_TriggerTime, std::to_string(80 * time).c_str());
            set.putAndInsertString(
                DCM_SOPInstanceUID, ("2.25.9" + std::to_string(1000 * time + k)).c_str());
        };
        test::writeSeries(point, folder);
    }
    return series;
}

} // namespace

/// Sessions on a point of a series in time: each reopens at its own.
class SessionInTimeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void reopensAtItsPoint_data();
    void reopensAtItsPoint();
    void fewerPointsElsewhere();
    void volumesWithoutTimeSayNothing();

private:
    [[nodiscard]] QString path(const char* name) const
    {
        return m_folder->filePath(QLatin1String(name));
    }
    /// Made at a point, from 1, and closed.
    [[nodiscard]] SessionSource sessionAt(int time, const QString& seriesUid) const
    {
        LoadedVolume volume =
            test::openVolume(path("ct"), QStringLiteral("%1@%2").arg(seriesUid).arg(time));
        {
            reference::ReferenceEngine engine;
            const auto session =
                EditSession::create(engine, std::move(volume), {.file = path("s.burin")});
            if (!session || !(*session)->apply(test::addSegment("A")) || !(*session)->settle())
                qFatal("no session");
        }
        return checkSession(path("s.burin"))->source;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void SessionInTimeTest::reopensAtItsPoint_data()
{
    QTest::addColumn<int>("time");
    for (const int time : {1, 2, 3, 4})
        QTest::addRow("point %d", time) << time;
}

void SessionInTimeTest::reopensAtItsPoint()
{
    QFETCH(int, time);
    const test::SyntheticSeries series = writeTimes(path("ct"), 4);
    const SessionSource source = sessionAt(time, series.seriesUid);
    QCOMPARE(source.time, time);
    const auto again = loadSessionStudy(path("s.burin"), source, {}, {}, Progress());
    QVERIFY(again);
    QVERIFY(again->volume.alternatives);
    QCOMPARE(again->volume.alternatives->time, time - 1);
    // What is exported names the images of that point.
    const QString name = QStringLiteral("t%1s").arg(time);
    for (const SourceSlice& slice : again->volume.sources)
        QVERIFY2(slice.file.contains(QLatin1Char('/') + name), qPrintable(slice.file));
}

/// The point is looked for by its voxels where a copy of the study has lost some.
void SessionInTimeTest::fewerPointsElsewhere()
{
    const test::SyntheticSeries series = writeTimes(path("ct"), 4);
    const SessionSource source = sessionAt(4, series.seriesUid);
    QDir folder(path("ct"));
    for (const QString& file : folder.entryList({QStringLiteral("t3*"), QStringLiteral("t4*")}))
        QVERIFY(folder.remove(file));
    const auto again = loadSessionStudy(path("s.burin"), source, {}, {}, Progress());
    QVERIFY(again);
    QCOMPARE(again->volume.alternatives->time, 0);
}

void SessionInTimeTest::volumesWithoutTimeSayNothing()
{
    test::writeSeries(test::SyntheticSeries(), path("ct"));
    const SessionSource source = SessionSource::of(test::openVolume(path("ct"), {}).volume);
    QCOMPARE(source.time, 0);
    QVERIFY(!source.toJson().contains(QStringLiteral("time")));
}

BURIN_TEST(SessionInTimeTest)

} // namespace sessionInTimeTest

#include "SessionInTimeTest.moc"
