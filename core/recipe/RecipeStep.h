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

/// A walk through the history; no edit and no row of its own.
struct HistoryMove {
    enum class Kind { Undo, Redo, GoTo };
    Kind kind = Kind::Undo;
    RowId row = 0; ///< of GoTo; 0: the beginning
};

/// One entry of a recipe's list.
using RecipeStep = std::variant<Edit, HistoryMove>;

/// Reads an edit (rounded) or {"edit": "undo"}, {"edit": "redo"}, {"edit": "goTo", "seq": row}.
/// Errors: those of editFromJson().
[[nodiscard]] Result<RecipeStep> recipeStepFromJson(const QJsonValue& json);

/// "undo", "redo", "goTo", or the edit's name.
[[nodiscard]] QString stepName(const RecipeStep& step);

/// Whether a step means a place or a row of one study and so nothing on another: seeds, strokes,
/// measurements, whatever has a box, a pivot or a clip region, walks. Segments, their names and
/// codes, and growth intervals go over.
[[nodiscard]] bool isBoundToStudy(const RecipeStep& step);

/// Whether an edit of this name starts on what is seen ("surface").
[[nodiscard]] bool startsOnSurface(const QString& editName);

/// What is seen, where an edit starts on that. @param threshold modality units
void setSurface(Edit& edit, double threshold);

/// editDocumentation() and the walks: everything a recipe's list can hold.
[[nodiscard]] std::vector<EditDocumentation> recipeStepDocumentation();

} // namespace core
