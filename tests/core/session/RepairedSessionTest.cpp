// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/ExportMask.h"
#include "core/repair/SeriesRepair.h"
#include "core/session/EditSession.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/SessionStudy.h"
#include "core/sessionfile/records/SessionImages.h"
#include "core/sessionfile/records/VolumeJson.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/defective/DefectiveSeries.h"

#include <QDir>
#include <QFile>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

namespace repairedSessionTest {

using namespace core;

namespace {

const QString tilt = QStringLiteral("tilt");

SessionSource again(const SessionSource& source)
{
    return SessionSource::fromJson(source.toJson()).value_or(SessionSource{});
}

} // namespace

/// Sessions on repaired series: reopening one repairs the series once more, to the same voxels.
class RepairedSessionTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        test::writeSeries(test::tiltedSeries(0.5), path("ct"));
    }

    void reopensRepaired();
    void isNotForTheSeriesAsItIs();
    void everyRepairIsFoundAgain_data();
    void everyRepairIsFoundAgain();
    void imagesInTheSessionKnowTheWayBack();
    void forgedWayBackIsRefused();

private:
    [[nodiscard]] QString path(const char* name) const
    {
        return m_folder->filePath(QLatin1String(name));
    }
    [[nodiscard]] LoadedVolume repaired() const
    {
        return test::openVolume(path("ct"), withRepair(QString(), tilt));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void RepairedSessionTest::reopensRepaired()
{
    const LoadedVolume loaded = repaired();
    QByteArray hash;
    RowId undone = 0;
    {
        reference::ReferenceEngine engine;
        const auto session = EditSession::create(engine, loaded, {.file = path("s.burin")});
        QVERIFY(session);
        QVERIFY((*session)->apply(test::addSegment("A")));
        QVERIFY((*session)->apply(test::addSegment("B")));
        QVERIFY((*session)->settle());
        QVERIFY((*session)->undo());
        QVERIFY((*session)->settle());
        hash = (*session)->stateHash();
        undone = (*session)->history().position();
    }
    const auto contents = checkSession(path("s.burin"));
    QVERIFY(contents);
    QCOMPARE(contents->source.repair, tilt);
    const auto found = loadSessionStudy(path("s.burin"), contents->source);
    QVERIFY2(found, found ? "" : qPrintable(test::errorText(found.error())));
    QCOMPARE(found->volume.repair, tilt);
    QCOMPARE(found->volume.voxelsSha256, loaded.volume.voxelsSha256);
    reference::ReferenceEngine engine;
    const auto session = EditSession::open(engine, *found, path("s.burin"));
    QVERIFY(session);
    QCOMPARE((*session)->stateHash(), hash);
    QCOMPARE((*session)->history().position(), undone);
    QVERIFY((*session)->redo());
    QVERIFY((*session)->settle());
    QCOMPARE((*session)->document().segments.size(), std::size_t(2));
}

void RepairedSessionTest::isNotForTheSeriesAsItIs()
{
    const SessionSource source = again(SessionSource::of(repaired().volume));
    QVERIFY(source.differenceFrom(repaired().volume).isEmpty());
    const QString difference = source.differenceFrom(test::openVolume(path("ct")).volume);
    QVERIFY2(difference.contains(QLatin1String("tilt")), qPrintable(difference));
    const SessionSource asIs = again(SessionSource::of(test::openVolume(path("ct")).volume));
    QVERIFY(!asIs.toJson().contains(QStringLiteral("repair")));
    QVERIFY(!asIs.differenceFrom(repaired().volume).isEmpty());
}

void RepairedSessionTest::everyRepairIsFoundAgain_data()
{
    QTest::addColumn<QString>("repair");
    for (const char* repair :
        {"gap=fill", "gap=split:2", "spacing=even", "tilt", "gap=fill,tilt", "gap=split:1,tilt"})
        QTest::newRow(repair) << QString::fromLatin1(repair);
}

void RepairedSessionTest::everyRepairIsFoundAgain()
{
    QFETCH(QString, repair);
    for (const int k : {4, 5})
        QVERIFY(QFile::remove(path("ct/") + test::SyntheticSeries::shuffledName(k)));
    const LoadedVolume loaded = test::openVolume(path("ct"), withRepair(QString(), repair));
    QVERIFY(!loaded.codes.empty());
    const SessionSource source = again(SessionSource::of(loaded.volume));
    const auto found = loadSessionStudy(path("nowhere.burin"), source);
    QVERIFY2(found, found ? "" : qPrintable(test::errorText(found.error())));
    QCOMPARE(found->volume.repair, repair);
    QVERIFY(found->codes == loaded.codes);
}

void RepairedSessionTest::imagesInTheSessionKnowTheWayBack()
{
    const LoadedVolume loaded = repaired();
    auto staged = stageImages(path("s.burin"), true, loaded);
    QVERIFY2(staged, staged ? "" : qPrintable(test::errorText(staged.error())));
    QVERIFY(staged->commit());
    QVERIFY(QDir(path("ct")).removeRecursively());
    const auto images = loadSessionImages(path("s.burin"));
    QVERIFY2(images, images ? "" : qPrintable(test::errorText(images.error())));
    QCOMPARE(images->volume.repair, tilt);
    QVERIFY(images->codes == loaded.codes);
    QVERIFY(!images->volume.alternatives);

    Segment segment;
    segment.label = 1;
    segment.name = QStringLiteral("All");
    segment.code = anatomicalStructure();
    const std::vector<std::uint8_t> labels(images->codes.size(), 1);
    const auto report = exportMask(images->volume,
        {.file = path("seg.dcm"),
            .segments = {segment},
            .planes = {{.plane = 0, .labels = labels}}},
        {});
    QVERIFY2(report, report ? "" : qPrintable(test::errorText(report.error())));
}

void RepairedSessionTest::forgedWayBackIsRefused()
{
    const QJsonObject json = volumeToJson(repaired().volume);
    QVERIFY(volumeFromJson(json));
    for (const char* repair : {"gap=split:7", "mend", "gap=split:1", "spacing=even"}) {
        QJsonObject forged = json;
        forged[QStringLiteral("repair")] = QString::fromLatin1(repair);
        QVERIFY2(!volumeFromJson(forged), repair);
    }
    QJsonObject without = json;
    without.remove(QStringLiteral("asIs"));
    QVERIFY(!volumeFromJson(without));
}

BURIN_TEST(RepairedSessionTest)

} // namespace repairedSessionTest

#include "RepairedSessionTest.moc"
