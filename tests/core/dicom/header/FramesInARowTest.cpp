// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/source/KeptHeaders.h"
#include "core/export/common/ExportMask.h"
#include "core/study/StudyLoader.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/SmallSeries.h"
#include "tests/support/series/VerifyResult.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace framesInARowTest {

namespace {

constexpr int columns = 5;
constexpr int rows = 4;

using Adjust = std::function<void(DcmDataset& set)>;

void putText(DcmItem& item, const DcmTagKey& key, const QByteArray& value)
{
    item.putAndInsertString(key, value.constData());
}

/// A file whose frames have one value each.
struct RowFile {
    QByteArray sopClass;
    int frames = 1;
    int bits = 16;
    std::function<std::uint32_t(int frame)> stored;
    Adjust describe;

    void write(const QString& path) const
    {
        DcmFileFormat format;
        DcmDataset& set = *format.getDataset();
        putText(set, DCM_SOPClassUID, sopClass);
        putText(set, DCM_SOPInstanceUID, "2.25.6000.1");
        putText(set, DCM_StudyInstanceUID, "2.25.6001");
        putText(set, DCM_SeriesInstanceUID, "2.25.6002");
        putText(set, DCM_FrameOfReferenceUID, "2.25.6003");
        putText(set, DCM_PixelSpacing, "3\\2");
        putText(set, DCM_PhotometricInterpretation, "MONOCHROME2");
        putText(set, DCM_NumberOfFrames, QByteArray::number(frames));
        set.putAndInsertUint16(DCM_SamplesPerPixel, 1);
        set.putAndInsertUint16(DCM_Rows, rows);
        set.putAndInsertUint16(DCM_Columns, columns);
        set.putAndInsertUint16(DCM_BitsAllocated, Uint16(bits));
        set.putAndInsertUint16(DCM_BitsStored, Uint16(bits));
        set.putAndInsertUint16(DCM_HighBit, Uint16(bits - 1));
        set.putAndInsertUint16(DCM_PixelRepresentation, 0);
        std::vector<Uint16> words;
        for (int frame = 0; frame < frames; ++frame) {
            for (int pixel = 0; pixel < rows * columns; ++pixel) {
                words.push_back(Uint16(stored(frame)));
                if (bits == 32)
                    words.push_back(Uint16(stored(frame) >> 16));
            }
        }
        set.putAndInsertUint16Array(DCM_PixelData, words.data(), words.size());
        describe(set);
        if (format.saveFile(QFile::encodeName(path).constData(), EXS_LittleEndianExplicit).bad())
            qFatal("cannot write %s", qPrintable(path));
    }
};

constexpr int slices = 64;

void putPlane(DcmItem& item)
{
    putText(item, DCM_ImagePositionPatient, "-20\\-10\\100");
    putText(item, DCM_ImageOrientationPatient, "1\\0\\0\\0\\1\\0");
}

DcmItem& detectorOf(DcmDataset& set)
{
    DcmItem* item = nullptr;
    set.findOrCreateSequenceItem(DCM_DetectorInformationSequence, item, 0);
    return *item;
}

void putSliceNumbers(DcmDataset& set, int first, int step)
{
    std::vector<Uint16> numbers;
    for (int frame = 0; frame < slices; ++frame)
        numbers.push_back(Uint16(first + step * frame));
    set.putAndInsertUint16Array(DCM_SliceVector, numbers.data(), numbers.size());
}

/// Reconstructed nuclear medicine, its slices 4 mm apart; frame f is f + 1.
RowFile reconstruction(const Adjust& adjust)
{
    return {.sopClass = UID_NuclearMedicineImageStorage,
        .frames = slices,
        .stored = [](int frame) { return std::uint32_t(frame + 1); },
        .describe =
            [adjust](DcmDataset& set) {
                putText(set, DCM_Modality, "NM");
                putText(set, DCM_ImageType, "ORIGINAL\\PRIMARY\\RECON TOMO\\EMISSION");
                putText(set, DCM_SpacingBetweenSlices, "4");
                putPlane(detectorOf(set));
                putSliceNumbers(set, 1, 1);
                adjust(set);
            }};
}

constexpr double perCell = 0.001;

std::uint32_t doseCell(int frame)
{
    return std::uint32_t(50'000 + 1000 * frame);
}

/// Three frames at z = 50, 53 and 56, from 50 Gy up.
RowFile dose(const Adjust& adjust = [](DcmDataset&) {})
{
    return {.sopClass = UID_RTDoseStorage,
        .frames = 3,
        .bits = 32,
        .stored = doseCell,
        .describe = [adjust](DcmDataset& set) {
            putText(set, DCM_Modality, "RTDOSE");
            putText(set, DCM_ImagePositionPatient, "-20\\-10\\50");
            putText(set, DCM_ImageOrientationPatient, "1\\0\\0\\0\\1\\0");
            putText(set, DCM_GridFrameOffsetVector, "0\\3\\6");
            putText(set, DCM_DoseGridScaling, "0.001");
            putText(set, DCM_DoseUnits, "GY");
            adjust(set);
        }};
}

/// Why a file is no volume; empty if it is one.
QString refusalOf(const RowFile& written)
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("row.dcm"));
    written.write(file);
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(file);
    return loaded ? QString() : QString(loaded.error().arguments.value(1));
}

} // namespace

/// Objects whose frames lie behind each other at distances that the data set states: doses, and
/// reconstructed nuclear medicine.
class FramesInARowTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void slicesOfNuclearMedicine_data();
    void slicesOfNuclearMedicine();
    void framesWithoutAPlaceAreRefused_data();
    void framesWithoutAPlaceAreRefused();
    void missingPixelsCostTheirSlices();
    void doses_data();
    void doses();
    void dosesOfBeamsAreNoPointsInTime();
    void aDoseBesideImagesIsNoQuestion();
    void dosesWithoutAPlaceAreRefused_data();
    void dosesWithoutAPlaceAreRefused();
    void exportsLieWhereTheFramesLie_data();
    void exportsLieWhereTheFramesLie();
    void sharedDose();
};

void FramesInARowTest::slicesOfNuclearMedicine_data()
{
    QTest::addColumn<QByteArray>("distance");
    QTest::addColumn<bool>("isNumbered");
    QTest::addColumn<bool>("inDetector");
    QTest::newRow("up") << QByteArray("4") << true << true;
    QTest::newRow("down") << QByteArray("-4") << true << true;
    QTest::newRow("down, not numbered") << QByteArray("-4") << false << true;
    QTest::newRow("plane of the data set") << QByteArray("-4") << true << false;
}

void FramesInARowTest::slicesOfNuclearMedicine()
{
    QFETCH(QByteArray, distance);
    QFETCH(bool, isNumbered);
    QFETCH(bool, inDetector);
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("nm.dcm"));
    reconstruction([&](DcmDataset& set) {
        putText(set, DCM_SpacingBetweenSlices, distance);
        if (!isNumbered)
            set.findAndDeleteElement(DCM_SliceVector);
        if (!inDetector) {
            set.findAndDeleteElement(DCM_DetectorInformationSequence);
            putPlane(set);
        }
    }).write(file);
    const core::LoadedVolume loaded = test::openVolume(file);
    const bool isUp = distance == "4";
    QCOMPARE(loaded.volume.geometry.size, glm::ivec3(columns, rows, slices));
    QCOMPARE(loaded.volume.geometry.spacingMm(), glm::dvec3(2.0, 3.0, 4.0));
    const double lowest = isUp ? 100.0 : 100.0 - 4.0 * (slices - 1);
    QCOMPARE(loaded.volume.geometry.originLps(), glm::dvec3(-20.0, -10.0, lowest));
    QVERIFY(loaded.volume.geometry.slicePositions.empty());
    for (int k = 0; k < slices; ++k)
        QCOMPARE(test::valueAt(loaded, {1, 2, k}), double(isUp ? k + 1 : slices - k));
    QCOMPARE(loaded.volume.sources.front().frame, isUp ? 0 : slices - 1);
}

void FramesInARowTest::framesWithoutAPlaceAreRefused_data()
{
    QTest::addColumn<QByteArray>("what");
    QTest::addColumn<QString>("why");
    const QString unplaced = QStringLiteral("nothing says where each of its 64 frames lies");
    QTest::newRow("no plane") << QByteArray(
        "plane") << QStringLiteral("no position or orientation in the patient for its 64 frames");
    QTest::newRow("no distance") << QByteArray("distance") << unplaced;
    QTest::newRow("projections") << QByteArray("projections") << unplaced;
    QTest::newRow("phases of a heart") << QByteArray("phases") << unplaced;
    QTest::newRow("counted down") << QByteArray("down") << unplaced;
}

void FramesInARowTest::framesWithoutAPlaceAreRefused()
{
    QFETCH(QByteArray, what);
    QFETCH(QString, why);
    const QString refusal = refusalOf(reconstruction([&](DcmDataset& set) {
        if (what == "plane")
            set.findAndDeleteElement(DCM_DetectorInformationSequence);
        if (what == "distance")
            set.findAndDeleteElement(DCM_SpacingBetweenSlices);
        if (what == "projections")
            putText(set, DCM_ImageType, "ORIGINAL\\PRIMARY\\TOMO\\EMISSION");
        if (what == "phases")
            putText(set, DCM_ImageType, "ORIGINAL\\PRIMARY\\RECON GATED TOMO\\EMISSION");
        if (what == "down")
            putSliceNumbers(set, slices, -1);
    }));
    QVERIFY2(refusal.contains(why), qPrintable(refusal));
}

void FramesInARowTest::missingPixelsCostTheirSlices()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("nm.dcm"));
    reconstruction([](DcmDataset&) {}).write(path);
    QFile file(path);
    QVERIFY(file.resize(file.size() - 2 * 2 * columns * rows));
    const core::LoadedVolume loaded = test::openVolume(path);
    QCOMPARE(loaded.volume.geometry.size.z, slices - 2);
    QVERIFY(test::hasProblem(loaded.volume.problems, core::VolumeProblem::Kind::DamagedSlice));
}

void FramesInARowTest::doses_data()
{
    QTest::addColumn<QByteArray>("offsets");
    QTest::addColumn<int>("bits");
    QTest::addColumn<bool>("isUp");
    QTest::newRow("from the first") << QByteArray("0\\3\\6") << 32 << true;
    QTest::newRow("16 bits") << QByteArray("0\\3\\6") << 16 << true;
    QTest::newRow("places") << QByteArray("50\\53\\56") << 32 << true;
    QTest::newRow("down") << QByteArray("0\\-3\\-6") << 32 << false;
}

void FramesInARowTest::doses()
{
    QFETCH(QByteArray, offsets);
    QFETCH(int, bits);
    QFETCH(bool, isUp);
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("dose.dcm"));
    RowFile written =
        dose([&](DcmDataset& set) { putText(set, DCM_GridFrameOffsetVector, offsets); });
    written.bits = bits;
    written.write(file);
    const core::LoadedVolume loaded = test::openVolume(file);
    QCOMPARE(loaded.volume.geometry.size, glm::ivec3(columns, rows, 3));
    QCOMPARE(loaded.volume.geometry.spacingMm(), glm::dvec3(2.0, 3.0, 3.0));
    QCOMPARE(loaded.volume.geometry.originLps(), glm::dvec3(-20.0, -10.0, isUp ? 50.0 : 44.0));
    QCOMPARE(loaded.volume.unit, QStringLiteral("Gy"));
    for (int k = 0; k < 3; ++k) {
        const double expected = perCell * doseCell(isUp ? k : 2 - k);
        QVERIFY(std::abs(test::valueAt(loaded, {4, 3, k}) - expected)
            <= loaded.volume.encoding.maxError + 1e-9);
    }
}

void FramesInARowTest::dosesOfBeamsAreNoPointsInTime()
{
    const QTemporaryDir folder;
    dose().write(folder.filePath(QStringLiteral("first.dcm")));
    dose([](DcmDataset& set) {
        putText(set, DCM_SOPInstanceUID, "2.25.6000.2");
        putText(set, DCM_DoseGridScaling, "0.002");
    }).write(folder.filePath(QStringLiteral("second.dcm")));
    const core::Result<core::StudyListing> listing = core::scanStudies(folder.path());
    QVERIFY(listing);
    const std::vector<const core::SeriesEntry*> candidates = listing->candidates();
    QCOMPARE(candidates.size(), std::size_t(2));
    for (const core::SeriesEntry* entry : candidates) {
        QCOMPARE(entry->slices(), 3);
        QVERIFY(entry->times.isEmpty());
    }
}

/// Whoever opens the folder of a plan means its images; the dose has a name of its own.
void FramesInARowTest::aDoseBesideImagesIsNoQuestion()
{
    const QTemporaryDir folder;
    test::SmallSeries series;
    series.size = {6, 5, 4};
    series.placeEvenly({0.0, 0.0, 0.0}, {0.0, 0.0, 2.0});
    static_cast<void>(series.write(folder.filePath(QStringLiteral("images"))));
    dose().write(folder.filePath(QStringLiteral("dose.dcm")));
    const core::Result<core::StudyListing> listing = core::scanStudies(folder.path());
    QVERIFY(listing);
    const std::vector<const core::SeriesEntry*> candidates = listing->candidates();
    QCOMPARE(candidates.size(), std::size_t(1));
    QCOMPARE(candidates.front()->slices(), 4);
    QString named;
    for (const core::StudyEntry& study : listing->studies) {
        for (const core::SeriesEntry& entry : study.series) {
            if (entry.isDose())
                named = entry.key;
        }
    }
    QVERIFY(!named.isEmpty());
    QCOMPARE(listing->matching(named).size(), std::size_t(1));
}

void FramesInARowTest::dosesWithoutAPlaceAreRefused_data()
{
    QTest::addColumn<QByteArray>("frames");
    QTest::addColumn<QByteArray>("offsets");
    QTest::addColumn<QString>("why");
    const QString each = QStringLiteral("nothing says where each of its 3 frames lies");
    QTest::newRow("too few") << QByteArray("3") << QByteArray("0\\3") << each;
    QTest::newRow("none") << QByteArray("3") << QByteArray() << each;
    // Its first frame is not all of it.
    QTest::newRow("an unreadable number of frames") << QByteArray(
        "1A") << QByteArray("0\\3\\6") << QStringLiteral("nothing says where its frames lie");
}

void FramesInARowTest::dosesWithoutAPlaceAreRefused()
{
    QFETCH(QByteArray, frames);
    QFETCH(QByteArray, offsets);
    QFETCH(QString, why);
    const QString refusal = refusalOf(dose([&](DcmDataset& set) {
        putText(set, DCM_NumberOfFrames, frames);
        putText(set, DCM_GridFrameOffsetVector, offsets);
    }));
    QVERIFY2(refusal.contains(why), qPrintable(refusal));
}

void FramesInARowTest::exportsLieWhereTheFramesLie_data()
{
    QTest::addColumn<bool>("isDose");
    QTest::newRow("dose") << true;
    QTest::newRow("nuclear medicine") << false;
}

/// A label map passes its check against the file, and against what a session keeps of it. DICOM
/// objects are refused: whoever follows their references finds every frame where the first one
/// lies.
void FramesInARowTest::exportsLieWhereTheFramesLie()
{
    QFETCH(bool, isDose);
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("row.dcm"));
    const RowFile written = isDose
        ? dose()
        : reconstruction([](DcmDataset& set) { putText(set, DCM_SpacingBetweenSlices, "-4"); });
    written.write(file);
    core::LoadedVolume loaded = test::openVolume(file);
    QCOMPARE(loaded.volume.sources.size(), std::size_t(written.frames));
    QVERIFY(core::dicomSegObstacle(loaded.volume).contains(QStringLiteral("one position")));

    const std::vector<std::uint8_t> labels(loaded.codes.size(), 1);
    core::Segment segment;
    segment.label = 1;
    segment.name = QStringLiteral("All");
    const core::ExportRequest request{.format = core::ExportFormat::Nifti,
        .file = folder.filePath(QStringLiteral("mask.nii")),
        .force = true,
        .segments = {segment},
        .planes = {{.plane = 0, .labels = labels}}};
    const auto exported = core::exportMask(loaded.volume, request, {});
    VERIFY_DONE(exported);
    const core::LoadedVolume mask = test::openVolume(request.file);
    const glm::dvec3 last(columns - 1, rows - 1, written.frames - 1);
    QVERIFY(glm::distance(mask.volume.geometry.toWorld(last), loaded.volume.geometry.toWorld(last))
        < 1e-3);

    const core::Result<core::KeptHeaders> kept = core::keepHeaders(loaded.volume.sources, {});
    QVERIFY(kept);
    loaded.volume.keptHeaders = std::make_shared<const core::KeptHeaders>(*kept);
    QVERIFY(QFile::remove(file));
    const auto without = core::exportMask(loaded.volume, request, {});
    VERIFY_DONE(without);
}

void FramesInARowTest::sharedDose()
{
    const test::SharedCase data = test::sharedCase(QStringLiteral("edge_pixels_colour"));
    if (data.source.isEmpty())
        QSKIP("the shared data are not there (BURIN_SHARED_DATA)");
    const core::LoadedVolume loaded =
        test::openVolume(data.source + QStringLiteral("/files/rtdose.dcm"));
    const core::Volume& volume = loaded.volume;
    QCOMPARE(volume.geometry.size, glm::ivec3(10, 10, 15));
    QVERIFY(glm::distance(volume.geometry.spacingMm(), glm::dvec3(10.0, 10.0, 5.0)) < 1e-9);
    QCOMPARE(volume.geometry.originLps(), glm::dvec3(189.43125, 199.43125, -761.87));
    // Its dose is a relative one.
    QCOMPARE(volume.unit, QString());
    QVERIFY(std::abs(volume.minimum - 0.795) <= volume.encoding.maxError + 1e-9);
    QVERIFY(std::abs(volume.maximum - 1.254) <= volume.encoding.maxError + 1e-9);
}

BURIN_TEST(FramesInARowTest)

} // namespace framesInARowTest

#include "FramesInARowTest.moc"
