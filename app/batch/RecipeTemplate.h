// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/batch/StudyList.h"

#include <QByteArray>
#include <QJsonObject>

namespace app {

/// A recipe in which `${NAME}` stands for what a list of studies has in its column NAME; also
/// `${name}`, `${study}` and `${folder}`, where the results of a study go. A text that is nothing
/// but one variable becomes a number where the variable is one.
class RecipeTemplate {
public:
    /// Errors: FileUnreadable, InvalidRecipe.
    [[nodiscard]] static core::Result<RecipeTemplate> read(const QString& path);

    /// The recipe for one study, as its file holds it. Files that it reads are named absolutely,
    /// as it is carried out in @p folder.
    /// Errors: InvalidRecipe (a variable that the study does not have).
    [[nodiscard]] core::Result<QByteArray> filled(
        const BatchStudy& study, const QString& folder) const;

    /// The absolute names of the files that a filled recipe exports.
    [[nodiscard]] static QStringList exportsOf(const QByteArray& filled, const QString& folder);

private:
    QString m_path;
    QJsonObject m_content;
};

} // namespace app
