// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QString>
#include <QStringList>

#include <glm/glm.hpp>

#include <cstdint>

namespace ui {

// Texts for the patient, the study, and positions and values in it, so that the same words are used
// everywhere.

/// "Doe, Jane · ID 4711 · born 1961-03-02 · F"; if the source names nobody the text says so.
[[nodiscard]] QString patientText(const core::StudyIdentity& identity);
/// The same in lines for the corner of a view: name; ID; birth date and sex.
[[nodiscard]] QStringList patientLines(const core::StudyIdentity& identity);
/// A DICOM person name as people write it: "DOE^JANE" is "DOE, JANE".
[[nodiscard]] QString personName(const QString& dicomName);
/// "CT · 2026-11-20".
[[nodiscard]] QString studyText(const core::StudyIdentity& identity);
/// "series 3 · Head bone".
[[nodiscard]] QString seriesText(const core::StudyIdentity& identity);

/// "every 2.5 mm", or that slices are unevenly spaced.
[[nodiscard]] QString slicesApartText(const core::VolumeGeometry& geometry);

/// A modality value with its unit, with as many decimals as suit @p span, the width of the range in
/// which it is seen.
[[nodiscard]] QString valueText(double value, const QString& unit, double span);
/// "±37 HU". @param tolerance in codes
[[nodiscard]] QString toleranceText(int tolerance, const core::Volume& volume);
/// The volume of a count of voxels, with the digits of volumeText(): "12.4 mL". It is "18 204
/// voxels" where the source does not say how large they are, and "≈ 12.4 mL" where slices are
/// unevenly spaced, since a count does not know in which of them its voxels lie.
[[nodiscard]] QString volumeText(const core::Volume& volume, std::int64_t voxels);
/// The same with the digits of millilitreText(), as in lists; "—" for nothing.
[[nodiscard]] QString millilitreText(const core::Volume& volume, std::int64_t voxels);
/// "18 204 voxels, 12.4 mL": a count and its volume, if that is known.
[[nodiscard]] QString countedText(const core::Volume& volume, std::int64_t voxels);
/// "−31.5, −12.2, 48.0 mm" (LPS).
[[nodiscard]] QString positionText(const glm::dvec3& lps);

} // namespace ui
