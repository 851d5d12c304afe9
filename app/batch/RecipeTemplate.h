// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/batch/StudyList.h"

#include <QByteArray>
#include <QJsonObject>

namespace app {

/// A recipe with placeholders for a batch. `${NAME}` stands for the value that a study of the list
/// has in its column NAME; `${name}`, `${study}` and `${folder}` (the folder for the study's
/// results) are always defined. A text that consists of one placeholder only takes the value's
/// type, so it can become a number; but where the recipe has a text (a name, a code, a file), and
/// within longer texts, the cell of a table stands as it was written.
class RecipeTemplate {
public:
    /// Errors: FileUnreadable, InvalidRecipe.
    /// Reads a recipe.
    [[nodiscard]] static core::Result<RecipeTemplate> read(const QString& path);

    /// Returns the recipe for one study as the content of its file. Names of files that it reads
    /// become absolute, because it is carried out in @p folder. Errors: InvalidRecipe (the study
    /// has no value for a placeholder).
    [[nodiscard]] core::Result<QByteArray> filled(
        const BatchStudy& study, const QString& folder) const;

    /// Whether an export is a report, with which the SEG that it refers to is written
    /// (core::segBeside()).
    [[nodiscard]] static bool bringsSeg(const QJsonObject& target);

    /// Returns the absolute names of the files that a filled recipe exports.
    [[nodiscard]] static QStringList exportsOf(const QByteArray& filled, const QString& folder);

private:
    QString m_path;
    QJsonObject m_content;
};

} // namespace app
