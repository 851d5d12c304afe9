// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/splitting/SplitParts.h"

#include "core/document/SegmentColours.h"
#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/engine/ListedRuns.h"

#include <algorithm>
#include <optional>

namespace core {

namespace {

constexpr int highestLabel = 255;

/// The beginning of a name that leaves room for a number behind it.
QString stemOf(const QString& name)
{
    constexpr qsizetype most = 240; // a name has at most 256
    QString stem = name.left(most);
    if (!stem.isEmpty() && stem.back().isHighSurrogate())
        stem.chop(1);
    return stem;
}

} // namespace

std::size_t roomForSegments(const Document& document)
{
    return std::size_t(highestLabel - document.lastLabelGiven());
}

std::vector<SplitPart> usualParts(
    const Document& document, const Segment& segment, std::size_t count)
{
    std::vector<SplitPart> parts;
    const QString stem = stemOf(segment.name);
    for (int number = 1; parts.size() < count; ++number) {
        const QString name = stem + QStringLiteral(" %1").arg(number);
        const bool isTaken = std::any_of(document.segments.begin(), document.segments.end(),
            [&name](const Segment& other) { return other.name == name; });
        if (!isTaken)
            parts.push_back(
                {.name = name, .rgb = usualSegmentColour(document.segments.size() + parts.size())});
    }
    return parts;
}

Result<bool> addParts(const char* segmentField, int segment, const char* field,
    const std::vector<SplitPart>& parts, Document& document)
{
    const Result<const Segment*> split = unlockedSegment(segmentField, segment, document);
    if (!split)
        return tl::unexpected(split.error());
    if (const std::size_t room = roomForSegments(document); parts.size() > room)
        return failure(ErrorCode::InvalidField, QLatin1String(field),
            Clause::saying("there is room for %1 segments more, these are %2", room, parts.size()));
    const std::uint8_t plane = (*split)->plane; // the list may move
    for (const SplitPart& part : parts)
        document.segments.push_back({.label = std::uint8_t(document.lastLabelGiven() + 1),
            .plane = plane,
            .name = part.name,
            .rgb = part.rgb,
            .code = {}});
    return true;
}

RelabelListed givenBeyond(const SplitSides& sides, int segment, const Document& document)
{
    const Segment& split = *document.segment(segment);
    LabelTarget target{.plane = split.plane, .label = std::uint8_t(document.lastLabelGiven() + 1)};
    target.overwritable.set(split.label);
    ListedRuns listed(document.volumes.front().geometry.size);
    if (sides.splits())
        listed.add(sides.beyond, RelabelListed::give);
    return listed.relabel(target);
}

EditEffects splitEffects(int segment, bool isBoundToStudy)
{
    return {.task = EditTask::Islands,
        .standsOpen = false,
        .changes = DocumentChange::What::Segments,
        .takesVoxelsOrNothing = true,
        .writesTo = segment,
        .fills = {.label = std::nullopt, .added = AddedSegments::Known},
        .boundToStudy = isBoundToStudy};
}

} // namespace core
