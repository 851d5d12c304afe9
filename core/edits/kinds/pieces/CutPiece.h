// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

#include <QString>

#include <glm/glm.hpp>

#include <optional>

namespace core {

/// Make what a sculpt layer has cut out a piece, which can be shown in another place.
struct CutPiece {
    int layer = 1; ///< id of a layer that is not another piece's
    QString name{};
    std::optional<glm::dvec3> pivotLps{}; ///< none: the middle of the volume
};

[[nodiscard]] Result<void> check(const CutPiece& edit, const Document& document);
Result<bool> apply(const CutPiece& edit, Document& document);
[[nodiscard]] EditEffects effects(const CutPiece& edit);
[[nodiscard]] RowTitle rowTitle(const CutPiece& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const CutPiece& edit, const DependencyFacts& row);

} // namespace core
