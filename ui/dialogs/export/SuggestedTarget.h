// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/volume/Volume.h"

#include <QString>

#include <vector>

namespace ui {

/// Returns the folder that is suggested for exports of a study: "Burin exports" beside the study.
/// It is never the study's own folder, because a further file there would change the study.
/// @param otherwise is returned if the study's path is unknown or nothing can be written beside it
[[nodiscard]] QString folderBeside(const core::Volume& volume, const QString& otherwise);

/// Suggests a file name without extension, made of the modality, the date, the number of the series
/// and the names of the segments: "CT 2026-11-20 series 3 - Liver, Tumour". It never contains the
/// patient's name.
/// @param dated whether to include the date; false for de-identified exports
[[nodiscard]] QString exportName(
    const core::StudyIdentity& identity, const std::vector<core::Segment>& segments, bool dated);

/// Creates the folder of a file if it is the one that folderBeside() suggests. Any other missing
/// folder is left to the user, since its name may be a typing error.
void makeFolderBeside(const core::Volume& volume, const QString& file);

} // namespace ui
