// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/growth/GrowthCommands.h"
#include "core/titles/RowTitle.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

struct ChangeFacts;
struct GrowCriteria;
struct GrowGuard;

// Parts that edits of growth share.

/// Whether a plane has segments and all of them are locked.
[[nodiscard]] bool nothingMayChange(const Document& document, int plane);

/// @param edit its name, for messages Errors: InvalidField (connectivity other than 6, 18 and 26,
/// lower > upper, a box outside the volume), UnknownSegment, SegmentLocked (no segment may change,
/// or one that is to grow).
[[nodiscard]] Result<GrowBurst> burstOf(
    const GrowCriteria& criteria, const Document& document, const QString& edit);

/// The rule by which a growth is watched, in integers; none: it is not watched.
[[nodiscard]] std::optional<GuardRule> guardRule(
    const GrowGuard& guard, const VolumeGeometry& geometry);

/// @param field of the points, for messages
/// Errors: InvalidField, SegmentLocked.
[[nodiscard]] Result<CutGrowth> cutAt(const std::vector<glm::dvec3>& pointsLps, CutGrowth::How how,
    const Document& document, const QString& field);

struct GrownSegments {
    std::int64_t count = 0; ///< 0: only seeds became members
    QString name{}; ///< of the one, where it is one
};
[[nodiscard]] GrownSegments grownSegments(const ChangeFacts& facts, const Document& document);
/// "120 … 300 HU"
[[nodiscard]] RowTitle intervalTitle(const GrowCriteria& criteria, const Document& document);

/// The dependencies of a growth by criteria: every seed word of its plane, since a burst grows from
/// all members; and the labels (with "only visible" also the coverage) of the voxels that it
/// examined, which are members and their neighbours (RowTrace::grownBeside). Its other limits read
/// only grey values.
[[nodiscard]] EditDependencies growthDependencies(
    const GrowCriteria& criteria, const DependencyFacts& row);

} // namespace core
