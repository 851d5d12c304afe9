// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Measurement.h"
#include "core/edits/answers/EditAnswers.h"

#include <QString>

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace core {

/// Keep a measured distance between two points, given at their true places.
struct AddMeasurement {
    glm::dvec3 fromLps{0.0};
    glm::dvec3 toLps{0.0};
    std::optional<int> piece{}; ///< id of the piece on which both points were picked
    std::optional<bool> projected{}; ///< Measurement::projected; none: no
};

/// Keep an angle, a region, a place whose value is read, an arrow or a text. Results are computed
/// from the study and are not stored in the row.
struct Annotate {
    static constexpr std::size_t mostCorners = 512; ///< of an outline

    Measurement::Kind kind = Measurement::Kind::Angle; ///< not a distance
    /// The points that the kind needs (Measurement::Kind), at their true places.
    std::vector<glm::dvec3> pointsLps{};
    std::optional<QString> text{}; ///< only for an arrow or a text; required for a text
    std::optional<int> piece{}; ///< id of the piece on which all points were picked
    std::optional<bool> projected{}; ///< none: no
};

/// Move the points of a measurement. It keeps its id and everything else.
struct MoveMeasurement {
    int measurement = 0; ///< id
    std::vector<glm::dvec3> pointsLps{}; ///< the points that its kind needs, at their true places
};

struct RemoveMeasurement {
    int measurement = 0; ///< id
};

[[nodiscard]] Result<void> check(const AddMeasurement& edit, const Document& document);
Result<bool> apply(const AddMeasurement& edit, Document& document);
[[nodiscard]] EditEffects effects(const AddMeasurement& edit);
[[nodiscard]] RowTitle rowTitle(const AddMeasurement& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const AddMeasurement& edit, const DependencyFacts& row);

[[nodiscard]] Result<void> check(const Annotate& edit, const Document& document);
Result<bool> apply(const Annotate& edit, Document& document);
[[nodiscard]] EditEffects effects(const Annotate& edit);
[[nodiscard]] RowTitle rowTitle(const Annotate& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const Annotate& edit, const DependencyFacts& row);

[[nodiscard]] Result<void> check(const MoveMeasurement& edit, const Document& document);
Result<bool> apply(const MoveMeasurement& edit, Document& document);
[[nodiscard]] EditEffects effects(const MoveMeasurement& edit);
[[nodiscard]] RowTitle rowTitle(const MoveMeasurement& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(
    const MoveMeasurement& edit, const DependencyFacts& row);

[[nodiscard]] Result<void> check(const RemoveMeasurement& edit, const Document& document);
Result<bool> apply(const RemoveMeasurement& edit, Document& document);
[[nodiscard]] EditEffects effects(const RemoveMeasurement& edit);
[[nodiscard]] RowTitle rowTitle(const RemoveMeasurement& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(
    const RemoveMeasurement& edit, const DependencyFacts& row);

} // namespace core
