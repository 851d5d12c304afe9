// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/segments/ImportMask.h"
#include "core/masks/ReadImport.h"
#include "core/masks/ReadProbabilities.h"
#include "core/recipe/Recipe.h"

#include <QDir>
#include <QFileInfo>

namespace core {

namespace {

/// A file that a recipe names: where it says, or else beside the recipe.
QString found(const QString& name, const Recipe& recipe)
{
    const QFileInfo file(name);
    const QString beside = QFileInfo(recipe.path).dir().filePath(name);
    return file.isRelative() && !file.exists() && QFileInfo::exists(beside) ? beside : name;
}

} // namespace

Result<std::vector<RecipeMaskNote>> readMasks(Recipe& recipe, const Volume& volume)
{
    std::vector<RecipeMaskNote> notes;
    std::size_t segments = 0;
    for (RecipeStep& step : recipe.steps) {
        auto* edit = std::get_if<Edit>(&step);
        auto* division = edit ? edit->as<DivideSegment>() : nullptr;
        if (division && division->probabilityFile) {
            const QString file = found(*division->probabilityFile, recipe);
            division->probabilityFile = file;
            Result<ReadProbabilities> read = readProbabilities(*division, {}, volume, {});
            if (!read)
                return tl::unexpected(read.error());
            *division = std::move(read->edit);
            for (const MaskNote& note : read->notes)
                notes.push_back({.file = QFileInfo(file).fileName(), .note = note});
        }
        auto* mask = edit ? edit->as<ImportMask>() : nullptr;
        if (!mask || mask->segments)
            continue;
        mask->file = found(mask->file, recipe);
        Result<ReadImport> read = readImport(*mask, volume, segments, {});
        if (!read)
            return tl::unexpected(read.error());
        if (const Result<void> said = checkOverlaps(*read); !said)
            return tl::unexpected(said.error());
        *mask = std::move(read->edit);
        segments += mask->segments->size();
        for (const MaskNote& note : read->notes)
            notes.push_back({.file = mask->file, .note = note});
        for (const MaskNote& note : notesOnOverlaps(read->overlaps, *mask, volume.geometry))
            notes.push_back({.file = mask->file, .note = note});
    }
    return notes;
}

} // namespace core
