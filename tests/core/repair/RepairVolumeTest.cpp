// SPDX-License-Identifier: Apache-2.0
#include "core/repair/RepairLattice.h"
#include "core/repair/SeriesFindings.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/defective/DefectiveSeries.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <functional>
#include <memory>

namespace repairVolumeTest {

using core::VolumeProblem;
using test::SyntheticSeries;

namespace {

using Expected = std::function<double(const glm::ivec3&)>;

/// How many voxels are not as expected.
int wrongVoxels(const core::LoadedVolume& loaded, const Expected& expected)
{
    int wrong = 0;
    const glm::ivec3 size = loaded.volume.geometry.size;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x)
                wrong += test::valueAt(loaded, {x, y, z}) == expected({x, y, z}) ? 0 : 1;
        }
    }
    return wrong;
}

const core::RepairOffer* offerOf(const core::Volume& volume, const QString& repair)
{
    static std::vector<core::SeriesFinding> findings;
    findings = core::seriesFindings(volume);
    for (const core::SeriesFinding& finding : findings) {
        for (const core::RepairOffer& offer : finding.offers) {
            if (offer.repair == repair)
                return &offer;
        }
    }
    return nullptr;
}

} // namespace

/// Series with defects, opened with a repair: every voxel where and what it should be.
class RepairVolumeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        m_folder = std::make_unique<QTemporaryDir>();
    }

    void tiltOfWholePixelsMovesValues();
    void tiltBetweenPixelsInterpolates();
    void tiltLeavesUnevenSlicesInTheirPlanes();
    void paddingIsNotMixedIn();
    void missingSlicesAreFilled();
    void damagedSliceIsFilled();
    void unevenSlicesBecomeEven();
    void splitTakesAPart();
    void oneOfSeveralAtAPlace();
    void severalRepairsAtOnce();
    void pointInTimeIsRepaired();
    void sameVoxelsOnEveryMachine();
    void whatCannotBeRepairedIsSaid_data();
    void whatCannotBeRepairedIsSaid();

private:
    [[nodiscard]] QString path() const { return m_folder->filePath(QStringLiteral("series")); }
    [[nodiscard]] core::LoadedVolume opened(const char* repair = "") const
    {
        return test::openVolume(path(), core::withRepair(QString(), QString::fromLatin1(repair)));
    }
    /// What was found, opened with the repair; that it was offered, with the grid that it has.
    [[nodiscard]] core::LoadedVolume offered(const char* repair) const
    {
        const core::LoadedVolume asIs = opened();
        core::LoadedVolume repaired = opened(repair);
        const core::RepairOffer* offer = offerOf(asIs.volume, QString::fromLatin1(repair));
        if (offer == nullptr || offer->result.size != repaired.volume.geometry.size
            || offer->result.indexToWorld != repaired.volume.geometry.indexToWorld)
            qWarning("%s is not offered as what it is", repair);
        return repaired;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void RepairVolumeTest::tiltOfWholePixelsMovesValues()
{
    SyntheticSeries series = test::tiltedSeries(1.25);
    series.stored = SyntheticSeries::defaultStored;
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = offered("tilt");
    const core::Volume& volume = loaded.volume;
    QCOMPARE(volume.geometry.size, glm::ivec3(24, 18 + 9, 10));
    QVERIFY(volume.geometry.shearAngleDegrees() < 1e-6);
    QCOMPARE(volume.geometry.originLps(), series.origin);
    QCOMPARE(volume.geometry.spacingMm().z, 2.5);
    const double least = opened().volume.minimum;
    QCOMPARE(wrongVoxels(loaded,
                 [&](const glm::ivec3& at) {
                     const int j = at.y - at.z;
                     return j < 0 || j >= 18 ? least : series.value({at.x, j, at.z});
                 }),
        0);
    QCOMPARE(volume.repair, QStringLiteral("tilt"));
    QVERIFY(volume.sources.empty());
    QCOMPARE(volume.asIs->sources.size(), std::size_t(10));
    QVERIFY(!volume.needsCaution());
    QVERIFY(test::hasProblem(volume.problems, VolumeProblem::Kind::Tilt));
    QCOMPARE(volume.problems.front().repairedBy, QStringLiteral("tilt"));
    // What is outside the images is none of them.
    std::size_t counted = 0;
    for (const std::uint32_t count : volume.histogram.counts)
        counted += count;
    QCOMPARE(counted, std::size_t(24 * 18 * 10));
}

void RepairVolumeTest::tiltBetweenPixelsInterpolates()
{
    const SyntheticSeries series = test::tiltedSeries(0.5);
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = offered("tilt");
    QCOMPARE(loaded.volume.geometry.size, glm::ivec3(24, 18 + 4, 10));
    const double least = opened().volume.minimum;
    QCOMPARE(
        wrongVoxels(loaded,
            [&](const glm::ivec3& at) {
                const double j = double(at.y) - 0.4 * double(at.z);
                if (j >= -1e-9 && j <= 17.0 + 1e-9)
                    return 25.0 * at.y + 3.0 * at.x - 1024.0;
                // Beyond the outermost rows the nearest one, as far as half a voxel.
                const int nearest = int(std::ceil(j - 0.5));
                return nearest < 0 || nearest > 17 ? least : series.value({at.x, nearest, at.z});
            }),
        0);
}

void RepairVolumeTest::tiltLeavesUnevenSlicesInTheirPlanes()
{
    SyntheticSeries series;
    series.size.z = 4;
    series.positions = {{0, 0, 0}, {0, 2.5, 4}, {0, 5, 11}, {0, 7.5, 15}};
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = opened("tilt");
    const core::VolumeGeometry& geometry = loaded.volume.geometry;
    QCOMPARE(geometry.size, glm::ivec3(24, 18 + 6, 4));
    QCOMPARE(geometry.slicePositions.size(), std::size_t(4));
    for (int k = 0; k < 4; ++k) {
        const glm::dvec3 straight(0.0, 0.0, series.positions[std::size_t(k)].z);
        QVERIFY(glm::distance(geometry.slicePositions[std::size_t(k)], straight) < 1e-9);
    }
    QVERIFY(loaded.volume.needsCaution());
    QCOMPARE(test::valueAt(loaded, {5, 3 + 4, 2}), series.value({5, 3, 2}));
}

void RepairVolumeTest::paddingIsNotMixedIn()
{
    SyntheticSeries series = test::tiltedSeries(0.5);
    series.stored = [](const glm::ivec3& index) { return index.y < 4 ? 7 : 1500 + index.x; };
    series.adjust = [](DcmDataset& set, int) { set.putAndInsertUint16(DCM_PixelPaddingValue, 7); };
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = opened("tilt");
    const double padding = 7.0 - 1024.0;
    QCOMPARE(wrongVoxels(loaded,
                 [&](const glm::ivec3& at) {
                     const double value = test::valueAt(loaded, at);
                     return value == padding || value == 1500.0 + at.x - 1024.0 ? value : -1.0;
                 }),
        0);
    QCOMPARE(loaded.volume.histogram.minimum, 1500.0 - 1024.0);
}

void RepairVolumeTest::missingSlicesAreFilled()
{
    const SyntheticSeries series =
        test::seriesAtHeights({0, 2.5, 5, 7.5, 10, 12.5, 15, 17.5, 20, 22.5});
    test::writeSeries(series, path());
    for (const int k : {3, 6, 7})
        QVERIFY(QFile::remove(path() + QLatin1Char('/') + series.fileName(k)));
    const core::LoadedVolume loaded = offered("gap=fill");
    QCOMPARE(loaded.volume.geometry.size, series.size);
    QVERIFY(loaded.volume.geometry.slicePositions.empty());
    QCOMPARE(wrongVoxels(loaded, [&](const glm::ivec3& at) { return series.value(at); }), 0);
    QVERIFY(!loaded.volume.needsCaution());
    const std::vector<core::SliceSpan> slices{{3, 4}, {5, 6}};
    const auto missing = std::find_if(loaded.volume.problems.begin(), loaded.volume.problems.end(),
        [](const VolumeProblem& problem) {
            return problem.kind == VolumeProblem::Kind::MissingSlices;
        });
    QVERIFY(missing != loaded.volume.problems.end());
    QVERIFY(missing->slices == slices);
    const core::RepairOffer* offer = offerOf(loaded.volume, QStringLiteral("gap=fill"));
    QVERIFY(offer != nullptr);
    QVERIFY(offer->kind == core::RepairOffer::Kind::FillGaps);
    QCOMPARE(offer->made, 3);
    QCOMPARE(offer->kept, 7);
}

void RepairVolumeTest::damagedSliceIsFilled()
{
    const SyntheticSeries series = test::seriesAtHeights({0, 2.5, 5, 7.5, 10});
    const QStringList files = test::writeSeries(series, path());
    QFile cut(files[2]);
    QVERIFY(cut.resize(cut.size() - 100));
    const core::LoadedVolume loaded = offered("gap=fill");
    QCOMPARE(loaded.volume.geometry.size, series.size);
    QCOMPARE(wrongVoxels(loaded, [&](const glm::ivec3& at) { return series.value(at); }), 0);
}

void RepairVolumeTest::unevenSlicesBecomeEven()
{
    const SyntheticSeries series = test::seriesAtHeights({0, 4, 8, 12, 16, 20, 27, 34, 41, 48});
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = offered("spacing=even");
    QCOMPARE(loaded.volume.geometry.size.z, 13);
    QCOMPARE(loaded.volume.geometry.spacingMm().z, 4.0);
    QCOMPARE(
        wrongVoxels(loaded, [](const glm::ivec3& at) { return 80.0 * at.z + 3.0 * at.x - 1024.0; }),
        0);
    QVERIFY(!loaded.volume.needsCaution());
}

void RepairVolumeTest::splitTakesAPart()
{
    const SyntheticSeries series = test::seriesAtHeights({0, 4, 8, 12, 16, 20, 27, 34, 41, 48});
    test::writeSeries(series, path());
    const core::LoadedVolume first = offered("gap=split:1");
    QCOMPARE(first.volume.geometry.size.z, 6);
    QVERIFY(first.volume.geometry.slicePositions.empty());
    const core::LoadedVolume loaded = offered("gap=split:2");
    const core::Volume& volume = loaded.volume;
    QCOMPARE(volume.geometry.size.z, 4);
    QVERIFY(volume.geometry.slicePositions.empty());
    QCOMPARE(volume.geometry.spacingMm().z, 7.0);
    QCOMPARE(volume.geometry.originLps(), series.position(6));
    QCOMPARE(wrongVoxels(loaded,
                 [&](const glm::ivec3& at) {
                     return series.value({at.x, at.y, at.z + 6});
                 }),
        0);
    // Its voxels lie on its images.
    QCOMPARE(volume.sources.size(), std::size_t(4));
    QCOMPARE(volume.sources[0].file, path() + QLatin1Char('/') + series.fileName(6));
    QVERIFY(!volume.needsCaution());
}

void RepairVolumeTest::oneOfSeveralAtAPlace()
{
    const SyntheticSeries series;
    test::writeSeries(series, path());
    test::addDoubles(series, path(), 5);
    const core::Result<core::StudyListing> listing = core::scanStudies(path());
    QVERIFY(listing && listing->candidates().size() == 2);
    const QString key = listing->candidates()[0]->key;
    const auto repaired = [&](const char* repair) {
        return test::openVolume(path(), core::withRepair(key, QString::fromLatin1(repair)));
    };
    const core::LoadedVolume asIs = test::openVolume(path(), key);
    const core::LoadedVolume first = repaired("duplicates=first");
    QCOMPARE(test::worstError(first, series), 0.0);
    QVERIFY(!first.volume.needsCaution());
    QCOMPARE(first.volume.sources.size(), std::size_t(10));
    const core::LoadedVolume last = repaired("duplicates=last");
    QCOMPARE(wrongVoxels(last,
                 [&](const glm::ivec3& at) {
                     return at.z >= 2 && at.z <= 5 ? 5.0 - 1024.0 : series.value(at);
                 }),
        0);
    QVERIFY(offerOf(asIs.volume, QStringLiteral("duplicates=first")) != nullptr);
    const QString text =
        test::problemText(asIs.volume.problems, VolumeProblem::Kind::DoubledSlices);
    QVERIFY2(text.contains(QStringLiteral("slices 3–6")), qPrintable(text));
}

void RepairVolumeTest::severalRepairsAtOnce()
{
    // Tilted and uneven, as one head CT of the shared data is.
    SyntheticSeries series = test::seriesAtHeights({0, 4, 8, 12, 16, 20, 27, 34, 41, 48});
    for (glm::dvec3& position : series.positions)
        position.y += position.z / 3.2;
    series.stored = [&](const glm::ivec3& index) {
        return 25 * index.y
            + int(std::lround(20.0 * (series.positions[std::size_t(index.z)].y - series.origin.y)));
    };
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = opened("tilt,spacing=even");
    QCOMPARE(loaded.volume.repair, QStringLiteral("spacing=even,tilt"));
    QCOMPARE(loaded.volume.geometry.size, glm::ivec3(24, 18 + 12, 13));
    QVERIFY(loaded.volume.geometry.shearAngleDegrees() < 1e-6);
    QVERIFY(!loaded.volume.needsCaution());
    // The field grows along y alone: well within the images it is met everywhere.
    int outside = 0;
    QVERIFY(wrongVoxels(loaded, [&](const glm::ivec3& at) {
        const double value = 25.0 * at.y - 1024.0;
        const bool within = test::valueAt(loaded, at) == value;
        outside += within ? 0 : 1;
        return within ? value : test::valueAt(loaded, at);
    }) == 0);
    // 18 of 30 rows are inside in a slice, one at either end may be the nearest one's.
    QVERIFY2(outside <= 13 * 24 * (30 - 16), qPrintable(QString::number(outside)));
}

void RepairVolumeTest::pointInTimeIsRepaired()
{
    SyntheticSeries first = test::tiltedSeries(1.25);
    first.adjust = [](DcmDataset& set, int) { set.putAndInsertString(DCM_TriggerTime, "80"); };
    SyntheticSeries second = first;
    second.stored = [](const glm::ivec3& index) { return index.z + 1; };
    second.fileName = [](int k) { return QStringLiteral("b%1").arg(k); };
    second.adjust = [](DcmDataset& set, int k) {
        set.putAndInsertString(DCM_TriggerTime, "160");
        set.putAndInsertString(DCM_SOPInstanceUID, QByteArray::number(900 + k).constData());
    };
    test::writeSeries(first, path());
    test::writeSeries(second, path());
    const core::LoadedVolume loaded =
        test::openVolume(path(), first.seriesUid + QStringLiteral("@2+tilt"));
    QCOMPARE(loaded.volume.seriesKey, first.seriesUid + QStringLiteral("@2"));
    QCOMPARE(loaded.volume.alternatives->times.size(), 2);
    QCOMPARE(loaded.volume.alternatives->time, 1);
    QCOMPARE(test::valueAt(loaded, {3, 12, 4}), 5.0 - 1024.0);
}

void RepairVolumeTest::sameVoxelsOnEveryMachine()
{
    SyntheticSeries series;
    const double angle = glm::radians(23.0);
    series.plane.column = {0.0, std::cos(angle), std::sin(angle)};
    double height = 0.0;
    for (int k = 0; k < series.size.z; ++k) {
        series.positions.emplace_back(-9.0, -11.25, height);
        height += k % 3 == 2 ? 3.7 : 2.1;
    }
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = opened("spacing=even,tilt");
    QCOMPARE(loaded.volume.voxelsSha256,
        QByteArray("cfcb3d4abfbcb19913b8a349905cec05d3a5b3e3ade7c34876994a4553543271"));
}

void RepairVolumeTest::whatCannotBeRepairedIsSaid_data()
{
    QTest::addColumn<QString>("repair");
    QTest::addColumn<QString>("reason");
    QTest::newRow("no such word") << QStringLiteral("mend") << QStringLiteral("'mend'");
    QTest::newRow("no gap") << QStringLiteral("gap=split:1") << QStringLiteral("no gap");
    QTest::newRow("no doubles") << QStringLiteral("duplicates=first")
                                << QStringLiteral("no places");
}

void RepairVolumeTest::whatCannotBeRepairedIsSaid()
{
    QFETCH(QString, repair);
    QFETCH(QString, reason);
    test::writeSeries(SyntheticSeries(), path());
    const auto loaded = core::loadVolume(path(), core::withRepair(QString(), repair));
    if (repair == QLatin1String("gap=split:1")) {
        // The whole is its only part.
        QVERIFY(loaded);
        const auto second = core::loadVolume(path(), QStringLiteral("+gap=split:2"));
        QVERIFY(!second);
        QVERIFY2(second.error().arguments.value(1).contains(reason),
            qPrintable(test::errorText(second.error())));
        return;
    }
    QVERIFY(!loaded);
    QCOMPARE(loaded.error().code, core::ErrorCode::InvalidField);
    QVERIFY2(loaded.error().arguments.value(1).contains(reason),
        qPrintable(test::errorText(loaded.error())));
}

BURIN_TEST(RepairVolumeTest)

} // namespace repairVolumeTest

#include "RepairVolumeTest.moc"
