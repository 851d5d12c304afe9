// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/answers/EditAnswers.h"

#include <QString>

#include <cstdint>
#include <optional>

namespace core {

enum class EditTask;
struct SegmentChoice;

/// Add a segment without voxels to the end of the list.
struct AddSegment {
    QString name{};
    std::uint32_t rgb = 0;
    CodedConcept code{};
    /// Its label plane: it may share voxels with segments of other planes. None: the first plane.
    std::optional<int> plane{};
};

[[nodiscard]] Result<void> check(const AddSegment& edit, const Document& document);
Result<bool> apply(const AddSegment& edit, Document& document);
[[nodiscard]] EditEffects effects(const AddSegment& edit);
[[nodiscard]] RowTitle rowTitle(const AddSegment& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const AddSegment& edit, const DependencyFacts& row);

/// Adds the segment that receives voxels if it is a new one; returns whether it is. Edits with a
/// SegmentChoice are carried out only if they take voxels (EditEffects::takesVoxelsOrNothing), so a
/// new segment is never left empty.
Result<bool> addNewSegment(const SegmentChoice& choice, Document& document);
/// Whether there is room for it, if it is a new one.
[[nodiscard]] Result<void> checkNewSegment(const SegmentChoice& choice, const Document& document);
/// The effects of an edit that gives voxels to the chosen segment and is carried out whole.
[[nodiscard]] EditEffects effectsOn(const SegmentChoice& choice, EditTask task, bool boundToStudy);

} // namespace core
