// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/masks/MaskNote.h"
#include "core/recipe/RecipeExport.h"
#include "core/recipe/RecipeStep.h"
#include "core/sessionfile/records/SessionSource.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace core {

/// A recipe, as `burin run` carries it out: steps, then exports.
struct Recipe {
    QString path;
    std::optional<SessionSource> study; ///< the study on which it was recorded, if stated
    std::vector<RecipeStep> steps;
    std::vector<int> entries{}; ///< their numbers in the file, from 1; empty: 1, 2, 3 …
    std::vector<std::size_t> withoutSurface{}; ///< steps whose "surface" fillSurfaces() sets
    std::vector<RecipeExport> exports;
};

/// Reads {"edits": […], "export": […], "study": {…}}; only "edits" is required. Errors:
/// FileNotFound, FileUnreadable, InvalidRecipe (not JSON: the line), UnknownEdit and InvalidField,
/// whose reason names the entry ("edit 3").
[[nodiscard]] Result<Recipe> readRecipe(const QString& path);

/// Gives cuts without a surface the default surface threshold of this volume, so that the recorded
/// edit contains it.
void fillSurfaces(Recipe& recipe, const Volume& volume);

/// A note on a mask file that a recipe imports.
struct RecipeMaskNote {
    QString file; ///< without a folder
    MaskNote note;
};

/// Reads the mask files that its steps import (importMask) and the probability maps by which they
/// divide (chunks), so that the recorded edits contain what the files hold. A file name without a
/// folder is looked up in the current folder, then beside the recipe.
/// @return what was resampled or left out
/// Errors: those of readMask() (core/masks/MaskOnVolume.h) and readProbabilities().
[[nodiscard]] Result<std::vector<RecipeMaskNote>> readMasks(Recipe& recipe, const Volume& volume);

/// The files that readMasks() will read, as the steps name them and beside the recipe; of a folder
/// also those in it.
[[nodiscard]] QStringList masksOf(const Recipe& recipe);

/// Checks everything about a recipe that can be checked on this document (with its volume) before
/// it is carried out. Edits after a walk through the history, or after islands were split into
/// segments that the recipe does not name, are checked when their turn comes.
/// Errors: those of checkAgainst(), with the entry; for exports UnsupportedFormat, FileExists,
/// FileUnwritable, SegmentNotCoded (a segment that is seeded and written to a DICOM SEG).
[[nodiscard]] Result<void> checkRecipe(
    const Recipe& recipe, Document document, bool replaceExisting);

/// Adds to an error the number of the recipe's edit that caused it, "(edit 3)", counted from 1.
[[nodiscard]] Error atEdit(Error error, int entry);

} // namespace core
