// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/answers/EditReach.h"
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

// What edits of growth have in common.

/// Whether a plane holds segments, all of them locked.
[[nodiscard]] bool nothingMayChange(const Document& document, int plane);

/// @param edit its name, for messages. Errors: InvalidField (connectivity other than 6, 18 and 26,
/// lower > upper, a box outside the volume), SegmentLocked (no segment may change).
[[nodiscard]] Result<GrowBurst> burstOf(
    const GrowCriteria& criteria, const Document& document, const QString& edit);

/// By which a growth is watched; none: it is not. Whole numbers from here on.
[[nodiscard]] std::optional<GuardRule> guardRule(
    const GrowGuard& guard, const VolumeGeometry& geometry);

/// @param field of the points, for messages. Errors: InvalidField, SegmentLocked.
[[nodiscard]] Result<CutGrowth> cutAt(const std::vector<glm::dvec3>& pointsLps, CutGrowth::How how,
    const Document& document, const QString& field);

struct GrownSegments {
    std::int64_t count = 0; ///< 0: only seeds became members
    QString name{}; ///< of the one, where it is one
};
[[nodiscard]] GrownSegments grownSegments(const ChangeFacts& facts, const Document& document);
/// "120 … 300 HU"
[[nodiscard]] RowTitle intervalTitle(const GrowCriteria& criteria, const Document& document);

/// Of a growth by criteria: every seed word of its plane, since a burst goes on from all members,
/// wherever they are; and the labels (with "only visible" the coverage too) of the voxels it asked,
/// which are members and their neighbours: RowTrace::grownBeside. What its other limits ask is grey
/// values.
[[nodiscard]] EditReach reachOfGrowth(const GrowCriteria& criteria, const ReachFacts& row);

} // namespace core
