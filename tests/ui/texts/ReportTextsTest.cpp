// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/ReportTexts.h"

#include "tests/support/program/MarkingTranslator.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <set>

namespace reportTextsTest {

using core::ReportCode;
using core::ReportSentence;

namespace {

/// A code with its English; of those that are counts both forms.
struct Row {
    ReportCode code{};
    const char* text = "";
    std::int64_t count = 0;
};

const std::vector<Row>& rows()
{
    static const std::vector<Row> all{
        {ReportCode::Joined, "%1"},
        {ReportCode::Comma, ", "},
        {ReportCode::Space, " "},
        {ReportCode::Quoted, "'%1'"},
        {ReportCode::Segments, "1 segment", 1},
        {ReportCode::Segments, "%1 segments", 2},
        {ReportCode::Frames, "1 frame", 1},
        {ReportCode::Frames, "%1 frames", 2},
        {ReportCode::Contours, "1 contour", 1},
        {ReportCode::Contours, "%1 contours", 2},
        {ReportCode::Numbers, "1 number", 1},
        {ReportCode::Numbers, "%1 numbers", 2},
        {ReportCode::SourceHeaders, "1 source header", 1},
        {ReportCode::SourceHeaders, "%1 source headers", 2},
        {ReportCode::SourceGrid, "the source's grid"},
        {ReportCode::RepairedGrid, "the repaired grid (%1)"},
        {ReportCode::BinarySeg, "binary"},
        {ReportCode::FractionalSeg, "fractional (occupancy)"},
        {ReportCode::LabelMapSeg, "label map"},
        {ReportCode::DeflatedSeg, "%1, deflated"},
        {ReportCode::AsLayerCovers, "'%1' as sculpt layer '%2' covers it"},
        {ReportCode::SurfaceOf, "%1 (%2 triangles, %3 mL)"},
        {ReportCode::TrianglesOf, "%1 (%2 triangles)"},
        {ReportCode::VolumeOf, "%1 (%2 mL)"},
        {ReportCode::StlFormat, "STL surface"},
        {ReportCode::ObjFormat, "OBJ surfaces"},
        {ReportCode::PlyFormat, "PLY surfaces"},
        {ReportCode::GltfFormat, "glTF surfaces"},
        {ReportCode::CsvFormat, "Statistics, CSV"},
        {ReportCode::JsonFormat, "Statistics, JSON"},
        {ReportCode::SrFormat, "Statistics, DICOM SR"},
        {ReportCode::DicomSeg,
            "DICOM SEG, %1: %2 in %3 of %4 × %5; slices without a voxel are left out."},
        {ReportCode::FilledInPart,
            "Filled in part: %1; exactly the segment's voxels have 128 and more."},
        {ReportCode::WithoutCoverage, "Without partial coverage, every voxel 0 or 255: %1."},
        {ReportCode::RtStruct,
            "DICOM RTSTRUCT: %1 in %2 of %3 points on the source's slices, along the borders of "
            "the voxels; holes are reached by slits (keyholes)."},
        {ReportCode::NiftiLabelMap, "NIfTI label map, %1 × %2 × %3, on %4: %5."},
        {ReportCode::SlicerSegmentation, "3D Slicer segmentation, %1 × %2 × %3, on %4: %5."},
        {ReportCode::Surfaces, "%1, mm in %2: %3."},
        {ReportCode::SurfacesSmoothed,
            "Smoothed by less than half a voxel (at most 0.45 along each axis of the voxels)."},
        {ReportCode::Statistics, "%1: %2."},
        {ReportCode::SinceImport, "%1 since its import: %2 mL added, %3 mL taken, Dice %4."},
        {ReportCode::SegBeside, "The DICOM SEG that it refers to: %1. %2"},
        {ReportCode::OnOwnSlices,
            "Written on the images' own slices, %1 of them: each of their voxels takes what the "
            "nearest voxel of the repaired volume holds."},
        {ReportCode::Deidentified, "De-identified: %1; patient '%2'; UIDs are new."},
        {ReportCode::CarvedVolume, "Carved volume: %1 of %2 voxels hold %3."},
        {ReportCode::NiftiFloats, "NIfTI, 32-bit floating point, on the study's grid."},
        {ReportCode::NiftiWholeNumbers, "NIfTI, 16-bit whole numbers, on the study's grid."},
        {ReportCode::CarvedSeries,
            "A new DICOM series of %1 images in the same study; it was sent nowhere."},
        {ReportCode::LayerCoverage,
            "Coverage of sculpt layer '%1', 0 … 255; 128 and more is carved away."},
        {ReportCode::SecondaryCapture, "DICOM Secondary Capture of %1 × %2 pixels."},
        {ReportCode::PngPicture, "PNG of %1 × %2 pixels."},
        {ReportCode::FramesAgree,
            "Position, orientation, spacing, frame of reference, patient and study of %1 equal "
            "those of the source images they name (%2 read again)."},
        {ReportCode::VoxelsOfAsDrawn, "All voxels of %1 are as drawn."},
        {ReportCode::ContoursInPlanes,
            "%1 in the planes of the source images they name; patient, study and frame of "
            "reference are theirs (%2 read again)."},
        {ReportCode::ContoursFilled, "Filled again, the contours give all voxels of %1 as drawn."},
        {ReportCode::CornersOnSource,
            "The eight corners land on the source's millimetres (at most %1 mm off, source header "
            "read again)."},
        {ReportCode::CornersOnStudy,
            "The eight corners land on the study's millimetres (at most %1 mm off)."},
        {ReportCode::VoxelsAsDrawn, "All %1 voxels are as drawn."},
        {ReportCode::NamesAsGiven, "Names, colours, labels and codes of %1 are as given."},
        {ReportCode::TrianglesClosed, "All %1 triangles make closed surfaces."},
        {ReportCode::CentresInside,
            "Exactly the voxels of %1 have their centres inside, on the source's grid (source "
            "header read again)."},
        {ReportCode::NumbersEqual, "%1 of %2 equal those counted anew, voxel by voxel."},
        {ReportCode::VoxelsAsTheyShould, "All %1 voxels are as they should be."},
        {ReportCode::SeriesAsItShould,
            "All %1 voxels of the series, opened again, are as they should be."},
        {ReportCode::SlicesFoundAgain,
            "Every voxel of every slice was found again in the repaired volume by its place in the "
            "patient, at most half a voxel away."},
        {ReportCode::PixelsAgree,
            "All %1 × %2 pixels are those of the picture; patient and study are those of the "
            "images that it shows."},
        {ReportCode::TextsAreAnonymous, "None of %1 texts and UIDs tells who the patient is."},
        {ReportCode::FilesAreAnonymous, "No text and no UID of %1 files tells who the patient is."},
        {ReportCode::Sha256, "SHA-256 of %1: %2"},
        {ReportCode::SegmentEmpty, "Segment '%1' is empty and was left out."},
        {ReportCode::CheckedAgainstSession,
            "The study's own files were not at hand; the export was checked against the headers "
            "that the session holds."},
        {ReportCode::Repaired, "The series was repaired on loading (%1)."},
        {ReportCode::BeyondImages,
            "%1 of the %2 voxels of segment '%3' lie where there is no image (slices that were "
            "interpolated, or beside what was scanned) and are not in the file."},
        {ReportCode::TiltInFile,
            "The slices are tilted by %1°: the file says so, and some programs refuse such files."},
        {ReportCode::TiltInSform,
            "The slices are tilted by %1°: only the sform says so, and some programs refuse such "
            "files."},
        {ReportCode::UnevenInFile,
            "The slices are not evenly spaced; in the %1 file, which has one step for all, they "
            "lie up to %2 mm off."},
        {ReportCode::UnevenInVolumes,
            "The slices are not evenly spaced: in volumes each counts half the way to either "
            "neighbour."},
        {ReportCode::ValuesRounded, "Values are rounded by up to %1, as they are on screen."},
        {ReportCode::LabelMapsAreNew,
            "Label maps are new to DICOM (supplement 243): viewers and archives of before 2024, "
            "DCMTK 3.6.7 among them, do not know them."},
        {ReportCode::NoFrameOfReference,
            "The source images have no frame of reference in common; the segmentation names none."},
        {ReportCode::NewFrameOfReference,
            "The source images have no frame of reference in common; the contours name a new one."},
        {ReportCode::OneStlSurface,
            "STL cannot keep the segments apart: they are one surface of several parts."},
        {ReportCode::FaceCanBeRecognised,
            "A face or body can be recognised in the images themselves; their voxels are not "
            "changed."},
        {ReportCode::StillLossy,
            "The source was compressed with loss; so are these images, though they are stored "
            "without compression."},
        {ReportCode::ValueLeftOut, "%1 of the source is not valid and was left out."},
        {ReportCode::ValueNormalised,
            "%1 of the source is not valid and was written as DICOM has it."},
    };
    return all;
}

/// With more arguments than any form has places for; one looks like the place of another.
ReportSentence sentenceOf(const Row& row)
{
    const ReportSentence::Argument first = row.count > 0
        ? ReportSentence::Argument(row.count)
        : ReportSentence::Argument(QStringLiteral("a%2"));
    return {row.code,
        {first, QStringLiteral("b"),
            core::namesInReport({QStringLiteral("c"), QStringLiteral("d")}), std::int64_t(4),
            QStringLiteral("e")}};
}

QString expected(const Row& row)
{
    QString text = QString::fromUtf8(row.text);
    text.replace(QStringLiteral("%5"), QStringLiteral("e"));
    text.replace(QStringLiteral("%4"), QStringLiteral("4"));
    text.replace(QStringLiteral("%3"), QStringLiteral("c, d"));
    text.replace(QStringLiteral("%2"), QStringLiteral("b"));
    return text.replace(
        QStringLiteral("%1"), row.count > 0 ? QString::number(row.count) : QStringLiteral("a%2"));
}

} // namespace

/// What the window and the command line say of an export.
class ReportTextsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyCode()
    {
        std::set<ReportCode> codes;
        for (const Row& row : rows()) {
            codes.insert(row.code);
            QCOMPARE(ui::reportText(sentenceOf(row)), expected(row));
        }
        // Codes have no gaps, and the last one is in the table.
        QCOMPARE(codes.size(), std::size_t(ReportCode::ValueNormalised) + 1);
    }

    void everyCodeGoesThroughTheTranslator()
    {
        const test::MarkingTranslator translator;
        for (const Row& row : rows()) {
            const QString said = ui::reportText(sentenceOf(row));
            const bool isMarked = said.contains(u'<') && said.endsWith(u'>');
            QCOMPARE(isMarked, row.code != ReportCode::Joined);
        }
    }

    void aClauseWithinASentenceIsTranslated()
    {
        const ReportSentence repaired{
            ReportCode::Repaired, {core::Clause::saying("tilt sheared out")}};
        QCOMPARE(ui::reportText(repaired),
            QStringLiteral("The series was repaired on loading (tilt sheared out)."));
        const test::MarkingTranslator translator;
        QCOMPARE(ui::reportText(repaired),
            QStringLiteral("<The series was repaired on loading (<tilt sheared out>).>"));
    }

    void aWholeReport()
    {
        const core::ExportReport report{.file = QStringLiteral("a.dcm"),
            .written = {ReportSentence{ReportCode::DicomSeg,
                            {core::inReport(ReportSentence{ReportCode::DeflatedSeg,
                                 {core::inReport(ReportSentence{ReportCode::BinarySeg})}}),
                                core::countedInReport(ReportCode::Segments, 1),
                                core::countedInReport(ReportCode::Frames, 12), 512, 256}},
                ReportSentence{ReportCode::Joined,
                    {ReportSentence::Listed{.joiner = ReportCode::Space,
                        .all = {{ReportCode::FilledInPart,
                                    {core::inReport({{ReportCode::AsLayerCovers,
                                                         {QStringLiteral("A"),
                                                             QStringLiteral("Sculpt 1")}},
                                        {ReportCode::AsLayerCovers,
                                            {QStringLiteral("B"), QStringLiteral("its own")}}})}},
                            {ReportCode::WithoutCoverage,
                                {core::inReport(ReportSentence{
                                    ReportCode::Quoted, {QStringLiteral("C")}})}}}}}}},
            .checked = {ReportSentence{ReportCode::FramesAgree,
                {core::countedInReport(ReportCode::Frames, 1),
                    core::countedInReport(ReportCode::SourceHeaders, 2)}}},
            .cautions = {core::ProblemSentence{
                core::ProblemCode::SlicesTilted, {QStringLiteral("12.0")}}},
            .sha256 = QStringLiteral("ab")};
        const ui::WordedReport worded = ui::reportTexts(report);
        QCOMPARE(worded.file, report.file);
        QCOMPARE(worded.sha256, report.sha256);
        QCOMPARE(worded.written,
            (QStringList{
                QStringLiteral("DICOM SEG, binary, deflated: 1 segment in 12 frames of 512 × 256; "
                               "slices without a voxel are left out."),
                QStringLiteral(
                    "Filled in part: 'A' as sculpt layer 'Sculpt 1' covers it, 'B' as "
                    "sculpt layer 'its own' covers it; exactly the segment's voxels have "
                    "128 and more. Without partial coverage, every voxel 0 or 255: "
                    "'C'.")}));
        QCOMPARE(worded.checked,
            QStringList(QStringLiteral(
                "Position, orientation, spacing, frame of reference, patient and study of 1 frame "
                "equal those of the source images they name (2 source headers read again).")));
        QCOMPARE(worded.cautions,
            QStringList(QStringLiteral("The slices are tilted by 12.0° against their stacking "
                                       "direction (gantry tilt).")));
    }
};

BURIN_TEST(ReportTextsTest)

} // namespace reportTextsTest

#include "ReportTextsTest.moc"
