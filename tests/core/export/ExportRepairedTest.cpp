// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/objects/RtStructFile.h"
#include "core/dicom/objects/SegReader.h"
#include "core/export/CarvedVolume.h"
#include "core/export/common/ExportMask.h"
#include "core/repair/RepairVolume.h"
#include "core/repair/SeriesRepair.h"
#include "core/repair/WayBack.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/Affine.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/defective/DefectiveSeries.h"
#include "ui/texts/ReportTexts.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <memory>
#include <set>

namespace exportRepairedTest {

using namespace core;
using test::SyntheticSeries;

namespace {

const CodedConcept skull{.scheme = QStringLiteral("SCT"),
    .value = QStringLiteral("89546000"),
    .meaning = QStringLiteral("Skull")};

using Solid = std::function<bool(const glm::dvec3& lps)>;

/// The voxels whose centres lie in a solid.
std::vector<std::uint8_t> carved(const VolumeGeometry& geometry, const Solid& solid)
{
    std::vector<std::uint8_t> labels;
    for (int z = 0; z < geometry.size.z; ++z) {
        for (int y = 0; y < geometry.size.y; ++y) {
            for (int x = 0; x < geometry.size.x; ++x)
                labels.push_back(solid(test::placeOf(geometry, {x, y, z})) ? 1 : 0);
        }
    }
    return labels;
}

QString messageOf(const Error& error)
{
    return QString::number(int(error.code)) + QLatin1Char(' ')
        + error.arguments.join(QStringLiteral(" | "));
}

QString attribute(const QString& file, const DcmTagKey& tag)
{
    DcmFileFormat format;
    OFString value;
    if (format.loadFile(QFile::encodeName(file).constData()).bad()
        || format.getDataset()->findAndGetOFString(tag, value, 0, OFTrue).bad())
        return {};
    return QString::fromUtf8(value.c_str());
}

} // namespace

/// Masks that were drawn on a repaired volume, on the slices of its images.
class ExportRepairedTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void solidArrivesOnTheSlices_data() { repairs(); }
    void solidArrivesOnTheSlices();
    void fullVolumeGivesFullSlices_data() { repairs(); }
    void fullVolumeGivesFullSlices();
    void nothingRefersToAFilledSlice();
    void otherFormatsLieOnTheRepairedGrid();
    void headersSayHowItWasRepaired();
    void whatWasNotNeededIsNotSaid();
    void carvedSeriesIsRefused();

private:
    static void repairs();
    [[nodiscard]] QString path(const char* name) const
    {
        return m_folder->filePath(QLatin1String(name));
    }
    /// Writes the series of a row and opens it.
    [[nodiscard]] LoadedVolume opened(const QString& defect, const QString& repair);
    [[nodiscard]] Result<ExportReport> exported(const Volume& volume,
        const std::vector<std::uint8_t>& labels, ExportFormat format, const char* file) const
    {
        Segment segment;
        segment.label = 1;
        segment.name = QStringLiteral("Solid");
        segment.code = skull;
        const ExportRequest request{.format = format,
            .file = path(file),
            .segments = {segment},
            .planes = {{.plane = 0, .labels = labels}}};
        return exportMask(volume, request, {});
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    SyntheticSeries m_series;
};

void ExportRepairedTest::repairs()
{
    QTest::addColumn<QString>("defect");
    QTest::addColumn<QString>("repair");
    const auto row = [](const char* defect, const char* repair) {
        QTest::newRow(
            qPrintable(QStringLiteral("%1: %2").arg(QLatin1String(defect), QLatin1String(repair))))
            << QString::fromLatin1(defect) << QString::fromLatin1(repair);
    };
    row("tilted", "tilt");
    row("oblique and tilted", "tilt");
    row("gapped", "gap=fill");
    row("gapped", "gap=split:2");
    row("uneven", "spacing=even");
    row("uneven and tilted", "spacing=even,tilt");
    row("uneven and tilted", "tilt");
    row("uneven and tilted", "spacing=even");
    row("gapped and tilted", "gap=fill,tilt");
}

LoadedVolume ExportRepairedTest::opened(const QString& defect, const QString& repair)
{
    m_series = SyntheticSeries();
    m_series.size = {40, 36, 14};
    if (defect.contains(QLatin1String("oblique")))
        m_series.plane = {glm::normalize(glm::dvec3(0.9, 0.3, -0.1)),
            glm::normalize(glm::cross(
                glm::dvec3(0.1, 0.2, 0.95), glm::normalize(glm::dvec3(0.9, 0.3, -0.1))))};
    for (int k = 0; k < m_series.size.z; ++k) {
        double height = 2.5 * k;
        if (defect.contains(QLatin1String("uneven")) && k > 6)
            height += 1.9 * (k - 6);
        const double shift = defect.contains(QLatin1String("tilted")) ? 0.37 * height : 0.0;
        m_series.positions.emplace_back(m_series.origin + glm::dvec3(0.2 * shift, shift, height));
    }
    test::writeSeries(m_series, path("series"));
    if (defect.contains(QLatin1String("gapped"))) {
        for (const int k : {5, 9, 10})
            QFile::remove(path("series/") + m_series.fileName(k));
    }
    return test::openVolume(path("series"), withRepair(QString(), repair));
}

void ExportRepairedTest::solidArrivesOnTheSlices()
{
    QFETCH(QString, defect);
    QFETCH(QString, repair);
    const LoadedVolume loaded = opened(defect, repair);
    const VolumeGeometry& grid = loaded.volume.geometry;
    QVERIFY(grid.size.z > 1);
    // An ellipsoid around the middle, at no whole place.
    const glm::dvec3 middle =
        grid.toWorld(0.5 * glm::dvec3(grid.size) + glm::dvec3(0.3, -0.2, 0.1));
    const glm::dvec3 radii(8.3, 11.1, 7.7);
    const auto depth = [&](const glm::dvec3& lps) {
        return 1.0 - glm::length((lps - middle) / radii);
    };
    const auto labels = carved(grid, [&](const glm::dvec3& lps) { return depth(lps) >= 0.0; });
    const auto report = exported(loaded.volume, labels, ExportFormat::DicomSeg, "seg.dcm");
    QVERIFY2(report, report ? "" : qPrintable(messageOf(report.error())));

    const auto seg = readSeg(path("seg.dcm"));
    QVERIFY(seg);
    QCOMPARE(seg->columns, m_series.size.x);
    QCOMPARE(seg->rows, m_series.size.y);
    // Half a voxel of the repaired grid, in shares of the radii.
    const glm::dmat3 axes(grid.indexToWorld);
    const double halfVoxel =
        0.5 * (glm::length(axes[0]) + glm::length(axes[1]) + glm::length(axes[2]));
    const double margin = halfVoxel / 7.7 + 0.02;
    std::set<QString> named;
    int inside = 0;
    for (std::size_t frame = 0; frame < seg->frames.size(); ++frame) {
        const HeaderPlane& plane = seg->frames[frame].plane;
        named.insert(seg->frames[frame].referencedSopUid);
        for (int row = 0; row < seg->rows; ++row) {
            for (int column = 0; column < seg->columns; ++column) {
                const double here = depth(plane.at(column, row));
                const bool drawn = seg->pixel(frame, column, row);
                inside += drawn ? 1 : 0;
                QVERIFY2(here < margin || drawn, "a hole in the solid");
                QVERIFY2(here > -margin || !drawn, "solid where there is none");
            }
        }
    }
    QVERIFY2(inside > 300, qPrintable(QString::number(inside)));
    QCOMPARE(named.size(), seg->frames.size());
    // Every plane is that of an image.
    for (const SegFrame& frame : seg->frames) {
        int met = 0;
        for (int k = 0; k < m_series.size.z; ++k)
            met += glm::distance(frame.plane.position, m_series.position(k)) < 1e-4 ? 1 : 0;
        QCOMPARE(met, 1);
    }
    const auto contours = exported(loaded.volume, labels, ExportFormat::RtStruct, "rt.dcm");
    QVERIFY2(contours, contours ? "" : qPrintable(messageOf(contours.error())));
    const auto set = readRtStruct(path("rt.dcm"));
    QVERIFY(set);
    std::set<QString> images;
    for (const RtContour& contour : set->rois.front().contours)
        images.insert(contour.referencedSopUid);
    QCOMPARE(images, named);
}

void ExportRepairedTest::fullVolumeGivesFullSlices()
{
    QFETCH(QString, defect);
    QFETCH(QString, repair);
    const LoadedVolume loaded = opened(defect, repair);
    const std::vector<std::uint8_t> labels(loaded.volume.geometry.voxelCount(), 1);
    const auto report = exported(loaded.volume, labels, ExportFormat::DicomSeg, "seg.dcm");
    QVERIFY2(report, report ? "" : qPrintable(messageOf(report.error())));
    const auto seg = readSeg(path("seg.dcm"));
    QVERIFY(seg);
    const std::size_t slices = loaded.volume.sources.empty() ? loaded.volume.asIs->sources.size()
                                                             : loaded.volume.sources.size();
    QCOMPARE(seg->frames.size(), slices);
    for (std::size_t frame = 0; frame < slices; ++frame) {
        for (int row = 0; row < seg->rows; ++row) {
            for (int column = 0; column < seg->columns; ++column)
                QVERIFY(seg->pixel(frame, column, row));
        }
    }
}

void ExportRepairedTest::nothingRefersToAFilledSlice()
{
    const LoadedVolume loaded = opened(QStringLiteral("gapped"), QStringLiteral("gap=fill"));
    QCOMPARE(loaded.volume.geometry.size.z, 14);
    const glm::ivec3 size = loaded.volume.geometry.size;
    const std::size_t slice = std::size_t(size.x) * std::size_t(size.y);
    std::vector<std::uint8_t> labels(loaded.volume.geometry.voxelCount(), 0);
    std::fill_n(labels.begin() + std::ptrdiff_t(4 * slice), 2 * slice, std::uint8_t(1));
    const auto report = exported(loaded.volume, labels, ExportFormat::DicomSeg, "seg.dcm");
    QVERIFY(report);
    const auto seg = readSeg(path("seg.dcm"));
    QVERIFY(seg);
    QCOMPARE(seg->frames.size(), std::size_t(1));
    QCOMPARE(seg->frames[0].plane.position.z, m_series.position(4).z);
    QVERIFY2(
        ui::reportTexts(report->cautions).filter(QStringLiteral("1440 of the 2880 voxels")).size()
            == 1,
        qPrintable(ui::reportTexts(report->cautions).join(u'\n')));
    // On filled slices alone there is nothing to write.
    std::fill_n(labels.begin() + std::ptrdiff_t(4 * slice), slice, std::uint8_t(0));
    const auto none = exported(loaded.volume, labels, ExportFormat::DicomSeg, "none.dcm");
    QVERIFY(!none);
    QCOMPARE(none.error().code, ErrorCode::NothingToExport);
    QVERIFY(!QFile::exists(path("none.dcm")));
}

void ExportRepairedTest::otherFormatsLieOnTheRepairedGrid()
{
    const LoadedVolume loaded =
        opened(QStringLiteral("uneven and tilted"), QStringLiteral("spacing=even,tilt"));
    const VolumeGeometry& grid = loaded.volume.geometry;
    const auto labels = carved(grid, [&](const glm::dvec3& lps) {
        return glm::distance(lps, grid.toWorld(0.5 * glm::dvec3(grid.size))) < 9.0;
    });
    for (const auto& [format, file] : {std::pair{ExportFormat::Nifti, "mask.nii"},
             std::pair{ExportFormat::SegNrrd, "mask.seg.nrrd"},
             std::pair{ExportFormat::Stl, "mask.stl"}}) {
        const auto report = exported(loaded.volume, labels, format, file);
        QVERIFY2(report, report ? "" : qPrintable(messageOf(report.error())));
        QVERIFY(ui::reportTexts(report->cautions).filter(QStringLiteral("tilt sheared out")).size()
            == 1);
    }
    const LoadedVolume mask = test::openVolume(path("mask.nii"));
    QCOMPARE(mask.volume.geometry.size, grid.size);
    QVERIFY(glm::distance(mask.volume.geometry.originLps(), grid.originLps()) < 1e-3);
    for (std::size_t i = 0; i < labels.size(); ++i)
        QCOMPARE(int(mask.codes[i]), int(labels[i]));
}

void ExportRepairedTest::headersSayHowItWasRepaired()
{
    const LoadedVolume loaded = opened(QStringLiteral("tilted"), QStringLiteral("tilt"));
    const std::vector<std::uint8_t> labels(loaded.volume.geometry.voxelCount(), 1);
    QVERIFY(exported(loaded.volume, labels, ExportFormat::DicomSeg, "seg.dcm"));
    QVERIFY(exported(loaded.volume, labels, ExportFormat::RtStruct, "rt.dcm"));
    QCOMPARE(attribute(path("seg.dcm"), DCM_ContentDescription),
        QStringLiteral("Repaired series: tilt"));
    const QString how = attribute(path("seg.dcm"), DCM_DerivationDescription);
    QVERIFY2(how.contains(QLatin1String("tilt sheared out")), qPrintable(how));
    QVERIFY(exported(loaded.volume, labels, ExportFormat::DicomSegLabelMap, "map.dcm"));
    for (const DcmTagKey& tag : {DCM_ContentDescription, DCM_DerivationDescription})
        QCOMPARE(attribute(path("map.dcm"), tag), attribute(path("seg.dcm"), tag));
    const QString description = attribute(path("rt.dcm"), DCM_StructureSetDescription);
    QVERIFY2(description.contains(QLatin1String("tilt sheared out")), qPrintable(description));
}

void ExportRepairedTest::whatWasNotNeededIsNotSaid()
{
    const LoadedVolume loaded = opened(QStringLiteral("tilted"), QStringLiteral("gap=fill,tilt"));
    // The name of the volume is all that was asked for.
    QCOMPARE(loaded.volume.repair, QStringLiteral("gap=fill,tilt"));
    const std::vector<std::uint8_t> labels(loaded.volume.geometry.voxelCount(), 1);
    for (const auto& [format, file] : {std::pair{ExportFormat::Nifti, "mask.nii"},
             std::pair{ExportFormat::DicomSeg, "seg.dcm"}}) {
        const auto report = exported(loaded.volume, labels, format, file);
        QVERIFY2(report, report ? "" : qPrintable(messageOf(report.error())));
        const QStringList cautions = ui::reportTexts(report->cautions);
        QVERIFY2(!cautions.filter(QStringLiteral("loading (tilt sheared out)")).isEmpty(),
            qPrintable(cautions.join(u'\n')));
        QVERIFY2(cautions.filter(QStringLiteral("filled in")).isEmpty(),
            qPrintable(cautions.join(u'\n')));
    }
    QCOMPARE(attribute(path("seg.dcm"), DCM_ContentDescription),
        QStringLiteral("Repaired series: tilt"));
    constexpr qsizetype niftiDescription = 148; // in its header
    QVERIFY(
        test::bytesOf(path("mask.nii")).mid(niftiDescription).startsWith("Burin, repaired tilt: "));
    QVERIFY(exported(loaded.volume, labels, ExportFormat::SegNrrd, "mask.seg.nrrd"));
    QVERIFY(test::bytesOf(path("mask.seg.nrrd")).contains("\nBurin_Repair:=tilt\n"));
    const LoadedVolume both =
        opened(QStringLiteral("gapped and tilted"), QStringLiteral("gap=fill,tilt"));
    QCOMPARE(repairMade(both.volume), QStringLiteral("gap=fill,tilt"));
    // Of a series that needed nothing nothing is said.
    const LoadedVolume sound = opened(QStringLiteral("sound"), QStringLiteral("gap=fill,tilt"));
    QCOMPARE(sound.volume.repair, QStringLiteral("gap=fill,tilt"));
    QCOMPARE(repairMade(sound.volume), QString());
    const std::vector<std::uint8_t> full(sound.volume.geometry.voxelCount(), 1);
    const auto report = exported(sound.volume, full, ExportFormat::Nifti, "sound.nii");
    QVERIFY2(report, report ? "" : qPrintable(messageOf(report.error())));
    const QStringList cautions = ui::reportTexts(report->cautions);
    QVERIFY2(
        cautions.filter(QStringLiteral("on loading")).isEmpty(), qPrintable(cautions.join(u'\n')));
    QVERIFY(test::bytesOf(path("sound.nii")).mid(niftiDescription).startsWith("Burin: "));
    QVERIFY(exported(sound.volume, full, ExportFormat::SegNrrd, "sound.seg.nrrd"));
    QVERIFY(!test::bytesOf(path("sound.seg.nrrd")).contains("Burin_Repair"));
}

void ExportRepairedTest::carvedSeriesIsRefused()
{
    const LoadedVolume loaded = opened(QStringLiteral("tilted"), QStringLiteral("tilt"));
    QVERIFY2(carvedSeriesObstacle(loaded.volume).contains(QLatin1String("NIfTI can be")),
        qPrintable(carvedSeriesObstacle(loaded.volume)));
    // The slices themselves are as they are.
    QVERIFY(!WayBack::of(WayBack::of(loaded.volume)->slices()));
}

BURIN_TEST(ExportRepairedTest)

} // namespace exportRepairedTest

#include "ExportRepairedTest.moc"
