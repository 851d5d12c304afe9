// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/growth/GrowthCommands.h"
#include "core/growth/GrowthRange.h"
#include "core/titles/RowTitle.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

struct ChangeFacts;
struct EditableRange;
struct GrowCriteria;
struct GrowGuard;

// Parts that edits of growth share.

/// Whether a plane has segments and all of them are locked.
[[nodiscard]] bool nothingMayChange(const Document& document, int plane);

/// The plane of a growth. @param edit its name, for messages
/// Errors: InvalidField (no segment lies there).
[[nodiscard]] Result<std::uint8_t> growthPlane(
    const std::optional<int>& plane, const Document& document, const QString& edit);
/// Checks that a segment that grows lies there. @param edit as above
/// Errors: InvalidField.
[[nodiscard]] Result<void> checkLiesOn(
    std::uint8_t plane, const Segment& segment, const QString& edit);

/// @param edit its name, for messages Errors: InvalidField (connectivity other than 6, 18 and 26,
/// lower > upper, a box outside the volume, a plane without segments), UnknownSegment,
/// SegmentLocked (no segment may change, or one that is to grow).
[[nodiscard]] Result<GrowBurst> burstOf(
    const GrowCriteria& criteria, const Document& document, const QString& edit);

/// Whether the criteria contain positions in the patient, which have no meaning in another study.
[[nodiscard]] bool namesPlaces(const GrowCriteria& criteria);

/// The voxels that a growth in a plane may take, of an editable range without its box.
/// Errors: UnknownSegment, InvalidField (bounds in the wrong order; a segment of another plane,
/// which no growth knows).
[[nodiscard]] Result<GrowthRange> growthRange(
    const EditableRange& range, std::uint8_t plane, const Document& document, const QString& edit);

/// The rule by which a growth is watched, in integers; none: it is not watched.
[[nodiscard]] std::optional<GuardRule> guardRule(
    const GrowGuard& guard, const VolumeGeometry& geometry);

/// What all kinds of edits that cut a growth have in common.
struct CutPlaces {
    std::vector<glm::dvec3> pointsLps;
    std::optional<int> plane; ///< GrowthPlane.h
    QString edit; ///< its name, for messages
    QString pointsField; ///< likewise, of the points
};
/// Errors: InvalidField, SegmentLocked.
[[nodiscard]] Result<CutGrowth> cutAt(
    const CutPlaces& places, CutGrowth::How how, const Document& document);

struct GrownSegments {
    std::int64_t count = 0; ///< 0: only seeds became members
    QString name{}; ///< its name, if it is a single one
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
