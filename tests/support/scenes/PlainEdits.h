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

// Edits that many tests make on the way to their subject. Tests that use them need not include the
// headers of these edits, so that a change of such a header does not recompile all of them.

[[nodiscard]] core::Edit newSegment(const QString& name, std::uint32_t rgb = 0);
[[nodiscard]] core::Edit renameSegment(int segment, const QString& name);
[[nodiscard]] core::Edit lockSegment(int segment, bool locked = true);
/// Protects a segment from carving.
[[nodiscard]] core::Edit protectSegment(int segment, bool isProtected = true);
[[nodiscard]] core::Edit seedAt(int segment, std::vector<glm::dvec3> pointsLps);
/// @param steps none: to closure
[[nodiscard]] core::Edit growBetween(
    double lower, double upper, std::optional<int> steps = std::nullopt);
[[nodiscard]] core::Edit growBy(
    const core::GrowCriteria& criteria, std::optional<int> steps = std::nullopt);
/// A stroke of a ball through these points.
[[nodiscard]] core::Edit paintAt(
    int segment, std::vector<glm::dvec3> pointsLps, double radiusMm = 4.0);
/// A disc in the plane with this normal.
[[nodiscard]] core::Edit paintDiscAt(
    int segment, const glm::dvec3& pointLps, const glm::dvec3& normalLps, double radiusMm);
/// Seeds, of a ball.
[[nodiscard]] core::Edit paintSeedsAt(
    int segment, std::vector<glm::dvec3> pointsLps, double radiusMm);
/// Along edges: voxels that differ from where it begins by no more than the tolerance.
[[nodiscard]] core::Edit paintAlongEdgesAt(
    int segment, std::vector<glm::dvec3> pointsLps, double radiusMm, double tolerance);
/// Over other segments too.
[[nodiscard]] core::Edit paintOverAt(
    int segment, std::vector<glm::dvec3> pointsLps, double radiusMm = 4.0);
[[nodiscard]] core::Edit eraseAt(
    int segment, std::vector<glm::dvec3> pointsLps, double radiusMm = 4.0);
/// Out of layer 1, likewise.
[[nodiscard]] core::Edit carveAt(std::vector<glm::dvec3> pointsLps, double radiusMm = 4.0);
/// A segment of these values; none: of any above.
[[nodiscard]] core::Edit thresholdOf(
    int segment, double lower, std::optional<double> upper = std::nullopt);
[[nodiscard]] core::Edit revertRows(std::vector<std::int64_t> rows);

} // namespace test
