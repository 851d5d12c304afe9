// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/dicom/source/SourceHeader.h"
#include "core/export/common/CheckExport.h"
#include "core/volume/Volume.h"

#include <QString>

#include <vector>

namespace core {

/// Reads the headers of a volume's slices anew and compares each with the volume as it was shown
/// and drawn on: patient, study, frame of reference, instance, size, and where its corners lie.
/// @param file the export that is checked, for the message
/// Errors: ExportMismatch, and those of reading.
Result<std::vector<SourceHeader>> checkedSourceHeaders(
    const QString& file, const Volume& volume, const Progress& progress);

/// The same, as the export has to name them: de-identified where that is asked for.
Result<std::vector<SourceHeader>> checkedSourceHeaders(
    const QString& file, const ExportExpectation& expected, const Progress& progress);

/// What differs between two patients, as a clause; empty if nothing does.
[[nodiscard]] QString differenceOfPatients(const HeaderPatient& a, const HeaderPatient& b);

/// How far positions from a header may lie from the volume's: rounding in decimal strings and in
/// the least-squares line through the slices, never near half a voxel.
[[nodiscard]] double positionToleranceMm(const VolumeGeometry& geometry);

/// LPS centre of the first voxel of slice @p k.
[[nodiscard]] glm::dvec3 sliceOrigin(const VolumeGeometry& geometry, int k);

/// "1 frame", "2 frames"
[[nodiscard]] QString counted(int count, const char* noun);

/// "(x, y, z) mm"
[[nodiscard]] QString inMm(const glm::dvec3& point);

} // namespace core
