// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/recipe/RecipeExport.h"
#include "core/recipe/RecipeStep.h"
#include "core/sessionfile/records/SessionSource.h"

#include <QString>

#include <optional>
#include <vector>

namespace core {

/// What `burin run` carries out: steps, then exports.
struct Recipe {
    QString path;
    std::optional<SessionSource> study; ///< what it was recorded on, where it says so
    std::vector<RecipeStep> steps;
    std::vector<int> entries{}; ///< their places in the file, from 1; empty: as they stand here
    std::vector<std::size_t> withoutSurface{}; ///< steps whose "surface" fillSurfaces() gives
    std::vector<RecipeExport> exports;
};

/// Reads {"edits": […], "export": […], "study": {…}}; all but the edits may be missing.
/// Errors: FileNotFound, FileUnreadable, InvalidRecipe (no JSON: the line), UnknownEdit and
/// InvalidField, whose reason names the entry ("edit 3").
[[nodiscard]] Result<Recipe> readRecipe(const QString& path);

/// Gives cuts that name no surface the one that the window starts with on this volume, so that what
/// is recorded names it.
void fillSurfaces(Recipe& recipe, const Volume& volume);

/// Reads the files of masks that its steps bring in (importMask), so that what is recorded holds
/// their voxels. A name without a folder is looked for where the program runs, then beside the
/// recipe. @return sentences on what was resampled or left out. Errors: those of readMask()
/// (core/masks/MaskOnVolume.h).
[[nodiscard]] Result<QStringList> readMasks(Recipe& recipe, const Volume& volume);

/// Everything about a recipe that can be wrong on this document (with its volume) and known before
/// it is carried out; edits behind a walk through the history are checked when their turn comes.
/// Errors: those of checkAgainst(), with the entry; of exports UnsupportedFormat, FileExists,
/// FileUnwritable, SegmentNotCoded (a segment that is seeded and goes into a DICOM SEG).
[[nodiscard]] Result<void> checkRecipe(
    const Recipe& recipe, Document document, bool replaceExisting);

/// The same error, saying by which entry of a recipe's edits: "(edit 3)", counted from 1.
[[nodiscard]] Error atEdit(Error error, int entry);

} // namespace core
