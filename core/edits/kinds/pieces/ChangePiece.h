// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

#include <QString>

#include <glm/glm.hpp>

#include <optional>

namespace core {

/// Rename, move, rotate or zoom a piece; absent fields do not change.
struct ChangePiece {
    int piece = 0; ///< id
    std::optional<QString> name{};
    std::optional<glm::dvec3> offsetMm{};
    std::optional<glm::dvec3> rotationDegrees{};
    std::optional<double> zoom{};
};

[[nodiscard]] Result<void> check(const ChangePiece& edit, const Document& document);
Result<bool> apply(const ChangePiece& edit, Document& document);
[[nodiscard]] EditEffects effects(const ChangePiece& edit);
[[nodiscard]] RowTitle rowTitle(const ChangePiece& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const ChangePiece& edit, const DependencyFacts& row);

} // namespace core
