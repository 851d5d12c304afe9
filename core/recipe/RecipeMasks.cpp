// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/FileKinds.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/masks/MaskOnVolume.h"
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

// The file that an edit has still to read; null: none, since it holds what it needs of one.

const QString* fileToRead(const ImportMask& edit)
{
    return edit.segments ? nullptr : &edit.file;
}

const QString* fileToRead(const DivideSegment& edit)
{
    return edit.probabilityFile ? &*edit.probabilityFile : nullptr;
}

/// Reads the files that edits of a recipe have still to read, in the order of its steps.
class FileReader {
public:
    FileReader(const Recipe& recipe, const Volume& volume)
        : m_recipe(recipe)
        , m_volume(volume)
    {
    }

    /// @pre it has a file to read
    Result<void> read(DivideSegment& division)
    {
        const QString file = found(*division.probabilityFile, m_recipe);
        division.probabilityFile = file;
        Result<ReadProbabilities> read = readProbabilities(division, {}, m_volume, {});
        if (!read)
            return tl::unexpected(read.error());
        division = std::move(read->edit);
        note(QFileInfo(file).fileName(), read->notes);
        return {};
    }
    Result<void> read(ImportMask& mask)
    {
        mask.file = found(mask.file, m_recipe);
        Result<ReadImport> read = readImport(mask, m_volume, m_segments, {});
        if (!read)
            return tl::unexpected(read.error());
        if (const Result<void> said = checkOverlaps(*read); !said)
            return said;
        mask = std::move(read->edit);
        m_segments += mask.segments->size();
        note(mask.file, read->notes);
        note(mask.file, notesOnOverlaps(read->overlaps, mask, m_volume.geometry));
        return {};
    }
    [[nodiscard]] std::vector<RecipeMaskNote>& notes() { return m_notes; }

private:
    void note(const QString& file, const std::vector<MaskNote>& notes)
    {
        for (const MaskNote& each : notes)
            m_notes.push_back({.file = file, .note = each});
    }

    const Recipe& m_recipe;
    const Volume& m_volume;
    std::size_t m_segments = 0; ///< that were read
    std::vector<RecipeMaskNote> m_notes;
};

} // namespace

QStringList masksOf(const Recipe& recipe)
{
    QStringList files;
    const auto add = [&](const auto& known) {
        const QString* file = fileToRead(known);
        if (!file)
            return;
        for (const QString& path : {*file, QFileInfo(recipe.path).dir().filePath(*file)}) {
            files += path;
            files += maskFilesIn(path);
        }
    };
    for (const RecipeStep& step : recipe.steps) {
        if (const auto* edit = std::get_if<Edit>(&step))
            visitAmong(add, *edit, FileKinds());
    }
    return files;
}

Result<std::vector<RecipeMaskNote>> readMasks(Recipe& recipe, const Volume& volume)
{
    FileReader reader(recipe, volume);
    Result<void> done;
    const auto read = [&](auto& known) {
        if (fileToRead(known))
            done = reader.read(known);
    };
    for (RecipeStep& step : recipe.steps) {
        if (auto* edit = std::get_if<Edit>(&step))
            visitAmong(read, *edit, FileKinds());
        if (!done)
            return tl::unexpected(done.error());
    }
    return std::move(reader.notes());
}

} // namespace core
