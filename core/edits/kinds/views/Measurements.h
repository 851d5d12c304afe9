// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

#include <glm/glm.hpp>

#include <optional>

namespace core {

/// Keep a measured distance between two points, given at their true places.
struct AddMeasurement {
    glm::dvec3 fromLps{0.0};
    glm::dvec3 toLps{0.0};
    std::optional<int> piece{}; ///< id of the piece on which both points were picked
};

struct RemoveMeasurement {
    int measurement = 0; ///< id
};

[[nodiscard]] Result<void> check(const AddMeasurement& edit, const Document& document);
Result<bool> apply(const AddMeasurement& edit, Document& document);
[[nodiscard]] EditEffects effects(const AddMeasurement& edit);
[[nodiscard]] RowTitle rowTitle(const AddMeasurement& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const AddMeasurement& edit, const DependencyFacts& row);

[[nodiscard]] Result<void> check(const RemoveMeasurement& edit, const Document& document);
Result<bool> apply(const RemoveMeasurement& edit, Document& document);
[[nodiscard]] EditEffects effects(const RemoveMeasurement& edit);
[[nodiscard]] RowTitle rowTitle(const RemoveMeasurement& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(
    const RemoveMeasurement& edit, const DependencyFacts& row);

} // namespace core
