// SPDX-License-Identifier: Apache-2.0
#include "app/batch/RecipeTemplate.h"

#include "core/recipe/RecipeJson.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>

#include <optional>
#include <utility>

namespace app {

namespace {

using core::ErrorCode;
using core::failure;
using core::Result;

const QRegularExpression& variable()
{
    static const QRegularExpression pattern(QStringLiteral("\\$\\{([^}]*)\\}"));
    return pattern;
}

/// Puts what a study has in the place of variables.
class Filling {
public:
    Filling(QJsonObject variables, QString recipe)
        : m_variables(std::move(variables))
        , m_recipe(std::move(recipe))
    {
    }

    QJsonValue filled(const QJsonValue& value)
    {
        if (value.isString())
            return filledText(value.toString());
        if (value.isArray()) {
            QJsonArray list;
            const QJsonArray before = value.toArray();
            for (const QJsonValue& each : before)
                list.append(filled(each));
            return list;
        }
        if (value.isObject())
            return filledObject(value.toObject());
        return value;
    }
    [[nodiscard]] const std::optional<QString>& missing() const { return m_missing; }

private:
    QJsonValue filledText(const QString& text)
    {
        QString built;
        qsizetype end = 0;
        for (auto match = variable().globalMatch(text); match.hasNext();) {
            const QRegularExpressionMatch found = match.next();
            const QJsonValue value = m_variables.value(found.captured(1));
            if (value.isUndefined()) {
                m_missing = found.captured(1);
                return text; // what is undefined would leave its object while that is walked
            }
            if (found.capturedLength() == text.size())
                return value;
            built += text.mid(end, found.capturedStart() - end) + value.toVariant().toString();
            end = found.capturedEnd();
        }
        return built + text.mid(end);
    }

    QJsonValue filledObject(QJsonObject object)
    {
        const QString edit = object.value(QStringLiteral("edit")).toString();
        for (auto field = object.begin(); field != object.end(); ++field) {
            field.value() = filled(field.value());
            const bool isRead = !edit.isEmpty()
                && (field.key() == QLatin1String("file")
                    || field.key() == QLatin1String("probabilityFile"));
            if (isRead && field.value().isString())
                field.value() = absolute(field.value().toString());
        }
        return object;
    }

    /// As `burin run` looks it up: in the current folder, then beside the recipe.
    [[nodiscard]] QString absolute(const QString& file) const
    {
        const QString beside = QFileInfo(m_recipe).absoluteDir().absoluteFilePath(file);
        return QFileInfo::exists(file) || !QFileInfo::exists(beside)
            ? QFileInfo(file).absoluteFilePath()
            : beside;
    }

    QJsonObject m_variables;
    QString m_recipe;
    std::optional<QString> m_missing;
};

} // namespace

Result<RecipeTemplate> RecipeTemplate::read(const QString& path)
{
    Result<QJsonObject> content = core::readRecipeJson(path);
    if (!content)
        return tl::unexpected(content.error());
    RecipeTemplate read;
    read.m_path = path;
    read.m_content = *std::move(content);
    return read;
}

Result<QByteArray> RecipeTemplate::filled(const BatchStudy& study, const QString& folder) const
{
    QJsonObject variables = study.variables;
    variables[QStringLiteral("name")] = study.name;
    variables[QStringLiteral("study")] = study.path;
    variables[QStringLiteral("folder")] = folder;
    Filling filling(variables, m_path);
    const QJsonValue content = filling.filled(m_content);
    if (filling.missing())
        return failure(ErrorCode::InvalidRecipe, m_path,
            QStringLiteral("study '%1' has no variable '%2'").arg(study.name, *filling.missing()));
    return QJsonDocument(content.toObject()).toJson();
}

QStringList RecipeTemplate::exportsOf(const QByteArray& filled, const QString& folder)
{
    QStringList files;
    const QJsonArray exports =
        QJsonDocument::fromJson(filled).object().value(QStringLiteral("export")).toArray();
    for (const QJsonValue& each : exports) {
        const QString file = each.toObject().value(QStringLiteral("file")).toString();
        if (!file.isEmpty())
            files += QDir::cleanPath(QDir(folder).absoluteFilePath(file));
    }
    return files;
}

} // namespace app
