// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"

#include <QString>

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {
struct GrowCriteria;
}

namespace test {

// Edits that many tests make on the way to what they are about. They need not see the header of
// such an edit, so that it can change without all of them being built anew.

[[nodiscard]] core::Edit newSegment(const QString& name, std::uint32_t rgb = 0);
[[nodiscard]] core::Edit renameSegment(int segment, const QString& name);
[[nodiscard]] core::Edit lockSegment(int segment, bool locked = true);
/// No tool carves where it is.
[[nodiscard]] core::Edit protectSegment(int segment, bool isProtected = true);
[[nodiscard]] core::Edit seedAt(int segment, std::vector<glm::dvec3> pointsLps);
/// @param steps none: to closure
[[nodiscard]] core::Edit growBetween(
    double lower, double upper, std::optional<int> steps = std::nullopt);
[[nodiscard]] core::Edit growBy(
    const core::GrowCriteria& criteria, std::optional<int> steps = std::nullopt);
/// With a ball, in one stroke through these points.
[[nodiscard]] core::Edit paintAt(
    int segment, std::vector<glm::dvec3> pointsLps, double radiusMm = 4.0);
/// Over other segments too.
[[nodiscard]] core::Edit paintOverAt(
    int segment, std::vector<glm::dvec3> pointsLps, double radiusMm = 4.0);
[[nodiscard]] core::Edit eraseAt(
    int segment, std::vector<glm::dvec3> pointsLps, double radiusMm = 4.0);
/// Out of layer 1, likewise.
[[nodiscard]] core::Edit carveAt(std::vector<glm::dvec3> pointsLps, double radiusMm = 4.0);
[[nodiscard]] core::Edit revertRows(std::vector<std::int64_t> rows);

} // namespace test
