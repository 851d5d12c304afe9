// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/ExportMask.h"

#include <map>

namespace core {

/// What an exported file must contain.
struct ExportExpectation {
    const Volume& volume;
    std::vector<Segment> segments; ///< those that were written, in order
    std::span<const LabelPlaneView> planes;
    MeshSpace space = MeshSpace::Lps; ///< for surfaces
    ExportFormat format = ExportFormat::DicomSeg;
    std::span<const SegmentCoverage> coverages{}; ///< for a fractional SEG
    std::span<const std::uint16_t> codes{}; ///< for statistics
    std::span<const ImportedVoxels> imported{}; ///< for statistics
    const Deidentifier* deidentifier = nullptr;
    std::span<const Measurement> measurements{}; ///< for a report
    /// The codes besides the type, by label, for a 3D Slicer segmentation. A category that is not
    /// set is not compared.
    std::map<int, SegCodes> segmentCodes{};
};

/// Opens a DICOM SEG and the files of the volume's slices and checks, from their headers alone:
/// every frame has position, orientation, spacing, frame of reference, patient and study of the
/// slice that it refers to; that slice is where the volume has it and belongs to the displayed
/// patient; every voxel is as it should have been written; and no frame is missing.
///
/// It shares no code with the writer: plain dcmdata, with bits unpacked one by one.
/// @returns sentences on what was checked
/// Errors: ExportMismatch (argument 0 the file, 1 the difference), and those of reading.
Result<ReportLines> checkSegExport(
    const QString& file, const ExportExpectation& expected, const Progress& progress);

/// Opens a NIfTI file with the NIfTI C library, and the source files. Checks that the eight corners
/// of both grids have the same LPS millimetres (by sform, and by qform if it is set), and that
/// every voxel is as it should have been written. Result and errors as above.
Result<ReportLines> checkNiftiExport(
    const QString& file, const ExportExpectation& expected, const Progress& progress);

/// Opens a .seg.nrrd file with the reader of core/nrrd, and the source files. Checks that the eight
/// corners of both grids have the same LPS millimetres, that every voxel is as it should have been
/// written, and that the keys of 3D Slicer give the segments, their colours, labels and codes.
/// Result and errors as above.
Result<ReportLines> checkSegNrrdExport(
    const QString& file, const ExportExpectation& expected, const Progress& progress);

/// Opens an RTSTRUCT and the files of the volume's slices and checks, from their headers alone:
/// every contour lies in the plane of the image that it refers to; filling the contours with an
/// independent rasteriser (even-odd, at pixel centres) gives exactly each slice's voxels; and
/// patient, study, frame of reference, numbers, names and colours are correct. Result and errors as
/// above.
Result<ReportLines> checkRtStructExport(
    const QString& file, const ExportExpectation& expected, const Progress& progress);

/// Opens an STL, OBJ, PLY or glTF file with independent readers, and the source files. Checks that
/// the surfaces are closed, that exactly the centres of each segment's voxels are inside, once and
/// with the right orientation, and that names and colours are present if the format has them.
/// Result and errors as above.
Result<ReportLines> checkSurfaceExport(ExportFormat format, const QString& file,
    const ExportExpectation& expected, const Progress& progress);

/// Opens statistics (CSV, JSON or SR) and the source files. Checks every number against an
/// independent count voxel by voxel, and that the diameter across does not exceed the longest one
/// (what is measured on the smoothed surface is not measured anew); for an SR also that patient,
/// study, source series and the segments of the SEG beside it are correct. Result and errors as
/// above.
Result<ReportLines> checkStatisticsExport(
    const QString& file, const ExportExpectation& expected, const Progress& progress);

} // namespace core
