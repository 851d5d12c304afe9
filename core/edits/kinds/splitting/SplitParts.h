// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"

#include <QString>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

struct EditEffects;

/// A new segment that is made from a part of another one.
struct SplitPart {
    QString name{};
    std::uint32_t rgb = 0;
    bool operator==(const SplitPart&) const = default;
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

/// The effects of splitting a segment.
[[nodiscard]] EditEffects splitEffects(int segment, bool isBoundToStudy);

} // namespace core
