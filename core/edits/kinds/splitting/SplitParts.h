// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/VoxelRuns.h"
#include "core/document/Document.h"

#include <QString>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

struct EditEffects;
struct RelabelListed;

/// A new segment that is made from a part of another one.
struct SplitPart {
    QString name{};
    std::uint32_t rgb = 0;
    bool operator==(const SplitPart&) const = default;
};

/// The voxels of a segment on both sides of what splits it.
struct SplitSides {
    VoxelRuns beyond{}; ///< those that the new segment is to have
    std::uint64_t staying = 0; ///< number of those that stay with the segment
    bool isInside = true; ///< of a curve: whether the new segment lies inside of it

    /// Whether there is anything on both sides; otherwise nothing is split.
    [[nodiscard]] bool splits() const { return !beyond.empty() && staying > 0; }
};

/// How many more segments a document can hold. Labels of deleted segments are not used again.
[[nodiscard]] std::size_t roomForSegments(const Document& document);

/// Default names and colours for the parts of a segment: "Liver 1", "Liver 2" …, without names that
/// are taken, in the colours that new segments get. A very long name is cut.
[[nodiscard]] std::vector<SplitPart> usualParts(
    const Document& document, const Segment& segment, std::size_t count);

/// Adds new segments for the parts of a segment to the end of the document's list, in the label
/// plane of that segment. Errors: UnknownSegment, SegmentLocked, InvalidField (there is no room for
/// so many); then nothing is changed.
/// @param segmentField name of the segment's field in recipes, such as "splitIslands.segment"
/// @param field name of the field of its parts, such as "splitIslands.into"
/// @return true: they are added
Result<bool> addParts(const char* segmentField, int segment, const char* field,
    const std::vector<SplitPart>& parts, Document& document);

/// The command that gives what lies beyond to the new segment, whose label is the next free one;
/// without bricks if nothing is split.
/// @pre the segment exists
[[nodiscard]] RelabelListed givenBeyond(
    const SplitSides& sides, int segment, const Document& document);

/// The effects of splitting a segment.
[[nodiscard]] EditEffects splitEffects(int segment, bool isBoundToStudy);

} // namespace core
