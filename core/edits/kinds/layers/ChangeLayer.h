// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

#include <QString>

#include <optional>

namespace core {

/// Rename or mute a sculpt layer, or make it solo; absent fields do not change.
struct ChangeLayer {
    int layer = 0; ///< id
    std::optional<QString> name{};
    std::optional<bool> muted{};
    std::optional<bool> solo{};
};

[[nodiscard]] Result<void> check(const ChangeLayer& edit, const Document& document);
Result<bool> apply(const ChangeLayer& edit, Document& document);
[[nodiscard]] EditEffects effects(const ChangeLayer& edit);
[[nodiscard]] RowTitle rowTitle(const ChangeLayer& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const ChangeLayer& edit, const DependencyFacts& row);

} // namespace core
