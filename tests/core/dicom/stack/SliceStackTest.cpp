// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/stack/SlicePlaces.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/SyntheticSeries.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <memory>
#include <optional>

namespace sliceStackTest {

using core::VolumeProblem;
using test::SyntheticSeries;

namespace {

glm::dvec3 turned(const glm::dvec3& vector, double degrees)
{
    const double angle = glm::radians(degrees);
    return {vector.x, std::cos(angle) * vector.y - std::sin(angle) * vector.z,
        std::sin(angle) * vector.y + std::cos(angle) * vector.z};
}

/// Bytes that this thread has asked the system for; none if the system does not count them.
std::optional<qint64> bytesRead()
{
    QFile counters(QStringLiteral("/proc/thread-self/io"));
    if (!counters.open(QIODevice::ReadOnly))
        return std::nullopt;
    const QByteArray first = counters.readLine();
    return first.startsWith("rchar: ") ? std::optional(first.mid(7).trimmed().toLongLong())
                                       : std::nullopt;
}

/// The frames of two files that both say that they are the same object.
std::vector<core::SlicePlace> framesOfBoth(const QStringList& files, int frames)
{
    std::vector<core::ImageHeader> images;
    for (const QString& file : files) {
        for (int frame = 0; frame < frames; ++frame) {
            core::ImageHeader image;
            image.file = file;
            image.sopInstanceUid = QStringLiteral("2.25.1");
            image.frames = frames;
            image.frame = frame;
            image.position = glm::dvec3(0.0, 0.0, frame);
            image.plane = core::ImagePlane();
            image.spacing = glm::dvec2(1.0, 1.0);
            images.push_back(std::move(image));
        }
    }
    return core::sortIntoPlaces(std::move(images));
}

} // namespace

/// Series made to order: where every voxel lies, whatever is missing, doubled, uneven or tilted.
class SliceStackTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void placesEveryVoxel_data();
    void placesEveryVoxel();
    void tiltShearsTheGrid();
    void missingSlicesAreCounted();
    void unevenSpacingKeepsEveryPosition();
    void wanderingPositionsAreToldAsSuch();
    void duplicatesAreLeftOut();
    void contradictingDuplicateIsNamed();
    void duplicatesOfManyFramesAreReadOnce_data();
    void duplicatesOfManyFramesAreReadOnce();
    void singleImageSaysThatItsDepthIsAssumed();
    void phasesAreTimes();
    void quantitiesLieBesideEachOther_data();
    void quantitiesLieBesideEachOther();
    void unevenPhasesAreDoubtful();
    void planesAreCandidates();

private:
    [[nodiscard]] QString path(const QString& name = QStringLiteral("series")) const
    {
        return m_folder->filePath(name);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void SliceStackTest::placesEveryVoxel_data()
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

void SliceStackTest::placesEveryVoxel()
{
    QFETCH(glm::dvec3, row);
    QFETCH(glm::dvec3, column);
    QFETCH(double, direction);
    SyntheticSeries series;
    series.plane = {row, column};
    series.step = series.plane.normal() * (direction * 2.5);
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = test::openVolume(path());
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
            QCOMPARE(test::valueAt(loaded, {source.x, source.y, k}), series.value(source));
        }
    }
}

void SliceStackTest::tiltShearsTheGrid()
{
    SyntheticSeries series;
    series.plane.column = turned({0.0, 1.0, 0.0}, -12.0);
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = test::openVolume(path());
    QVERIFY(std::abs(loaded.volume.geometry.shearAngleDegrees() - 12.0) < 1e-6);
    QVERIFY(loaded.volume.geometry.slicePositions.empty());
    QVERIFY(test::hasProblem(loaded.volume.problems, VolumeProblem::Kind::Tilt));
    QVERIFY(loaded.volume.needsCaution());
    const glm::dvec3 last = loaded.volume.geometry.toWorld({0, 0, series.size.z - 1});
    QVERIFY(glm::length(last - series.position(series.size.z - 1)) < 1e-6);
}

void SliceStackTest::missingSlicesAreCounted()
{
    SyntheticSeries series;
    test::writeSeries(series, path());
    for (const int k : {3, 6, 7})
        QVERIFY(QFile::remove(path() + QLatin1Char('/') + series.fileName(k)));
    const core::LoadedVolume loaded = test::openVolume(path());
    QCOMPARE(loaded.volume.geometry.size.z, 7);
    const QString text =
        test::problemText(loaded.volume.problems, VolumeProblem::Kind::MissingSlices);
    QVERIFY2(text.startsWith(QLatin1String("3 slices are missing")), qPrintable(text));
    QVERIFY2(text.contains(QLatin1String("1 between slices 3 and 4")), qPrintable(text));
    QVERIFY2(text.contains(QLatin1String("2 between slices 5 and 6")), qPrintable(text));
    QVERIFY(loaded.volume.needsCaution());
    QCOMPARE(loaded.volume.geometry.slicePositions.size(), std::size_t(7));
    QCOMPARE(loaded.volume.geometry.slicePositions[3], series.position(4));
}

void SliceStackTest::unevenSpacingKeepsEveryPosition()
{
    SyntheticSeries series;
    double z = 0.0;
    for (int k = 0; k < series.size.z; ++k) {
        series.positions.emplace_back(1.0, 2.0, z);
        z += k < 5 ? 4.0 : 7.0;
    }
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = test::openVolume(path());
    const QString text =
        test::problemText(loaded.volume.problems, VolumeProblem::Kind::UnevenSpacing);
    QCOMPARE(text,
        QStringLiteral("The distance between slices varies from 4 to 7 mm: 4 mm between slices 1 "
                       "and 6, 7 mm between 6 and 10."));
    QVERIFY(loaded.volume.geometry.slicePositions == series.positions);
    QCOMPARE(loaded.volume.geometry.originLps(), series.positions.front());
    QCOMPARE(test::worstError(loaded, series), 0.0);
}

void SliceStackTest::wanderingPositionsAreToldAsSuch()
{
    SyntheticSeries series;
    for (int k = 0; k < series.size.z; ++k)
        series.positions.emplace_back(k == 4 ? 1.3 : 1.0, k == 7 ? 2.2 : 2.0, 3.0 * k);
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = test::openVolume(path());
    QCOMPARE(loaded.volume.problems.size(), std::size_t(1));
    QCOMPARE(test::problemText(loaded.volume.problems, VolumeProblem::Kind::UnevenSpacing),
        QStringLiteral("The positions of the slices wander sideways by up to 0.3 mm."));
    QVERIFY(loaded.volume.needsCaution());
    QVERIFY(loaded.volume.geometry.slicePositions == series.positions);
    QCOMPARE(test::worstError(loaded, series), 0.0);

    // Where distances differ as well, these are told.
    series.positions[9].z += 1.0;
    test::writeSeries(series, path(QStringLiteral("uneven")));
    const core::LoadedVolume uneven = test::openVolume(path(QStringLiteral("uneven")));
    const QString text =
        test::problemText(uneven.volume.problems, VolumeProblem::Kind::UnevenSpacing);
    QVERIFY2(text.startsWith(QLatin1String("The distance between slices varies from 3 to 4 mm")),
        qPrintable(text));
}

void SliceStackTest::duplicatesAreLeftOut()
{
    SyntheticSeries series;
    const QStringList files = test::writeSeries(series, path());
    QVERIFY(QFile::copy(files[4], path() + QStringLiteral("/copy of it")));
    const core::LoadedVolume loaded = test::openVolume(path());
    QCOMPARE(loaded.volume.geometry.size, series.size);
    QCOMPARE(test::worstError(loaded, series), 0.0);
    QVERIFY(test::hasProblem(loaded.volume.problems, VolumeProblem::Kind::DuplicateSlices));
    QVERIFY(!loaded.volume.needsCaution());
}

void SliceStackTest::contradictingDuplicateIsNamed()
{
    SyntheticSeries series;
    test::writeSeries(series, path());
    SyntheticSeries other = series;
    other.stored = [](const glm::ivec3&) { return 5; };
    const QStringList others = test::writeSeries(other, path(QStringLiteral("other")));
    QVERIFY(QFile::copy(others[4], path() + QStringLiteral("/zz_other")));
    const core::LoadedVolume loaded = test::openVolume(path());
    QCOMPARE(test::worstError(loaded, series), 0.0);
    const QString text =
        test::problemText(loaded.volume.problems, VolumeProblem::Kind::DuplicateSlices);
    QVERIFY2(text.contains(QLatin1String("zz_other")), qPrintable(text));
    QVERIFY(loaded.volume.needsCaution());
}

void SliceStackTest::duplicatesOfManyFramesAreReadOnce_data()
{
    QTest::addColumn<int>("second");
    QTest::addColumn<int>("filled");
    QTest::addColumn<qint64>("read");
    QTest::addColumn<QString>("said");
    constexpr int size = 1 << 20;
    QTest::newRow("the same bytes") << size << 0 << qint64(2 * size)
                                    << QStringLiteral("1 duplicate file was left out, of slices "
                                                      "1–50.");
    const QString others = QStringLiteral(
        "Files with the identity of another but other content were left out: b (slices 1–50).");
    QTest::newRow("other bytes") << size << 1 << qint64(2 * size) << others;
    QTest::newRow("another size") << size + 1 << 0 << qint64(0) << others;
}

void SliceStackTest::duplicatesOfManyFramesAreReadOnce()
{
    QFETCH(int, second);
    QFETCH(int, filled);
    QFETCH(qint64, read);
    QFETCH(QString, said);
    constexpr int frames = 50;
    const QStringList files{path(QStringLiteral("a")), path(QStringLiteral("b"))};
    const auto write = [](const QString& file, int size, int value) {
        QFile out(file);
        return out.open(QIODevice::WriteOnly) && out.write(QByteArray(size, char(value))) == size;
    };
    QVERIFY(write(files[0], 1 << 20, 0));
    QVERIFY(write(files[1], second, filled));
    std::vector<core::SlicePlace> places = framesOfBoth(files, frames);
    const std::optional<qint64> before = bytesRead();
    if (!before)
        QSKIP("the system does not count what is read");
    core::FileContents contents;
    const std::vector<VolumeProblem> problems = core::dropDuplicates(places, contents);
    const qint64 readNow = *bytesRead() - *before;
    // The counters themselves are read, too.
    QVERIFY2(readNow >= read && readNow < read + 4096, qPrintable(QString::number(readNow)));
    QCOMPARE(places.size(), std::size_t(frames));
    for (const core::SlicePlace& place : places)
        QCOMPARE(place.images.size(), std::size_t(1));
    QCOMPARE(test::problemText(problems, VolumeProblem::Kind::DuplicateSlices), said);
}

void SliceStackTest::singleImageSaysThatItsDepthIsAssumed()
{
    SyntheticSeries series;
    series.size.z = 1;
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = test::openVolume(path());
    QCOMPARE(loaded.volume.geometry.spacingMm().z, 9.0);
    QVERIFY(test::hasProblem(loaded.volume.problems, VolumeProblem::Kind::AssumedSpacing));
    QVERIFY(loaded.volume.needsCaution());
}

void SliceStackTest::phasesAreTimes()
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
    QCOMPARE(listing->candidates().size(), std::size_t(1));
    QCOMPARE(QStringList(listing->candidates().front()->times),
        (QStringList{QStringLiteral("trigger time 80 ms"), QStringLiteral("trigger time 160 ms")}));
    const core::LoadedVolume one = test::openVolume(path(), first.seriesUid);
    const core::LoadedVolume two = test::openVolume(path(), first.seriesUid + QStringLiteral("@2"));
    QCOMPARE(test::worstError(one, first), 0.0);
    QCOMPARE(test::worstError(two, second), 0.0);
    const QString text = test::problemText(two.volume.problems, VolumeProblem::Kind::MixedSlices);
    QVERIFY2(text.contains(QLatin1String("trigger time 160")), qPrintable(text));
}

void SliceStackTest::quantitiesLieBesideEachOther_data()
{
    QTest::addColumn<QStringList>("imageTypes");
    QTest::addColumn<QStringList>("echoTimes");
    QTest::addColumn<QStringList>("parts");
    QTest::addColumn<QList<int>>("times");
    using Texts = QStringList;
    const QString magnitude = QStringLiteral("ORIGINAL\\PRIMARY\\M_FFE\\M\\FFE");
    const QString fieldMap = QStringLiteral("ORIGINAL\\PRIMARY\\B0 MAP\\B0\\UNSPECIFIED");
    const QString phase = QStringLiteral("ORIGINAL\\PRIMARY\\P\\ND");
    const QString first = QStringLiteral("4.6");
    const QString second = QStringLiteral("6.9");
    const QString none = QStringLiteral("0");
    const Texts mapParts{QStringLiteral("magnitude"), QStringLiteral("field map")};
    QTest::newRow("field map with its magnitude")
        << Texts{magnitude, fieldMap} << Texts{first, none} << mapParts << QList<int>{0, 0};
    QTest::newRow("field map with the magnitude of two echoes") << Texts{magnitude, magnitude,
        fieldMap} << Texts{first, second, none} << mapParts << QList<int>{2, 0};
    QTest::newRow("magnitude and phase of two echoes")
        << Texts{magnitude, magnitude, phase, phase} << Texts{first, second, first, second}
        << Texts{QStringLiteral("magnitude"), QStringLiteral("phase")} << QList<int>{2, 2};
    QTest::newRow("a kind of image that says nothing of its quantity")
        << Texts{magnitude, QStringLiteral("ORIGINAL\\PRIMARY\\OTHER")} << Texts{first, second}
        << Texts{QString()} << QList<int>{2};
}

/// A field map is no later point in time than its magnitude, nor a phase.
void SliceStackTest::quantitiesLieBesideEachOther()
{
    QFETCH(QStringList, imageTypes);
    QFETCH(QStringList, echoTimes);
    QFETCH(QStringList, parts);
    QFETCH(QList<int>, times);
    SyntheticSeries series;
    series.modality = QStringLiteral("MR");
    for (qsizetype i = 0; i < imageTypes.size(); ++i) {
        series.fileName = [i](int k) { return QStringLiteral("%1-%2").arg(i).arg(k); };
        series.stored = [i](const glm::ivec3& index) { return index.z + int(i); };
        series.adjust = [&, i](DcmDataset& set, int k) {
            set.putAndInsertString(DCM_ImageType, imageTypes[i].toLatin1().constData());
            set.putAndInsertString(DCM_EchoTime, echoTimes[i].toLatin1().constData());
            set.putAndInsertString(
                DCM_InstanceNumber, QByteArray::number(100 * int(i) + k).constData());
            set.putAndInsertString(
                DCM_SOPInstanceUID, QByteArray::number(900 + 100 * int(i) + k).constData());
        };
        test::writeSeries(series, path());
    }
    const core::Result<core::StudyListing> listing = core::scanStudies(path());
    QVERIFY(listing);
    QStringList named;
    QList<int> points;
    for (const core::SeriesEntry* entry : listing->candidates()) {
        named.append(entry->part);
        points.append(int(entry->times.size()));
        QCOMPARE(entry->slices(), series.size.z);
        QVERIFY(core::loadVolume(path(), entry->key));
    }
    QCOMPARE(named, parts);
    QCOMPARE(points, times);
}

void SliceStackTest::unevenPhasesAreDoubtful()
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
                return problem.kind == VolumeProblem::Kind::DoubledSlices;
            });
        QVERIFY(mixed != entry->problems.end());
        QVERIFY(mixed->caution);
    }
    QCOMPARE(test::worstError(test::openVolume(path(), candidates[0]->key), series), 0.0);
}

void SliceStackTest::planesAreCandidates()
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

BURIN_TEST(SliceStackTest)

} // namespace sliceStackTest

#include "SliceStackTest.moc"
