// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/RowUse.h"
#include "core/edits/kinds/Edit.h"

#include <QString>
#include <QStringList>

#include <cstdint>
#include <functional>
#include <vector>

namespace core {

// What an edit names that is not in the document, found by the types of its fields (FieldRoles.h).

/// The rows of the history that an edit names, and what it does with them.
struct NamedRows {
    RowUse use = RowUse::None;
    std::vector<std::int64_t> rows{}; ///< RowId, as the edit lists them
};
[[nodiscard]] NamedRows rowsNamedBy(const Edit& edit);

[[nodiscard]] RowUse rowUseOf(const Edit& edit);

/// The rows that are not in effect as long as this edit is; none unless it takes rows back.
[[nodiscard]] std::vector<std::int64_t> rowsTakenBackBy(const Edit& edit);

/// Gives the rows that an edit names other numbers, which must have the same order.
void changeRowsNamed(Edit& edit, const std::function<void(std::int64_t&)>& change);

/// Gives the files that an edit names other names. What a row holds of a file stays.
void changeFilesNamed(Edit& edit, const std::function<void(QString&)>& change);

/// The texts of an edit that people may have written: names, codes, files. Without the program's
/// own words, the names of fields, and packed voxels.
[[nodiscard]] QStringList textsIn(const Edit& edit);

} // namespace core
