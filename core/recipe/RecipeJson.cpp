// SPDX-License-Identifier: Apache-2.0
#include "core/recipe/RecipeJson.h"

#include "core/base/files/ReadableFile.h"
#include "core/recipe/RepeatedKey.h"

#include <QFile>
#include <QJsonDocument>

#include <optional>

namespace core {

Result<QJsonObject> readRecipeJson(const QString& path)
{
    if (const Result<void> isFile = checkIsFile(path); !isFile)
        return tl::unexpected(isFile.error());
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(ErrorCode::FileUnreadable, path, file.errorString());
    const QByteArray text = file.readAll();
    QJsonParseError problem;
    const QJsonDocument document = QJsonDocument::fromJson(text, &problem);
    if (problem.error != QJsonParseError::NoError)
        return failure(ErrorCode::InvalidRecipe, path,
            Clause::saying(
                "line %1: %2", text.left(problem.offset).count('\n') + 1, problem.errorString()));
    if (!document.isObject())
        return failure(ErrorCode::InvalidRecipe, path, Clause::saying("it must be an object"));
    if (const std::optional<RepeatedKey> repeated = repeatedKey(text))
        return failure(ErrorCode::InvalidRecipe, path,
            Clause::saying(
                "line %1: the key '%2' stands twice in one object", repeated->line, repeated->key));
    return document.object();
}

} // namespace core
