// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace core {

struct SeedPlacement;

/// Sketch seeds of a segment: the voxels nearest to these points.
struct SeedStroke {
    int segment = 0;
    std::vector<glm::dvec3> pointsLps{};
    /// Pending seeds that are removed first. With as many points as there are new ones, seeds are
    /// moved.
    std::optional<std::vector<glm::dvec3>> takenLps{};
};

[[nodiscard]] Result<void> check(const SeedStroke& edit, const Document& document);
Result<bool> apply(const SeedStroke& edit, Document& document);
[[nodiscard]] EditEffects effects(const SeedStroke& edit);
[[nodiscard]] RowTitle rowTitle(const SeedStroke& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const SeedStroke& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const SeedStroke& edit, const Document& document);

/// Errors: UnknownSegment, SegmentLocked, SeedOutsideVolume, InvalidField (no point at all).
[[nodiscard]] Result<SeedPlacement> seedPlacement(
    const SeedStroke& stroke, const Document& document);

} // namespace core
