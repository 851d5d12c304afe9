// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Piece.h"
#include "core/edits/answers/EditAnswers.h"

#include <QString>

#include <glm/glm.hpp>

#include <optional>

namespace core {

/// Show a segment as a piece, in addition to where it is.
struct PastePiece {
    int segment = 0; ///< label
    QString name{};
    std::optional<glm::dvec3> pivotLps{};
    PiecePose pose{};
};

[[nodiscard]] Result<void> check(const PastePiece& edit, const Document& document);
Result<bool> apply(const PastePiece& edit, Document& document);
[[nodiscard]] EditEffects effects(const PastePiece& edit);
[[nodiscard]] RowTitle rowTitle(const PastePiece& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const PastePiece& edit, const DependencyFacts& row);

} // namespace core
