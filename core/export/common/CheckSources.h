// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/base/words/Clause.h"
#include "core/dicom/source/SourceHeader.h"
#include "core/export/common/CheckExport.h"
#include "core/volume/Volume.h"

#include <QString>

#include <vector>

namespace core {

/// Reads the headers of a volume's slices again and compares each with the volume that was
/// displayed and edited: patient, study, frame of reference, instance, size, and the positions of
/// its corners.
/// @param file the export that is checked, for the message
/// Errors: ExportMismatch, and those of reading.
Result<std::vector<SourceHeader>> checkedSourceHeaders(
    const QString& file, const Volume& volume, const Progress& progress);

/// The same headers as the export must refer to them: de-identified if that was requested.
Result<std::vector<SourceHeader>> checkedSourceHeaders(
    const QString& file, const ExportExpectation& expected, const Progress& progress);

/// The difference between two patients, as a clause; empty if there is none.
[[nodiscard]] Clause differenceOfPatients(const HeaderPatient& a, const HeaderPatient& b);

/// The same for a written object and its source. The object holds name and ID as far as DICOM
/// allows; the report says what was normalised or left out.
[[nodiscard]] Clause differenceFromSource(
    const HeaderPatient& written, const HeaderPatient& source);

/// The greatest allowed difference between positions in a header and in the volume. It covers
/// rounding in decimal strings and of the least-squares line through the slices, and is far below
/// half a voxel.
[[nodiscard]] double positionToleranceMm(const VolumeGeometry& geometry);

/// LPS centre of the first voxel of slice @p k.
[[nodiscard]] glm::dvec3 sliceOrigin(const VolumeGeometry& geometry, int k);

/// "(x, y, z) mm"
[[nodiscard]] QString inMm(const glm::dvec3& point);

} // namespace core
