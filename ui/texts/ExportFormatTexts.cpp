// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/ExportFormatTexts.h"

#include <QCoreApplication>

namespace ui {

namespace {

struct ExportFormatTexts {
    Q_DECLARE_TR_FUNCTIONS(ui::ExportFormatTexts)
};

} // namespace

QString exportFormatTitle(core::ExportFormat format)
{
    using core::ExportFormat;
    switch (format) {
    case ExportFormat::DicomSeg:
        return ExportFormatTexts::tr("DICOM SEG");
    case ExportFormat::DicomSegFractional:
        return ExportFormatTexts::tr("DICOM SEG, fractional");
    case ExportFormat::DicomSegLabelMap:
        return ExportFormatTexts::tr("DICOM SEG, label map");
    case ExportFormat::RtStruct:
        return ExportFormatTexts::tr("DICOM RTSTRUCT");
    case ExportFormat::Nifti:
        return ExportFormatTexts::tr("NIfTI label map");
    case ExportFormat::SegNrrd:
        return ExportFormatTexts::tr("3D Slicer segmentation");
    case ExportFormat::Stl:
        return ExportFormatTexts::tr("STL surface");
    case ExportFormat::Obj:
        return ExportFormatTexts::tr("OBJ surfaces");
    case ExportFormat::Ply:
        return ExportFormatTexts::tr("PLY surfaces");
    case ExportFormat::Gltf:
        return ExportFormatTexts::tr("glTF surfaces");
    case ExportFormat::Csv:
        return ExportFormatTexts::tr("Statistics, CSV");
    case ExportFormat::Json:
        return ExportFormatTexts::tr("Statistics, JSON");
    case ExportFormat::Sr:
        return ExportFormatTexts::tr("Statistics, DICOM SR");
    }
    return {};
}

QString exportFormatSays(core::ExportFormat format)
{
    using core::ExportFormat;
    switch (format) {
    case ExportFormat::DicomSeg:
        return ExportFormatTexts::tr("One object, references the source images.");
    case ExportFormat::DicomSegFractional:
        return ExportFormatTexts::tr(
            "How much of each voxel is filled, 0 … 255, where a segment was made of a sculpt "
            "layer; of others every voxel is 0 or 255.");
    case ExportFormat::DicomSegLabelMap:
        return ExportFormatTexts::tr("One map for all segments (supplement 243 of 2023): small, "
                                     "but many programs do not know it yet.");
    case ExportFormat::RtStruct:
        return ExportFormatTexts::tr(
            "Closed contours along the borders of the voxels on the source images.");
    case ExportFormat::Nifti:
        return ExportFormatTexts::tr("No patient data.");
    case ExportFormat::SegNrrd:
        return ExportFormatTexts::tr("Names, colours and codes, no patient data.");
    case ExportFormat::Stl:
        return ExportFormatTexts::tr("Closed and smoothed, in mm; all ticked segments in one, "
                                     "which STL cannot keep apart; no patient data.");
    case ExportFormat::Obj:
        return ExportFormatTexts::tr("Closed and smoothed, in mm; an object a segment, with name "
                                     "and colour; no patient data.");
    case ExportFormat::Ply:
        return ExportFormatTexts::tr("Closed and smoothed, in mm; colours and the label of each "
                                     "face; no patient data.");
    case ExportFormat::Gltf:
        return ExportFormatTexts::tr("Closed and smoothed; a node a segment, with name and "
                                     "colour; no patient data.");
    case ExportFormat::Csv:
        return ExportFormatTexts::tr(
            "A line a segment: volume, place, surface, values; no patient data.");
    case ExportFormat::Json:
        return ExportFormatTexts::tr("The same numbers for programs, with the UIDs of study and "
                                     "series; no patient data.");
    case ExportFormat::Sr:
        return ExportFormatTexts::tr("A measurement report (TID 1500); the DICOM SEG that it "
                                     "speaks of is written beside it.");
    }
    return {};
}

} // namespace ui
