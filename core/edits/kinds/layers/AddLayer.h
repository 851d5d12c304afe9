// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

#include <QString>

namespace core {

/// Add an empty sculpt layer at the end of the list.
struct AddLayer {
    QString name{};
};

[[nodiscard]] Result<void> check(const AddLayer& edit, const Document& document);
Result<bool> apply(const AddLayer& edit, Document& document);
[[nodiscard]] EditEffects effects(const AddLayer& edit);
[[nodiscard]] RowTitle rowTitle(const AddLayer& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const AddLayer& edit, const DependencyFacts& row);

} // namespace core
