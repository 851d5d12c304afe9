// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/volume/Volume.h"

#include <QString>

#include <vector>

namespace ui {

/// The folder that exports of a study are offered to go to: one of its own beside the study, never
/// in the study's folder, which would be another one with a file more.
/// @param otherwise where nothing can be written beside it
[[nodiscard]] QString folderBeside(const core::Volume& volume, const QString& otherwise);

/// A file's name without ending, of modality, date, number of the series and the segments:
/// "CT 2026-11-20 series 3 - Liver, Tumour". It never names the patient.
/// @param dated whether it may say the date, which is left out of what is de-identified
[[nodiscard]] QString exportName(
    const core::StudyIdentity& identity, const std::vector<core::Segment>& segments, bool dated);

/// Makes the folder of a file if it is the one that folderBeside() offers; others are the user's to
/// make, since a missing one may be misspelt.
void makeFolderBeside(const core::Volume& volume, const QString& file);

} // namespace ui
