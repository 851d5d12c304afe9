// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/ImportMask.h"
#include "core/masks/ReadImport.h"
#include "core/recipe/Recipe.h"

#include <QDir>
#include <QFileInfo>

namespace core {

Result<std::vector<RecipeMaskNote>> readMasks(Recipe& recipe, const Volume& volume)
{
    std::vector<RecipeMaskNote> notes;
    std::size_t segments = 0;
    for (RecipeStep& step : recipe.steps) {
        auto* edit = std::get_if<Edit>(&step);
        auto* mask = edit ? edit->as<ImportMask>() : nullptr;
        if (!mask || mask->segments)
            continue;
        const QFileInfo file(mask->file);
        const QString beside = QFileInfo(recipe.path).dir().filePath(mask->file);
        if (file.isRelative() && !file.exists() && QFileInfo::exists(beside))
            mask->file = beside;
        Result<ReadImport> read = readImport(*mask, volume, segments, {});
        if (!read)
            return tl::unexpected(read.error());
        *mask = std::move(read->edit);
        segments += mask->segments->size();
        for (const MaskNote& note : read->notes)
            notes.push_back({.file = mask->file, .note = note});
    }
    return notes;
}

} // namespace core
