// SPDX-License-Identifier: Apache-2.0
#include "core/study/StudyLoader.h"
#include "tests/support/SyntheticSeries.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

using core::VolumeProblem;
using test::SyntheticSeries;

namespace {

double valueAt(const core::LoadedVolume& loaded, const glm::ivec3& index)
{
    const glm::ivec3& size = loaded.volume.geometry.size;
    const std::size_t voxel = std::size_t(index.x)
        + std::size_t(size.x) * (std::size_t(index.y) + std::size_t(size.y) * std::size_t(index.z));
    return loaded.volume.encoding.value(loaded.codes.at(voxel));
}

/// Largest difference between what a series was made of and what was opened.
double worstError(const core::LoadedVolume& loaded, const SyntheticSeries& series)
{
    double worst = 0.0;
    for (int k = 0; k < series.size.z; ++k) {
        for (int j = 0; j < series.size.y; ++j) {
            for (int i = 0; i < series.size.x; ++i) {
                const double off = valueAt(loaded, {i, j, k}) - series.value({i, j, k});
                worst = std::max(worst, std::abs(off));
            }
        }
    }
    return worst;
}

QByteArray sha256(const SyntheticSeries& series)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    for (int k = 0; k < series.size.z; ++k) {
        for (int j = 0; j < series.size.y; ++j) {
            for (int i = 0; i < series.size.x; ++i) {
                const auto value = float(series.value({i, j, k}));
                hash.addData(QByteArrayView(reinterpret_cast<const char*>(&value), sizeof(value)));
            }
        }
    }
    return hash.result().toHex();
}

bool has(const std::vector<VolumeProblem>& problems, VolumeProblem::Kind kind)
{
    return std::any_of(problems.begin(), problems.end(),
        [&](const VolumeProblem& problem) { return problem.kind == kind; });
}

QString textOf(const std::vector<VolumeProblem>& problems, VolumeProblem::Kind kind)
{
    for (const VolumeProblem& problem : problems) {
        if (problem.kind == kind)
            return problem.text;
    }
    return {};
}

QString why(const core::Error& error)
{
    return QStringLiteral("%1: %2")
        .arg(int(error.code))
        .arg(error.arguments.join(QLatin1Char('|')));
}

core::LoadedVolume open(const QString& path, const QString& series = QString())
{
    core::Result<core::LoadedVolume> loaded = core::loadVolume(path, series);
    if (!loaded)
        qWarning() << why(loaded.error());
    return loaded ? std::move(*loaded) : core::LoadedVolume();
}

glm::dvec3 turned(const glm::dvec3& vector, double degrees)
{
    const double angle = glm::radians(degrees);
    return {vector.x, std::cos(angle) * vector.y - std::sin(angle) * vector.z,
        std::sin(angle) * vector.y + std::cos(angle) * vector.z};
}

} // namespace

/// Series made to order: whatever their defects, they open as what they are, or with one clear
/// word.
class StudyLoaderTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void opensWhatWasWritten_data();
    void opensWhatWasWritten();
    void placesEveryVoxel_data();
    void placesEveryVoxel();
    void identityAndSources();
    void frameOfReferenceIsSharedOrNone();
    void tiltShearsTheGrid();
    void missingSlicesAreCounted();
    void unevenSpacingKeepsEveryPosition();
    void duplicatesAreLeftOut();
    void contradictingDuplicateIsNamed();
    void singleImageSaysThatItsDepthIsAssumed();
    void phasesStayApart();
    void planesAreCandidates();
    void localizerInsideASeriesIsApart();
    void foreignObjectsAreNoError();
    void rescalePerSliceIsOnACommonScale();
    void negativeSlopeKeepsTheOrderOfValues();
    void invertedDisplayLeavesValues();
    void windowComesFromTheFileWhereValid();
    void unitIsHounsfieldOnlyForCt();
    void missingUidsGetAStableName();
    void unknownTransferSyntaxIsNamed();
    void seriesIsChosenNotGuessed();
    void cutSliceIsLeftOutAndNamed();
    void badPathsAreClear();
    void cancelStops();
    void nestedSequencesAreRefused();
    void multiFrameIsReported();
    void directoryFileStandsForItsFolder();
    void unevenPhasesAreDoubtful();

private:
    [[nodiscard]] QString path(const QString& name = QStringLiteral("series")) const
    {
        return m_folder->filePath(name);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void StudyLoaderTest::opensWhatWasWritten_data()
{
    QTest::addColumn<int>("allocated");
    QTest::addColumn<int>("stored");
    QTest::addColumn<int>("highBit");
    QTest::addColumn<bool>("isSigned");
    QTest::addColumn<bool>("dirty");
    QTest::addColumn<QString>("syntax");
    const char* implicitLe = "1.2.840.10008.1.2";
    const char* explicitLe = "1.2.840.10008.1.2.1";
    const char* deflated = "1.2.840.10008.1.2.1.99";
    const char* explicitBe = "1.2.840.10008.1.2.2";
    const char* rle = "1.2.840.10008.1.2.5";
    const char* lossless = "1.2.840.10008.1.2.4.70";
    const char* jpegLs = "1.2.840.10008.1.2.4.80";
    const auto row = [](const char* name, int allocated, int stored, int highBit, bool isSigned,
                         bool dirty, const char* syntax) {
        QTest::newRow(name) << allocated << stored << highBit << isSigned << dirty
                            << QString::fromLatin1(syntax);
    };
    row("12 of 16", 16, 12, 11, false, false, explicitLe);
    row("12 of 16, implicit", 16, 12, 11, false, false, implicitLe);
    row("12 of 16, big endian", 16, 12, 11, false, false, explicitBe);
    row("12 of 16, deflated", 16, 12, 11, false, false, deflated);
    row("signed 12, dirty", 16, 12, 11, true, true, explicitLe);
    row("signed 12, dirty, big endian", 16, 12, 11, true, true, explicitBe);
    row("unsigned 12 on top, dirty", 16, 12, 15, false, true, explicitLe);
    row("signed 12 in the middle, dirty", 16, 12, 13, true, true, explicitLe);
    row("signed 16", 16, 16, 15, true, false, explicitLe);
    row("unsigned 16", 16, 16, 15, false, false, explicitLe);
    row("8 bits", 8, 8, 7, false, false, explicitLe);
    row("8 bits, big endian", 8, 8, 7, false, false, explicitBe);
    row("signed 8 bits", 8, 8, 7, true, false, explicitLe);
    row("6 of 8 bits, dirty", 8, 6, 5, false, true, explicitLe);
    row("RLE", 16, 12, 11, false, false, rle);
    row("RLE, dirty, signed", 16, 12, 11, true, true, rle);
    row("RLE, 8 bits", 8, 8, 7, false, false, rle);
    row("JPEG lossless", 16, 12, 11, false, false, lossless);
    row("JPEG lossless, 16 bits", 16, 16, 15, false, false, lossless);
    row("JPEG lossless, signed", 16, 16, 15, true, false, lossless);
    row("JPEG-LS", 16, 12, 11, false, false, jpegLs);
    row("JPEG-LS, 16 bits", 16, 16, 15, false, false, jpegLs);
    row("JPEG-LS, signed", 16, 16, 15, true, false, jpegLs);
    row("JPEG-LS, 8 bits", 8, 8, 7, false, false, jpegLs);
}

void StudyLoaderTest::opensWhatWasWritten()
{
    QFETCH(int, allocated);
    QFETCH(int, stored);
    QFETCH(int, highBit);
    QFETCH(bool, isSigned);
    QFETCH(bool, dirty);
    QFETCH(QString, syntax);
    SyntheticSeries series;
    series.layout.bitsAllocated = allocated;
    series.layout.bitsStored = stored;
    series.layout.highBit = highBit;
    series.layout.isSigned = isSigned;
    series.dirtySpareBits = dirty;
    series.transferSyntaxUid = syntax;
    const int range = 1 << stored;
    series.stored = [=](const glm::ivec3& index) {
        const int value = (index.x * 977 + index.y * 3931 + index.z * 211) % range;
        return isSigned ? value - range / 2 : value;
    };
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = open(path());
    QCOMPARE(loaded.volume.geometry.size, series.size);
    QCOMPARE(loaded.volume.encoding.maxError, 0.0);
    QCOMPARE(worstError(loaded, series), 0.0);
    QCOMPARE(loaded.volume.voxelsSha256, sha256(series));
    QVERIFY(loaded.volume.problems.empty());
}

void StudyLoaderTest::placesEveryVoxel_data()
{
    QTest::addColumn<glm::dvec3>("row");
    QTest::addColumn<glm::dvec3>("column");
    QTest::addColumn<double>("direction");
    using V = glm::dvec3;
    QTest::newRow("supine") << V(1, 0, 0) << V(0, 1, 0) << 1.0;
    QTest::newRow("prone") << V(-1, 0, 0) << V(0, -1, 0) << 1.0;
    QTest::newRow("written from top to bottom") << V(1, 0, 0) << V(0, 1, 0) << -1.0;
    QTest::newRow("sagittal") << V(0, 1, 0) << V(0, 0, -1) << 1.0;
    QTest::newRow("coronal") << V(1, 0, 0) << V(0, 0, -1) << -1.0;
    QTest::newRow("oblique") << V(1, 0, 0) << turned(V(0, 1, 0), 25.0) << 1.0;
}

void StudyLoaderTest::placesEveryVoxel()
{
    QFETCH(glm::dvec3, row);
    QFETCH(glm::dvec3, column);
    QFETCH(double, direction);
    SyntheticSeries series;
    series.plane = {row, column};
    series.step = series.plane.normal() * (direction * 2.5);
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = open(path());
    const core::VolumeGeometry& geometry = loaded.volume.geometry;
    QVERIFY(loaded.volume.problems.empty());
    QVERIFY(geometry.slicePositions.empty());
    QVERIFY(glm::determinant(glm::dmat3(geometry.indexToWorld)) > 0.0);
    for (int k = 0; k < series.size.z; ++k) {
        // Slices are sorted along row × column, whichever way they were written.
        const int written = direction > 0.0 ? k : series.size.z - 1 - k;
        for (const glm::dvec2 pixel : {glm::dvec2(0, 0), glm::dvec2(23, 5), glm::dvec2(4, 17)}) {
            const glm::dvec3 expected = series.position(written)
                + row * (series.spacing.x * pixel.x) + column * (series.spacing.y * pixel.y);
            const glm::dvec3 found = geometry.toWorld({pixel.x, pixel.y, k});
            QVERIFY(glm::length(found - expected) < 1e-6);
            const glm::ivec3 source(int(pixel.x), int(pixel.y), written);
            QCOMPARE(valueAt(loaded, {source.x, source.y, k}), series.value(source));
        }
    }
}

void StudyLoaderTest::identityAndSources()
{
    SyntheticSeries series;
    series.adjust = [](DcmDataset& set, int) {
        set.putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 100");
        set.putAndInsertString(DCM_PatientName, "M\xfcller^J\xf6rg");
    };
    const QStringList files = test::writeSeries(series, path());
    const core::LoadedVolume loaded = open(path());
    const core::StudyIdentity& identity = loaded.volume.identity;
    QCOMPARE(identity.patientName, QStringLiteral("Müller^Jörg"));
    QCOMPARE(identity.patientId, QStringLiteral("SYN1"));
    QCOMPARE(identity.birthDate, QStringLiteral("1970-01-02"));
    QCOMPARE(identity.studyDate, QStringLiteral("2024-01-31"));
    QCOMPARE(identity.seriesUid, series.seriesUid);
    QCOMPARE(identity.modality, QStringLiteral("CT"));
    QCOMPARE(loaded.volume.sources.size(), std::size_t(series.size.z));
    for (int k = 0; k < series.size.z; ++k) {
        const core::SourceSlice& source = loaded.volume.sources[std::size_t(k)];
        QCOMPARE(source.file, files[k]);
        QCOMPARE(source.instanceNumber, series.size.z - k);
        QCOMPARE(source.sopInstanceUid, QStringLiteral("%1.%2").arg(series.seriesUid).arg(k + 1));
    }
}

void StudyLoaderTest::frameOfReferenceIsSharedOrNone()
{
    SyntheticSeries series;
    test::writeSeries(series, path());
    QCOMPARE(open(path()).volume.identity.frameOfReferenceUid, QStringLiteral("2.25.4713"));

    series.adjust = [](DcmDataset& set, int k) {
        set.putAndInsertString(
            DCM_FrameOfReferenceUID, ("2.25.9." + QByteArray::number(k + 1)).constData());
    };
    test::writeSeries(series, path(QStringLiteral("each its own")));
    const core::LoadedVolume loaded = open(path(QStringLiteral("each its own")));
    QCOMPARE(worstError(loaded, series), 0.0);
    QCOMPARE(loaded.volume.identity.frameOfReferenceUid, QString());
    QVERIFY(!loaded.volume.problems.empty());

    series.adjust = [](DcmDataset& set, int k) {
        set.putAndInsertString(DCM_FrameOfReferenceUID, k < 4 ? "2.25.5" : "2.25.6");
    };
    test::writeSeries(series, path(QStringLiteral("two")));
    const core::Result<core::StudyListing> listing = core::scanStudies(path(QStringLiteral("two")));
    QVERIFY(listing);
    QCOMPARE(listing->candidates().size(), std::size_t(2));
}

void StudyLoaderTest::tiltShearsTheGrid()
{
    SyntheticSeries series;
    series.plane.column = turned({0.0, 1.0, 0.0}, -12.0);
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = open(path());
    QVERIFY(std::abs(loaded.volume.geometry.shearAngleDegrees() - 12.0) < 1e-6);
    QVERIFY(loaded.volume.geometry.slicePositions.empty());
    QVERIFY(has(loaded.volume.problems, VolumeProblem::Kind::Tilt));
    QVERIFY(loaded.volume.needsCaution());
    const glm::dvec3 last = loaded.volume.geometry.toWorld({0, 0, series.size.z - 1});
    QVERIFY(glm::length(last - series.position(series.size.z - 1)) < 1e-6);
}

void StudyLoaderTest::missingSlicesAreCounted()
{
    SyntheticSeries series;
    test::writeSeries(series, path());
    for (const int k : {3, 6, 7})
        QVERIFY(QFile::remove(path() + QLatin1Char('/') + series.fileName(k)));
    const core::LoadedVolume loaded = open(path());
    QCOMPARE(loaded.volume.geometry.size.z, 7);
    const QString text = textOf(loaded.volume.problems, VolumeProblem::Kind::MissingSlices);
    QVERIFY2(text.startsWith(QLatin1String("3 slices are missing")), qPrintable(text));
    QVERIFY2(text.contains(QLatin1String("1 between slices 3 and 4")), qPrintable(text));
    QVERIFY2(text.contains(QLatin1String("2 between slices 5 and 6")), qPrintable(text));
    QVERIFY(loaded.volume.needsCaution());
    QCOMPARE(loaded.volume.geometry.slicePositions.size(), std::size_t(7));
    QCOMPARE(loaded.volume.geometry.slicePositions[3], series.position(4));
}

void StudyLoaderTest::unevenSpacingKeepsEveryPosition()
{
    SyntheticSeries series;
    double z = 0.0;
    for (int k = 0; k < series.size.z; ++k) {
        series.positions.emplace_back(1.0, 2.0, z);
        z += k < 5 ? 4.0 : 7.0;
    }
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = open(path());
    const QString text = textOf(loaded.volume.problems, VolumeProblem::Kind::UnevenSpacing);
    QCOMPARE(text, QStringLiteral("The distance between slices varies from 4 to 7 mm."));
    QVERIFY(loaded.volume.geometry.slicePositions == series.positions);
    QCOMPARE(loaded.volume.geometry.originLps(), series.positions.front());
    QCOMPARE(worstError(loaded, series), 0.0);
}

void StudyLoaderTest::duplicatesAreLeftOut()
{
    SyntheticSeries series;
    const QStringList files = test::writeSeries(series, path());
    QVERIFY(QFile::copy(files[4], path() + QStringLiteral("/copy of it")));
    const core::LoadedVolume loaded = open(path());
    QCOMPARE(loaded.volume.geometry.size, series.size);
    QCOMPARE(worstError(loaded, series), 0.0);
    QVERIFY(has(loaded.volume.problems, VolumeProblem::Kind::DuplicateSlices));
    QVERIFY(!loaded.volume.needsCaution());
}

void StudyLoaderTest::contradictingDuplicateIsNamed()
{
    SyntheticSeries series;
    test::writeSeries(series, path());
    SyntheticSeries other = series;
    other.stored = [](const glm::ivec3&) { return 5; };
    const QStringList others = test::writeSeries(other, path(QStringLiteral("other")));
    QVERIFY(QFile::copy(others[4], path() + QStringLiteral("/zz_other")));
    const core::LoadedVolume loaded = open(path());
    QCOMPARE(worstError(loaded, series), 0.0);
    const QString text = textOf(loaded.volume.problems, VolumeProblem::Kind::DuplicateSlices);
    QVERIFY2(text.contains(QLatin1String("zz_other")), qPrintable(text));
    QVERIFY(loaded.volume.needsCaution());
}

void StudyLoaderTest::singleImageSaysThatItsDepthIsAssumed()
{
    SyntheticSeries series;
    series.size.z = 1;
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = open(path());
    QCOMPARE(loaded.volume.geometry.spacingMm().z, 9.0);
    QVERIFY(has(loaded.volume.problems, VolumeProblem::Kind::AssumedSpacing));
    QVERIFY(loaded.volume.needsCaution());
}

void StudyLoaderTest::phasesStayApart()
{
    SyntheticSeries first;
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
    const core::Result<core::StudyListing> listing = core::scanStudies(path());
    QVERIFY(listing);
    QCOMPARE(listing->candidates().size(), std::size_t(2));
    const core::LoadedVolume one = open(path(), first.seriesUid + QStringLiteral("#1"));
    const core::LoadedVolume two = open(path(), first.seriesUid + QStringLiteral("#2"));
    QCOMPARE(worstError(one, first), 0.0);
    QCOMPARE(worstError(two, second), 0.0);
    const QString text = textOf(two.volume.problems, VolumeProblem::Kind::MixedSlices);
    QVERIFY2(text.contains(QLatin1String("trigger time 160")), qPrintable(text));
}

void StudyLoaderTest::planesAreCandidates()
{
    SyntheticSeries axial;
    SyntheticSeries sagittal;
    sagittal.plane = {{0.0, 1.0, 0.0}, {0.0, 0.0, -1.0}};
    sagittal.step = {-2.5, 0.0, 0.0};
    sagittal.fileName = [](int k) { return QStringLiteral("s%1").arg(k); };
    test::writeSeries(axial, path());
    test::writeSeries(sagittal, path());
    const core::Result<core::LoadedVolume> guessed = core::loadVolume(path(), axial.seriesUid);
    QVERIFY(!guessed);
    QCOMPARE(guessed.error().code, core::ErrorCode::SeriesAmbiguous);
    const core::Result<core::StudyListing> listing = core::scanStudies(path());
    QVERIFY(listing);
    for (const core::SeriesEntry* entry : listing->candidates()) {
        QCOMPARE(entry->slices(), axial.size.z);
        QVERIFY(entry->problems.empty());
        QVERIFY(core::loadVolume(path(), entry->key));
    }
}

void StudyLoaderTest::localizerInsideASeriesIsApart()
{
    SyntheticSeries series;
    test::writeSeries(series, path());
    SyntheticSeries scout = series;
    scout.size = {32, 32, 1};
    scout.plane = {{1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}};
    scout.fileName = [](int) { return QStringLiteral("scout"); };
    scout.adjust = [](DcmDataset& set, int) {
        set.putAndInsertString(DCM_ImageType, "ORIGINAL\\PRIMARY\\LOCALIZER");
    };
    test::writeSeries(scout, path());
    const core::Result<core::StudyListing> listing = core::scanStudies(path());
    QVERIFY(listing);
    QCOMPARE(listing->foreign.size(), std::size_t(1));
    QCOMPARE(listing->foreign.front().kind, QStringLiteral("localizer"));
    QCOMPARE(worstError(open(path()), series), 0.0);
}

void StudyLoaderTest::foreignObjectsAreNoError()
{
    SyntheticSeries series;
    test::writeSeries(series, path());
    for (const char* sopClass : {"1.2.840.10008.5.1.4.1.1.66.4", "1.2.840.10008.5.1.4.1.1.481.3",
             "1.2.840.10008.5.1.4.1.1.88.22", "1.2.840.10008.5.1.4.1.1.11.1"}) {
        SyntheticSeries other = series;
        other.size.z = 1;
        other.fileName = [=](int) { return QString::fromLatin1(sopClass); };
        other.adjust = [=](DcmDataset& set, int) {
            set.putAndInsertString(DCM_SOPClassUID, sopClass);
        };
        test::writeSeries(other, path());
    }
    QFile notes(path() + QStringLiteral("/notes.txt"));
    QVERIFY(notes.open(QIODevice::WriteOnly) && notes.write("These are no pictures at all.") > 0);
    notes.close();
    const core::Result<core::StudyListing> listing = core::scanStudies(path());
    QVERIFY(listing);
    QCOMPARE(listing->candidates().size(), std::size_t(1));
    QCOMPARE(listing->foreign.size(), std::size_t(4));
    QCOMPARE(listing->unreadable.size(), std::size_t(1));
    QVERIFY(listing->unreadable.front().file.endsWith(QLatin1String("notes.txt")));
    QCOMPARE(worstError(open(path()), series), 0.0);
}

void StudyLoaderTest::rescalePerSliceIsOnACommonScale()
{
    SyntheticSeries series;
    series.modality = QStringLiteral("PT");
    series.slope = [](int k) { return 0.25 + 0.37 * k; };
    series.intercept = [](int) { return 0.0; };
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = open(path());
    QVERIFY(loaded.volume.encoding.maxError > 0.0);
    QVERIFY(worstError(loaded, series) <= loaded.volume.encoding.maxError);
    QVERIFY(loaded.volume.encoding.maxError <= loaded.volume.maximum / 65535.0);
    QVERIFY(has(loaded.volume.problems, VolumeProblem::Kind::InexactValues));
    QCOMPARE(loaded.volume.voxelsSha256, sha256(series));
    QCOMPARE(loaded.volume.unit, QString());
}

void StudyLoaderTest::negativeSlopeKeepsTheOrderOfValues()
{
    SyntheticSeries series;
    series.slope = [](int) { return -0.5; };
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = open(path());
    QCOMPARE(loaded.volume.encoding.maxError, 0.0);
    QVERIFY(loaded.volume.encoding.value(1) > loaded.volume.encoding.value(0));
    QCOMPARE(worstError(loaded, series), 0.0);
    QCOMPARE(loaded.volume.voxelsSha256, sha256(series));
}

void StudyLoaderTest::invertedDisplayLeavesValues()
{
    SyntheticSeries series;
    series.layout.photometric = QStringLiteral("MONOCHROME1");
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = open(path());
    QVERIFY(loaded.volume.displayInverted);
    QCOMPARE(worstError(loaded, series), 0.0);
}

void StudyLoaderTest::windowComesFromTheFileWhereValid()
{
    SyntheticSeries series;
    series.adjust = [](DcmDataset& set, int) {
        set.putAndInsertString(DCM_WindowCenter, "-0450\\40");
        set.putAndInsertString(DCM_WindowWidth, "+1600\\400");
    };
    test::writeSeries(series, path());
    QCOMPARE(open(path()).volume.defaultWindow, (core::WindowLevel{-450.0, 1600.0}));

    series.adjust = [](DcmDataset& set, int) {
        set.putAndInsertString(DCM_WindowCenter, "40");
        set.putAndInsertString(DCM_WindowWidth, "0");
    };
    test::writeSeries(series, path(QStringLiteral("invalid")));
    const core::Volume volume = open(path(QStringLiteral("invalid"))).volume;
    QVERIFY(volume.defaultWindow.width > 1.0);
    QVERIFY(volume.defaultWindow.centre > volume.minimum);
    QVERIFY(volume.defaultWindow.centre < volume.maximum);
    const std::vector<std::uint32_t>& counts = volume.histogram.counts;
    QCOMPARE(counts.size(), std::size_t(256));
    QCOMPARE(std::accumulate(counts.begin(), counts.end(), std::uint64_t(0)),
        std::uint64_t(volume.geometry.voxelCount()));
}

void StudyLoaderTest::unitIsHounsfieldOnlyForCt()
{
    SyntheticSeries series;
    test::writeSeries(series, path());
    QCOMPARE(open(path()).volume.unit, QStringLiteral("HU"));
    series.modality = QStringLiteral("MR");
    test::writeSeries(series, path(QStringLiteral("mr")));
    QCOMPARE(open(path(QStringLiteral("mr"))).volume.unit, QString());
    series.modality = QStringLiteral("CT");
    series.adjust = [](DcmDataset& set, int) { set.putAndInsertString(DCM_RescaleType, "US"); };
    test::writeSeries(series, path(QStringLiteral("us")));
    QCOMPARE(open(path(QStringLiteral("us"))).volume.unit, QString());
}

void StudyLoaderTest::missingUidsGetAStableName()
{
    SyntheticSeries series;
    series.adjust = [](DcmDataset& set, int) {
        for (const DcmTagKey& key : {DCM_StudyInstanceUID, DCM_SeriesInstanceUID,
                 DCM_SOPInstanceUID, DCM_SOPClassUID, DCM_PatientName, DCM_FrameOfReferenceUID})
            set.findAndDeleteElement(key);
    };
    test::writeSeries(series, path());
    const core::Result<core::StudyListing> listing = core::scanStudies(path());
    QVERIFY(listing);
    QCOMPARE(listing->candidates().size(), std::size_t(1));
    const QString key = listing->candidates().front()->key;
    QVERIFY(!key.isEmpty());
    test::writeSeries(series, path(QStringLiteral("again")));
    const core::LoadedVolume loaded = open(path(QStringLiteral("again")), key);
    QCOMPARE(worstError(loaded, series), 0.0);
    QVERIFY(loaded.volume.identity.seriesUid.isEmpty());
}

void StudyLoaderTest::unknownTransferSyntaxIsNamed()
{
    SyntheticSeries series;
    series.size.z = 2;
    for (const QString& file : test::writeSeries(series, path())) {
        // The UID of JPEG XL lossless in place of Explicit VR Little Endian.
        QFile bytes(file);
        QVERIFY(bytes.open(QIODevice::ReadWrite));
        QByteArray content = bytes.readAll();
        const qsizetype at = content.indexOf("1.2.840.10008.1.2.1");
        QVERIFY(at > 0);
        content[at + 18] = '7';
        bytes.seek(0);
        bytes.write(content);
    }
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(path());
    QVERIFY(!loaded);
    QCOMPARE(loaded.error().code, core::ErrorCode::UnsupportedFormat);
    QVERIFY2(loaded.error().arguments.value(1).contains(QLatin1String("1.2.840.10008.1.2.7")),
        qPrintable(why(loaded.error())));
}

void StudyLoaderTest::seriesIsChosenNotGuessed()
{
    SyntheticSeries one;
    SyntheticSeries two;
    two.seriesUid = QStringLiteral("2.25.999");
    two.stored = [](const glm::ivec3& index) { return index.x; };
    test::writeSeries(one, path() + QStringLiteral("/one"));
    test::writeSeries(two, path() + QStringLiteral("/deeper/two"));
    const core::Result<core::LoadedVolume> guessed = core::loadVolume(path());
    QVERIFY(!guessed);
    QCOMPARE(guessed.error().code, core::ErrorCode::SeriesAmbiguous);
    QCOMPARE(guessed.error().arguments.size(), 3);
    for (const QString& line : guessed.error().arguments.mid(1)) {
        QVERIFY2(line.contains(QLatin1String("Synthetic^Subject")), qPrintable(line));
        QVERIFY2(line.contains(QLatin1String("2024-01-31")), qPrintable(line));
        QVERIFY2(line.contains(QLatin1String("Made to order")), qPrintable(line));
        QVERIFY2(line.contains(QLatin1String("10 slices")), qPrintable(line));
    }
    QCOMPARE(worstError(open(path(), two.seriesUid), two), 0.0);
    QCOMPARE(worstError(open(path(), one.seriesUid), one), 0.0);
    const core::Result<core::LoadedVolume> wrong =
        core::loadVolume(path(), QStringLiteral("2.25.1"));
    QVERIFY(!wrong);
    QCOMPARE(wrong.error().code, core::ErrorCode::SeriesNotFound);
}

void StudyLoaderTest::cutSliceIsLeftOutAndNamed()
{
    for (const char* syntax : {"1.2.840.10008.1.2.1", "1.2.840.10008.1.2.4.70"}) {
        const QString folder = path(QString::fromLatin1(syntax));
        SyntheticSeries series;
        series.transferSyntaxUid = QString::fromLatin1(syntax);
        const QStringList files = test::writeSeries(series, folder);
        QFile cut(files[4]);
        QVERIFY(cut.resize(cut.size() - 100));
        const core::LoadedVolume loaded = open(folder);
        QCOMPARE(loaded.volume.geometry.size.z, series.size.z - 1);
        const QString text = textOf(loaded.volume.problems, VolumeProblem::Kind::DamagedSlice);
        QVERIFY2(text.contains(series.fileName(4)), qPrintable(text));
        QVERIFY(has(loaded.volume.problems, VolumeProblem::Kind::MissingSlices));
        QCOMPARE(valueAt(loaded, {3, 5, 4}), series.value({3, 5, 5}));
    }
}

void StudyLoaderTest::badPathsAreClear()
{
    const auto codeOf = [](const QString& where) {
        const core::Result<core::LoadedVolume> loaded = core::loadVolume(where);
        return loaded ? core::ErrorCode::Internal : loaded.error().code;
    };
    QCOMPARE(codeOf(path(QStringLiteral("nowhere"))), core::ErrorCode::FileNotFound);
    QVERIFY(QDir().mkpath(path(QStringLiteral("empty"))));
    QCOMPARE(codeOf(path(QStringLiteral("empty"))), core::ErrorCode::FolderEmpty);
    QVERIFY(QDir().mkpath(path(QStringLiteral("texts"))));
    for (const char* name : {"texts/a.txt", "texts/b.txt"}) {
        QFile text(path(QString::fromLatin1(name)));
        QVERIFY(text.open(QIODevice::WriteOnly) && text.write("nothing of the kind, really") > 0);
    }
    QCOMPARE(codeOf(path(QStringLiteral("texts"))), core::ErrorCode::NoImages);
    QCOMPARE(codeOf(path(QStringLiteral("texts/a.txt"))), core::ErrorCode::UnsupportedFormat);
    QFile zero(path(QStringLiteral("zero.dcm")));
    QVERIFY(zero.open(QIODevice::WriteOnly));
    zero.close();
    QCOMPARE(codeOf(zero.fileName()), core::ErrorCode::FileTruncated);
    SyntheticSeries series;
    QFile header(test::writeSeries(series, path()).front());
    QVERIFY(header.resize(500));
    QCOMPARE(codeOf(header.fileName()), core::ErrorCode::FileTruncated);
}

void StudyLoaderTest::cancelStops()
{
    SyntheticSeries series;
    test::writeSeries(series, path());
    core::Progress* running = nullptr;
    int reports = 0;
    core::Progress progress([&](const QString& step, int, int) {
        ++reports;
        if (step == QLatin1String("Reading slices"))
            running->cancel();
    });
    running = &progress;
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(path(), QString(), progress);
    QVERIFY(!loaded);
    QCOMPARE(loaded.error().code, core::ErrorCode::Cancelled);
    QVERIFY(reports > series.size.z);
}

void StudyLoaderTest::nestedSequencesAreRefused()
{
    SyntheticSeries series;
    series.size.z = 1;
    QFile file(test::writeSeries(series, path()).front());
    QVERIFY(file.open(QIODevice::ReadWrite));
    QByteArray content = file.readAll();
    // ContentSequence (0040,A730) in itself, 20000 times, before the pixel data.
    const QByteArray item = QByteArray::fromHex("feff00e0ffffffff");
    QByteArray nested;
    for (int level = 0; level < 20000; ++level)
        nested += QByteArray::fromHex("400030a753510000ffffffff") + item;
    const qsizetype pixels = content.lastIndexOf(QByteArray::fromHex("e07f1000"));
    QVERIFY(pixels > 0);
    content.insert(pixels, nested);
    file.seek(0);
    file.write(content);
    file.close();
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(file.fileName());
    QVERIFY(!loaded);
    QVERIFY2(loaded.error().arguments.value(1).contains(QLatin1String("nested")),
        qPrintable(why(loaded.error())));
}

void StudyLoaderTest::multiFrameIsReported()
{
    SyntheticSeries series;
    series.size = {8, 8, 1};
    series.adjust = [](DcmDataset& set, int) { set.putAndInsertString(DCM_NumberOfFrames, "4"); };
    test::writeSeries(series, path());
    const core::Result<core::StudyListing> listing = core::scanStudies(path());
    QVERIFY(listing);
    QVERIFY(listing->candidates().empty());
    QCOMPARE(listing->foreign.front().kind, QStringLiteral("multi-frame image"));
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(path());
    QVERIFY(!loaded);
    QCOMPARE(loaded.error().code, core::ErrorCode::NoImages);
    QVERIFY2(loaded.error().arguments.value(1).contains(QLatin1String("multi-frame")),
        qPrintable(why(loaded.error())));
}

void StudyLoaderTest::directoryFileStandsForItsFolder()
{
    SyntheticSeries series;
    test::writeSeries(series, path() + QStringLiteral("/IMAGES"));
    QFile directory(path() + QStringLiteral("/DICOMDIR"));
    QVERIFY(directory.open(QIODevice::WriteOnly));
    directory.close();
    QCOMPARE(worstError(open(directory.fileName()), series), 0.0);
}

void StudyLoaderTest::unevenPhasesAreDoubtful()
{
    SyntheticSeries series;
    test::writeSeries(series, path());
    SyntheticSeries more = series;
    more.size.z = 4;
    more.fileName = [](int k) { return QStringLiteral("more%1").arg(k); };
    more.adjust = [](DcmDataset& set, int k) {
        set.putAndInsertString(DCM_SOPInstanceUID, QByteArray::number(700 + k).constData());
        set.putAndInsertString(DCM_InstanceNumber, "99");
    };
    test::writeSeries(more, path());
    const core::Result<core::StudyListing> listing = core::scanStudies(path());
    QVERIFY(listing);
    const std::vector<const core::SeriesEntry*> candidates = listing->candidates();
    QCOMPARE(candidates.size(), std::size_t(2));
    QCOMPARE(candidates[0]->slices() + candidates[1]->slices(), 14);
    for (const core::SeriesEntry* entry : candidates) {
        const auto mixed = std::find_if(
            entry->problems.begin(), entry->problems.end(), [](const VolumeProblem& problem) {
                return problem.kind == VolumeProblem::Kind::MixedSlices;
            });
        QVERIFY(mixed != entry->problems.end());
        QVERIFY(mixed->caution);
    }
    QCOMPARE(worstError(open(path(), candidates[0]->key), series), 0.0);
}

QTEST_GUILESS_MAIN(StudyLoaderTest)
#include "StudyLoaderTest.moc"
