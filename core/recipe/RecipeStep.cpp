// SPDX-License-Identifier: Apache-2.0
#include "core/recipe/RecipeStep.h"

#include "core/edits/EditJson.h"
#include "core/edits/EditQuantise.h"
#include "core/edits/EditTask.h"
#include "core/edits/kinds/AnyEdit.h"

#include <QJsonObject>

#include <array>
#include <cmath>
#include <optional>

namespace core {

namespace {

struct MoveWord {
    HistoryMove::Kind kind;
    const char* name;
    const char* meaning;
};

constexpr std::array<MoveWord, 3> moveWords{{
    {HistoryMove::Kind::Undo, "undo", "Takes back the step that the history stands at."},
    {HistoryMove::Kind::Redo, "redo", "Brings back the step that was taken back last."},
    {HistoryMove::Kind::GoTo, "goTo", "Walks to any row of the history, on any branch."},
}};

const MoveWord* moveNamed(const QString& name)
{
    for (const MoveWord& word : moveWords) {
        if (name == QLatin1String(word.name))
            return &word;
    }
    return nullptr;
}

Result<RecipeStep> readMove(const MoveWord& word, QJsonObject object)
{
    HistoryMove move{.kind = word.kind, .row = 0};
    if (word.kind == HistoryMove::Kind::GoTo) {
        const QJsonValue seq = object.take(QStringLiteral("seq"));
        const double number = seq.toDouble(-1.0);
        if (number < 0.0 || number != std::floor(number) || number > 1e9)
            return failure(ErrorCode::InvalidField, QStringLiteral("goTo.seq"),
                seq.isUndefined() ? Clause::saying("missing")
                                  : Clause::saying("must be the number of a row, or 0"));
        move.row = RowId(number);
    }
    if (!object.isEmpty())
        return failure(ErrorCode::InvalidField,
            QLatin1String(word.name) + QLatin1Char('.') + object.constBegin().key(),
            Clause::saying("unknown field"));
    return RecipeStep(move);
}

} // namespace

Result<RecipeStep> recipeStepFromJson(const QJsonValue& json)
{
    QJsonObject object = json.toObject();
    if (const MoveWord* word = moveNamed(object.value(QStringLiteral("edit")).toString())) {
        object.remove(QStringLiteral("edit"));
        return readMove(*word, std::move(object));
    }
    const Result<Edit> edit = editFromJson(json);
    if (!edit)
        return tl::unexpected(edit.error());
    Edit rounded = quantised(*edit);
    // A number just inside its range may have been rounded out of it.
    if (const Result<void> checked = checkFields(rounded); !checked)
        return tl::unexpected(checked.error());
    return RecipeStep(std::move(rounded));
}

QString stepName(const RecipeStep& step)
{
    if (const auto* edit = std::get_if<Edit>(&step))
        return editName(*edit);
    for (const MoveWord& word : moveWords) {
        if (word.kind == std::get<HistoryMove>(step).kind)
            return QLatin1String(word.name);
    }
    return {};
}

bool isBoundToStudy(const RecipeStep& step)
{
    const auto* edit = std::get_if<Edit>(&step);
    if (!edit)
        return true;
    return effectsOf(*edit).boundToStudy;
}

bool startsOnSurface(const QString& editName)
{
    for (const Edit& edit :
        {Edit(DrillStroke()), Edit(LaserStroke()), Edit(PeelCut()), Edit(ScissorsCut())}) {
        if (core::editName(edit) == editName)
            return true;
    }
    return false;
}

void setSurface(Edit& edit, double threshold)
{
    visitEdit(
        [threshold](auto& known) {
            if constexpr (requires { known.surfaceThreshold; })
                known.surfaceThreshold = threshold;
        },
        edit);
}

std::vector<EditDocumentation> recipeStepDocumentation()
{
    std::vector<EditDocumentation> all = editDocumentation();
    for (EditDocumentation& edit : all) {
        for (FieldDocumentation& field : edit.fields) {
            // In a recipe only; a row of the history names it.
            if (startsOnSurface(edit.name) && field.name == QLatin1String("surface"))
                field.fallback = QStringLiteral("the surface that the window starts with");
        }
    }
    all.push_back({.name = QStringLiteral("restore"),
        .meaning = QStringLiteral("Fills again what was carved: the same as the tool that 'as' "
                                  "names, with the fields of that tool, and with restore true."),
        .fields = {{.name = QStringLiteral("as"),
            .type =
                QStringLiteral("\"drill\" or \"laser\" or \"peel\" or \"scissors\" or \"brush\""),
            .unit = {},
            .fallback = {},
            .meaning = QStringLiteral("the tool that is used")}}});
    for (const MoveWord& word : moveWords) {
        EditDocumentation entry{.name = QLatin1String(word.name),
            .meaning = QString::fromUtf8(word.meaning),
            .fields = {}};
        if (word.kind == HistoryMove::Kind::GoTo)
            entry.fields.push_back({.name = QStringLiteral("seq"),
                .type = QStringLiteral("whole number, 0 or more"),
                .unit = {},
                .fallback = {},
                .meaning = QStringLiteral("the number of the row; 0 is the beginning")});
        all.push_back(std::move(entry));
    }
    return all;
}

} // namespace core
