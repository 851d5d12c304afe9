// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/ExportMask.h"

namespace core {

/// What an exported file must hold.
struct ExportExpectation {
    const Volume& volume;
    std::vector<Segment> segments; ///< those written, in order
    std::span<const LabelPlaneView> planes;
    MeshSpace space = MeshSpace::Lps; ///< of surfaces
    ExportFormat format = ExportFormat::DicomSeg;
    std::span<const SegmentCoverage> coverages{}; ///< of a fractional SEG
    std::span<const std::uint16_t> codes{}; ///< for statistics
    const Deidentifier* deidentifier = nullptr;
};

/// Opens a DICOM SEG and the files of the volume's slices, and checks, from their headers alone:
/// every frame has position, orientation, spacing, frame of reference, patient and study of the
/// slice it names as its source; that slice lies where the volume has it and is of the patient that
/// was shown; every voxel is as it should have been written, and no frame is missing.
///
/// Shares no code with the writer: plain dcmdata, bits unpacked one by one.
/// @returns what was checked, in sentences
/// Errors: ExportMismatch (argument 0 the file, 1 what does not agree), and those of reading.
Result<QStringList> checkSegExport(
    const QString& file, const ExportExpectation& expected, const Progress& progress);

/// Opens a NIfTI file with the NIfTI C library, and the source files, and checks that the eight
/// corners of both grids land on the same LPS millimetres (sform, and qform where it is set), and
/// that every voxel is as it should have been written.
/// Returns and errors as above.
Result<QStringList> checkNiftiExport(
    const QString& file, const ExportExpectation& expected, const Progress& progress);

/// Opens a .seg.nrrd file with the reader of core/nrrd, and the source files, and checks that the
/// eight corners of both grids land on the same LPS millimetres, that every voxel is as it should
/// have been written, and that 3D Slicer's keys name the segments, their colours, labels and codes.
/// Returns and errors as above.
Result<QStringList> checkSegNrrdExport(
    const QString& file, const ExportExpectation& expected, const Progress& progress);

/// Opens an RTSTRUCT and the files of the volume's slices, and checks, from their headers alone:
/// every contour lies in the plane of the image it names, filling its contours again by a
/// rasteriser of its own (even-odd, at the pixels' centres) gives each slice's voxels exactly once,
/// and patient, study, frame of reference, numbers, names and colours are as they should be.
/// Returns and errors as above.
Result<QStringList> checkRtStructExport(
    const QString& file, const ExportExpectation& expected, const Progress& progress);

/// Opens an STL, OBJ, PLY or glTF file by readers of its own, and the source files, and checks that
/// the surfaces are closed and that exactly the centres of each segment's voxels are inside, once
/// and from the right side; that names and colours are there where the format has them.
/// Returns and errors as above.
Result<QStringList> checkSurfaceExport(ExportFormat format, const QString& file,
    const ExportExpectation& expected, const Progress& progress);

/// Opens statistics (CSV, JSON or SR) and the source files, and checks every number against those
/// that are counted anew, voxel by voxel, without the writer's code; of a SR also that patient,
/// study, source series and the segments of the SEG beside it are the right ones.
/// Returns and errors as above.
Result<QStringList> checkStatisticsExport(
    const QString& file, const ExportExpectation& expected, const Progress& progress);

} // namespace core
