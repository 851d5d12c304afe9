// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"
#include "core/export/common/ExportMask.h"

#include <optional>
#include <span>

namespace core {

/// A request to export the study without what was carved away.
struct CarvedRequest {
    /// A name that ends in .nii or .nii.gz gives a NIfTI file; any other gives a folder with a
    /// DICOM series.
    QString target;
    bool force = false; ///< replace a file of that name; a folder is never replaced
    std::span<const std::uint8_t> coverage; ///< of all layers that carve, composed; x fastest
    std::span<const std::uint16_t> codes; ///< of the volume as loaded; x fastest
    std::optional<double> fill{}; ///< modality units; none: the least value of the volume
    std::shared_ptr<const Deidentifier> deidentifier{}; ///< null: the patient's identity is kept
};

/// Writes the volume with the fill value wherever coverage is 128 or more, then reads the result
/// again and compares every voxel and the grid. The target appears under its name only after that.
///
/// NIfTI: int16 if every value is an integer that fits, else float32. DICOM: one image per slice,
/// derived from the study's own (core/dicom/write/CarvedSeriesWriter.h), as a new series of the
/// same study; it is sent nowhere. The checksum in the report is that of the file, or of the images
/// one after the other by name. Any thread. Errors: NothingToExport (nothing is carved),
/// UnsupportedFormat (argument 1: why; for NIfTI also slices too uneven), FileExists,
/// FileUnwritable, ExportMismatch, Cancelled, and those of reading the sources.
Result<ExportReport> exportCarvedVolume(
    const Volume& volume, const CarvedRequest& request, const Progress& progress);

/// The reason why this volume cannot be exported as a carved DICOM series, as a clause; empty if it
/// can. Reads no file.
[[nodiscard]] Clause carvedSeriesObstacle(const Volume& volume);

/// A request to export the coverage of one sculpt layer.
struct CoverageRequest {
    QString file; ///< .nii or .nii.gz
    bool force = false;
    QString layer; ///< its name, for the description in the file
    std::span<const std::uint8_t> coverage; ///< x fastest
};

/// Writes the coverage of a sculpt layer, 0 … 255, as NIfTI on the volume's grid, and reads it
/// again. Errors: those of exportCarvedVolume().
Result<ExportReport> exportCoverage(
    const Volume& volume, const CoverageRequest& request, const Progress& progress);

} // namespace core
