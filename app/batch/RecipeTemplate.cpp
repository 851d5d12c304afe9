// SPDX-License-Identifier: Apache-2.0
#include "app/batch/RecipeTemplate.h"

#include "core/export/common/StatisticsText.h"
#include "core/recipe/RecipeJson.h"
#include "core/recipe/RecipeStep.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QSet>

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

/// Fields of edits that are texts or lists of texts: "EDIT/FIELD".
QSet<QString> textsOfEdits()
{
    QSet<QString> texts;
    const std::vector<core::EditDocumentation> edits = core::recipeStepDocumentation();
    for (const core::EditDocumentation& edit : edits) {
        for (const core::FieldDocumentation& field : edit.fields) {
            if (field.type == QLatin1String("text")
                || field.type.startsWith(QLatin1String("[scheme")))
                texts.insert(edit.name + QLatin1Char('/') + field.name);
        }
    }
    return texts;
}

/// Whether a text belongs there, so that a cell "4711" is a name and no number.
/// @param place "EDIT/FIELD" or "export.FIELD", with groups: "setView/view.name"
bool isText(const QString& place)
{
    static const QSet<QString> texts = textsOfEdits();
    const QString field = place.section(QRegularExpression(QStringLiteral("[./]")), -1);
    if (place.startsWith(QLatin1String("export.")))
        return field != QLatin1String("layer") && field != QLatin1String("fill")
            && field != QLatin1String("dates");
    // Entries of lists, such as the parts of a segment, have these too.
    return texts.contains(place) || field == QLatin1String("name")
        || field == QLatin1String("code");
}

/// Puts what a study has in the place of variables.
class Filling {
public:
    Filling(QJsonObject variables, QHash<QString, QString> cells, QString recipe)
        : m_variables(std::move(variables))
        , m_cells(std::move(cells))
        , m_recipe(std::move(recipe))
    {
    }

    /// @param place of the value in its edit or export, as isText() names it
    QJsonValue filled(const QJsonValue& value, const QString& place = {})
    {
        if (value.isString())
            return filledText(value.toString(), place);
        if (value.isArray()) {
            QJsonArray list;
            const QJsonArray before = value.toArray();
            for (const QJsonValue& each : before)
                list.append(filled(each, place));
            return list;
        }
        if (value.isObject())
            return filledObject(value.toObject(), place);
        return value;
    }
    [[nodiscard]] const std::optional<QString>& missing() const { return m_missing; }

private:
    QJsonValue filledText(const QString& text, const QString& place)
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
            const QString written = m_cells.value(found.captured(1), value.toVariant().toString());
            if (found.capturedLength() == text.size())
                return value.isDouble() && m_cells.contains(found.captured(1)) && isText(place)
                    ? QJsonValue(written)
                    : value;
            built += text.mid(end, found.capturedStart() - end) + written;
            end = found.capturedEnd();
        }
        return built + text.mid(end);
    }

    QJsonValue filledObject(QJsonObject object, const QString& place)
    {
        const QString edit = object.value(QStringLiteral("edit")).toString();
        const QString before = !edit.isEmpty() ? edit + QLatin1Char('/')
            : place.isEmpty()                  ? QString()
                                               : place + QLatin1Char('.');
        for (auto field = object.begin(); field != object.end(); ++field) {
            field.value() = filled(field.value(), before + field.key());
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
    QHash<QString, QString> m_cells;
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
    Filling filling(variables, study.cells, m_path);
    const QJsonValue content = filling.filled(m_content);
    if (filling.missing())
        return failure(ErrorCode::InvalidRecipe, m_path,
            QStringLiteral("study '%1' has no variable '%2'").arg(study.name, *filling.missing()));
    return QJsonDocument(content.toObject()).toJson();
}

bool RecipeTemplate::bringsSeg(const QJsonObject& target)
{
    return target.value(QStringLiteral("format")) == QLatin1String("sr");
}

QStringList RecipeTemplate::exportsOf(const QByteArray& filled, const QString& folder)
{
    QStringList files;
    const QJsonArray exports =
        QJsonDocument::fromJson(filled).object().value(QStringLiteral("export")).toArray();
    for (const QJsonValue& each : exports) {
        const QString file = each.toObject().value(QStringLiteral("file")).toString();
        if (file.isEmpty())
            continue;
        const QString path = QDir::cleanPath(QDir(folder).absoluteFilePath(file));
        files += path;
        if (bringsSeg(each.toObject()))
            files += core::segBeside(path);
    }
    return files;
}

} // namespace app
