// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/edits/Edits.h"
#include "core/export/ExportMask.h"

#include <QString>

#include <vector>

namespace core {

struct RecipeExport {
    ExportFormat format = ExportFormat::DicomSeg;
    QString file;
};

/// What `burin run` carries out: edits, then exports.
struct Recipe {
    QString path;
    std::vector<Edit> edits; ///< quantised
    std::vector<RecipeExport> exports;
};

/// Reads {"edits": […], "export": […]}; "export" may be missing.
/// Errors: FileNotFound, FileUnreadable, InvalidRecipe (no JSON: the line), UnknownEdit and
/// InvalidField, whose reason names the entry ("edit 3").
[[nodiscard]] Result<Recipe> readRecipe(const QString& path);

/// Everything about a recipe that can be wrong on this volume and known before it is carried out.
/// Errors: those of checkAgainst(), with the entry; of exports UnsupportedFormat, FileExists,
/// FileUnwritable, SegmentNotCoded (a segment that is seeded and goes into a DICOM SEG).
[[nodiscard]] Result<void> checkRecipe(
    const Recipe& recipe, const Volume& volume, bool replaceExisting);

} // namespace core
