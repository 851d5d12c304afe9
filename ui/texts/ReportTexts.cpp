// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/ReportTexts.h"

#include "ui/texts/ClauseText.h"
#include "ui/texts/ExportFormatTexts.h"
#include "ui/texts/ProblemTexts.h"

#include <QCoreApplication>

namespace ui {

namespace {

struct ReportTexts {
    Q_DECLARE_TR_FUNCTIONS(ui::ReportTexts)
};

using core::ReportCode;

/// A code without a form does not compile.
QString formOf(ReportCode code, std::int64_t count)
{
    switch (code) {
    case ReportCode::Joined:
        return QStringLiteral("%1");
    case ReportCode::Comma:
        return ReportTexts::tr(", ");
    case ReportCode::Space:
        return ReportTexts::tr(" ");
    case ReportCode::Quoted:
        return ReportTexts::tr("'%1'");
    case ReportCode::Segments:
        return count == 1 ? ReportTexts::tr("1 segment")
                          : ReportTexts::tr("%1 segments", nullptr, int(count));
    case ReportCode::Frames:
        return count == 1 ? ReportTexts::tr("1 frame")
                          : ReportTexts::tr("%1 frames", nullptr, int(count));
    case ReportCode::Contours:
        return count == 1 ? ReportTexts::tr("1 contour")
                          : ReportTexts::tr("%1 contours", nullptr, int(count));
    case ReportCode::Numbers:
        return count == 1 ? ReportTexts::tr("1 number")
                          : ReportTexts::tr("%1 numbers", nullptr, int(count));
    case ReportCode::SourceHeaders:
        return count == 1 ? ReportTexts::tr("1 source header")
                          : ReportTexts::tr("%1 source headers", nullptr, int(count));
    case ReportCode::SourceGrid:
        return ReportTexts::tr("the source's grid");
    case ReportCode::RepairedGrid:
        return ReportTexts::tr("the repaired grid (%1)");
    case ReportCode::BinarySeg:
        return ReportTexts::tr("binary");
    case ReportCode::FractionalSeg:
        return ReportTexts::tr("fractional (occupancy)");
    case ReportCode::LabelMapSeg:
        return ReportTexts::tr("label map");
    case ReportCode::DeflatedSeg:
        return ReportTexts::tr("%1, deflated");
    case ReportCode::AsLayerCovers:
        return ReportTexts::tr("'%1' as sculpt layer '%2' covers it");
    case ReportCode::SurfaceOf:
        return ReportTexts::tr("%1 (%2 triangles, %3 mL)");
    case ReportCode::TrianglesOf:
        return ReportTexts::tr("%1 (%2 triangles)");
    case ReportCode::VolumeOf:
        return ReportTexts::tr("%1 (%2 mL)");
    case ReportCode::StlFormat:
        return exportFormatTitle(core::ExportFormat::Stl);
    case ReportCode::ObjFormat:
        return exportFormatTitle(core::ExportFormat::Obj);
    case ReportCode::PlyFormat:
        return exportFormatTitle(core::ExportFormat::Ply);
    case ReportCode::GltfFormat:
        return exportFormatTitle(core::ExportFormat::Gltf);
    case ReportCode::CsvFormat:
        return exportFormatTitle(core::ExportFormat::Csv);
    case ReportCode::JsonFormat:
        return exportFormatTitle(core::ExportFormat::Json);
    case ReportCode::SrFormat:
        return exportFormatTitle(core::ExportFormat::Sr);
    case ReportCode::DicomSeg:
        return ReportTexts::tr(
            "DICOM SEG, %1: %2 in %3 of %4 × %5; slices without a voxel are left out.");
    case ReportCode::FilledInPart:
        return ReportTexts::tr(
            "Filled in part: %1; exactly the segment's voxels have 128 and more.");
    case ReportCode::WithoutCoverage:
        return ReportTexts::tr("Without partial coverage, every voxel 0 or 255: %1.");
    case ReportCode::RtStruct:
        return ReportTexts::tr(
            "DICOM RTSTRUCT: %1 in %2 of %3 points on the source's slices, along the borders of "
            "the voxels; holes are reached by slits (keyholes).");
    case ReportCode::NiftiLabelMap:
        return ReportTexts::tr("NIfTI label map, %1 × %2 × %3, on %4: %5.");
    case ReportCode::SlicerSegmentation:
        return ReportTexts::tr("3D Slicer segmentation, %1 × %2 × %3, on %4: %5.");
    case ReportCode::Surfaces:
        return ReportTexts::tr("%1, mm in %2: %3.");
    case ReportCode::SurfacesSmoothed:
        return ReportTexts::tr(
            "Smoothed by less than half a voxel (at most 0.45 along each axis of the voxels).");
    case ReportCode::Statistics:
        return ReportTexts::tr("%1: %2.");
    case ReportCode::SinceImport:
        return ReportTexts::tr("%1 since its import: %2 mL added, %3 mL taken, Dice %4.");
    case ReportCode::SegBeside:
        return ReportTexts::tr("The DICOM SEG that it refers to: %1. %2");
    case ReportCode::OnOwnSlices:
        return ReportTexts::tr("Written on the images' own slices, %1 of them: each of their "
                               "voxels takes what the nearest voxel of the repaired volume holds.");
    case ReportCode::Deidentified:
        return ReportTexts::tr("De-identified: %1; patient '%2'; UIDs are new.");
    case ReportCode::CarvedVolume:
        return ReportTexts::tr("Carved volume: %1 of %2 voxels hold %3.");
    case ReportCode::NiftiFloats:
        return ReportTexts::tr("NIfTI, 32-bit floating point, on the study's grid.");
    case ReportCode::NiftiWholeNumbers:
        return ReportTexts::tr("NIfTI, 16-bit whole numbers, on the study's grid.");
    case ReportCode::CarvedSeries:
        return ReportTexts::tr(
            "A new DICOM series of %1 images in the same study; it was sent nowhere.");
    case ReportCode::LayerCoverage:
        return ReportTexts::tr(
            "Coverage of sculpt layer '%1', 0 … 255; 128 and more is carved away.");
    case ReportCode::SecondaryCapture:
        return ReportTexts::tr("DICOM Secondary Capture of %1 × %2 pixels.");
    case ReportCode::PngPicture:
        return ReportTexts::tr("PNG of %1 × %2 pixels.");
    case ReportCode::FramesAgree:
        return ReportTexts::tr(
            "Position, orientation, spacing, frame of reference, patient and study of %1 equal "
            "those of the source images they name (%2 read again).");
    case ReportCode::VoxelsOfAsDrawn:
        return ReportTexts::tr("All voxels of %1 are as drawn.");
    case ReportCode::ContoursInPlanes:
        return ReportTexts::tr("%1 in the planes of the source images they name; patient, study "
                               "and frame of reference are theirs (%2 read again).");
    case ReportCode::ContoursFilled:
        return ReportTexts::tr("Filled again, the contours give all voxels of %1 as drawn.");
    case ReportCode::CornersOnSource:
        return ReportTexts::tr("The eight corners land on the source's millimetres (at most %1 mm "
                               "off, source header read again).");
    case ReportCode::CornersOnStudy:
        return ReportTexts::tr(
            "The eight corners land on the study's millimetres (at most %1 mm off).");
    case ReportCode::VoxelsAsDrawn:
        return ReportTexts::tr("All %1 voxels are as drawn.");
    case ReportCode::NamesAsGiven:
        return ReportTexts::tr("Names, colours, labels and codes of %1 are as given.");
    case ReportCode::TrianglesClosed:
        return ReportTexts::tr("All %1 triangles make closed surfaces.");
    case ReportCode::CentresInside:
        return ReportTexts::tr("Exactly the voxels of %1 have their centres inside, on the "
                               "source's grid (source header read again).");
    case ReportCode::NumbersEqual:
        return ReportTexts::tr("%1 of %2 equal those counted anew, voxel by voxel.");
    case ReportCode::VoxelsAsTheyShould:
        return ReportTexts::tr("All %1 voxels are as they should be.");
    case ReportCode::SeriesAsItShould:
        return ReportTexts::tr("All %1 voxels of the series, opened again, are as they should be.");
    case ReportCode::SlicesFoundAgain:
        return ReportTexts::tr("Every voxel of every slice was found again in the repaired volume "
                               "by its place in the patient, at most half a voxel away.");
    case ReportCode::PixelsAgree:
        return ReportTexts::tr("All %1 × %2 pixels are those of the picture; patient and study are "
                               "those of the images that it shows.");
    case ReportCode::TextsAreAnonymous:
        return ReportTexts::tr("None of %1 texts and UIDs tells who the patient is.");
    case ReportCode::FilesAreAnonymous:
        return ReportTexts::tr("No text and no UID of %1 files tells who the patient is.");
    case ReportCode::Sha256:
        return ReportTexts::tr("SHA-256 of %1: %2");
    case ReportCode::SegmentEmpty:
        return ReportTexts::tr("Segment '%1' is empty and was left out.");
    case ReportCode::CheckedAgainstSession:
        return ReportTexts::tr("The study's own files were not at hand; the export was checked "
                               "against the headers that the session holds.");
    case ReportCode::Repaired:
        return ReportTexts::tr("The series was repaired on loading (%1).");
    case ReportCode::BeyondImages:
        return ReportTexts::tr(
            "%1 of the %2 voxels of segment '%3' lie where there is no image (slices that were "
            "interpolated, or beside what was scanned) and are not in the file.");
    case ReportCode::TiltInFile:
        return ReportTexts::tr(
            "The slices are tilted by %1°: the file says so, and some programs refuse such files.");
    case ReportCode::TiltInSform:
        return ReportTexts::tr("The slices are tilted by %1°: only the sform says so, and some "
                               "programs refuse such files.");
    case ReportCode::UnevenInFile:
        return ReportTexts::tr("The slices are not evenly spaced; in the %1 file, which has one "
                               "step for all, they lie up to %2 mm off.");
    case ReportCode::UnevenInVolumes:
        return ReportTexts::tr("The slices are not evenly spaced: in volumes each counts half the "
                               "way to either neighbour.");
    case ReportCode::ValuesRounded:
        return ReportTexts::tr("Values are rounded by up to %1, as they are on screen.");
    case ReportCode::LabelMapsAreNew:
        return ReportTexts::tr("Label maps are new to DICOM (supplement 243): viewers and archives "
                               "of before 2024, DCMTK 3.6.7 among them, do not know them.");
    case ReportCode::NoFrameOfReference:
        return ReportTexts::tr(
            "The source images have no frame of reference in common; the segmentation names none.");
    case ReportCode::NewFrameOfReference:
        return ReportTexts::tr(
            "The source images have no frame of reference in common; the contours name a new one.");
    case ReportCode::OneStlSurface:
        return ReportTexts::tr(
            "STL cannot keep the segments apart: they are one surface of several parts.");
    case ReportCode::FaceCanBeRecognised:
        return ReportTexts::tr("A face or body can be recognised in the images themselves; their "
                               "voxels are not changed.");
    case ReportCode::StillLossy:
        return ReportTexts::tr("The source was compressed with loss; so are these images, though "
                               "they are stored without compression.");
    case ReportCode::ValueLeftOut:
        return ReportTexts::tr("%1 of the source is not valid and was left out.");
    case ReportCode::ValueNormalised:
        return ReportTexts::tr("%1 of the source is not valid and was written as DICOM has it.");
    }
    return {};
}

class ReportLanguage : public core::SaidLanguage<ReportCode> {
public:
    [[nodiscard]] QString form(ReportCode code, std::int64_t count) const override
    {
        return formOf(code, count);
    }
    [[nodiscard]] QString clause(const core::Clause& clause) const override
    {
        return clauseText(clause);
    }
};

struct LineText {
    QString operator()(const core::ReportSentence& sentence) const
    {
        return core::worded(sentence, ReportLanguage());
    }
    QString operator()(const core::ProblemSentence& sentence) const
    {
        return problemText(sentence);
    }
};

} // namespace

QString reportText(const core::ReportLine& line)
{
    return std::visit(LineText(), line);
}

QStringList reportTexts(const core::ReportLines& lines)
{
    QStringList texts;
    for (const core::ReportLine& line : lines)
        texts += reportText(line);
    return texts;
}

WordedReport reportTexts(const core::ExportReport& report)
{
    return {.file = report.file,
        .written = reportTexts(report.written),
        .checked = reportTexts(report.checked),
        .cautions = reportTexts(report.cautions),
        .sha256 = report.sha256};
}

} // namespace ui
