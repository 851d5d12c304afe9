// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/ExportMask.h"

#include <optional>
#include <span>

namespace core {

/// The study without what was carved away, as a file of its own.
struct CarvedRequest {
    /// A name that ends in .nii or .nii.gz: a NIfTI file. Any other: a folder, for a DICOM series.
    QString target;
    bool force = false; ///< replace a file of that name; a folder is never replaced
    std::span<const std::uint8_t> coverage; ///< of the layers that carve, composed; x fastest
    std::span<const std::uint16_t> codes; ///< of the volume as it was loaded; x fastest
    std::optional<double> fill{}; ///< modality units; none: the least value of the volume
    std::shared_ptr<const Deidentifier> deidentifier{}; ///< null: the patient stays named
};

/// Writes the volume with the fill value wherever coverage is 128 or more, reads it again and
/// compares every voxel and the grid. The target appears under its name only after that.
///
/// NIfTI: int16 where every value is a whole number that fits, else float32. DICOM: one image a
/// slice, derived from the study's own (core/dicom/write/CarvedSeriesWriter.h), a new series of the
/// same study that nobody is sent. The report's sum is the file's, or that of the images one after
/// the other by name. Any thread. Errors: NothingToExport (nothing is carved), UnsupportedFormat
/// (argument 1: why), FileExists, FileUnwritable, ExportMismatch, Cancelled, and those of reading
/// the sources.
Result<ExportReport> exportCarvedVolume(
    const Volume& volume, const CarvedRequest& request, const Progress& progress);

/// Why this volume cannot become a carved DICOM series, as a clause; empty if it can. Reads no
/// file.
[[nodiscard]] QString carvedSeriesObstacle(const Volume& volume);

struct CoverageRequest {
    QString file; ///< .nii or .nii.gz
    bool force = false;
    QString layer; ///< its name, for the file's description
    std::span<const std::uint8_t> coverage; ///< x fastest
};

/// Writes a sculpt layer's coverage, 0 … 255, as NIfTI on the volume's grid, and reads it again.
/// Errors: as exportCarvedVolume().
Result<ExportReport> exportCoverage(
    const Volume& volume, const CoverageRequest& request, const Progress& progress);

} // namespace core
