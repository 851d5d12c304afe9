// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/edits/EditDocumentation.h"
#include "core/edits/kinds/Edit.h"
#include "core/history/History.h"

#include <QJsonValue>

#include <variant>
#include <vector>

namespace core {

/// A walk through the history; it is not an edit and makes no row.
struct HistoryMove {
    enum class Kind { Undo, Redo, GoTo };
    Kind kind = Kind::Undo;
    RowId row = 0; ///< for GoTo; 0: the beginning
};

/// One entry of a recipe's list.
using RecipeStep = std::variant<Edit, HistoryMove>;

/// Reads an edit (rounded) or {"edit": "undo"}, {"edit": "redo"}, {"edit": "goTo", "seq": row}.
/// Errors: those of editFromJson().
[[nodiscard]] Result<RecipeStep> recipeStepFromJson(const QJsonValue& json);

/// "undo", "redo", "goTo", or the edit's name.
[[nodiscard]] QString stepName(const RecipeStep& step);

/// Whether a step refers to a place or a row of one study and so means nothing on another: seeds,
/// strokes, measurements, everything with a box, a pivot or a clip region, walks. Segments with
/// their names and codes, and growth intervals, are not bound.
[[nodiscard]] bool isBoundToStudy(const RecipeStep& step);

/// Whether an edit of this name starts on the visible surface (it has a field "surface").
[[nodiscard]] bool startsOnSurface(const QString& editName);

/// Sets the surface threshold of an edit that has one. @param threshold modality units
void setSurface(Edit& edit, double threshold);

/// editDocumentation() and the walks: everything that can be in a recipe's list.
[[nodiscard]] std::vector<EditDocumentation> recipeStepDocumentation();

} // namespace core
