// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/volume/Volume.h"

#include <QString>

#include <optional>
#include <vector>

class QWidget;

namespace ui {

/// Returns the folder that is suggested for exports of a study: "Burin exports" beside the study.
/// It is never the study's own folder, because a further file there would change the study.
/// @param otherwise is returned if the study's path is unknown or nothing can be written beside it
[[nodiscard]] QString folderBeside(const core::Volume& volume, const QString& otherwise);

/// Suggests a file name without extension, made of the modality, the date, the number of the series
/// and the names of the segments: "CT 2026-11-20 series 3 - Liver, Tumour". It never contains the
/// patient's name.
/// @param dated whether to include the date; false for de-identified exports
/// @param point pointOf(), so that files of different points in time do not get the same name
[[nodiscard]] QString exportName(const core::StudyIdentity& identity,
    const std::vector<core::Segment>& segments, bool dated, int point = 0);

/// Like the other one, for what is not made of chosen segments.
/// @param of what is written: "carved"; may be empty
[[nodiscard]] QString exportName(
    const core::StudyIdentity& identity, const QString& of, bool dated, int point = 0);

/// Which point of a series in time the volume is, from 1; 0 if it is none of several.
[[nodiscard]] int pointOf(const core::Volume& volume);

/// Creates the folder of a file if it is the one that folderBeside() suggests. Any other missing
/// folder is left to the user, since its name may be a typing error.
/// @return whether it was missing and is there now
bool makeFolderBeside(const core::Volume& volume, const QString& file);

/// folderBeside(), or the user's documents where there is none or no volume.
[[nodiscard]] QString suggestedFolder(const core::Volume* volume);

/// The key in the settings of the folder that all exports share.
[[nodiscard]] QString exportFolderKey();
/// The folder that the user chose last instead of the suggested one, else that one.
[[nodiscard]] QString rememberedFolder(const QString& key, const QString& suggested);
/// Remembers the folder of a file for the next time, unless it is suggested anyway: the suggested
/// one may differ from study to study.
void rememberFolder(const QString& key, const QString& suggested, const QString& file);

/// A file to write, for which a file dialog asks.
struct TargetQuestion {
    QString title; ///< of the dialog
    QString of; ///< what is written: "carved"
    QString ending; ///< of the suggested name: ".csv"
    QString filter; ///< as for QFileDialog; the first ending in each part completes a name without
};

/// The file that was chosen, and the part of the filter that was.
struct ChosenTarget {
    QString file;
    QString filter;
};

/// Asks for a file, which is named after the study and lies in the folder that all exports share.
/// The folder beside the study is there once a file in it was chosen. The user was asked whether
/// an existing file is to be replaced. None: the user chose none.
/// @param volume null: no study is open. Is not used any more once the dialog is shown.
[[nodiscard]] std::optional<ChosenTarget> askForTarget(
    const TargetQuestion& question, const core::Volume* volume, QWidget* parent);

} // namespace ui
