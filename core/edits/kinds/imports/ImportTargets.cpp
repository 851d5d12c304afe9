// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/imports/ImportTargets.h"

#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/parts/SegmentChoice.h"

#include <algorithm>

namespace core {

namespace {

constexpr int mostLabels = 255;

tl::unexpected<Error> notSo(const char* field, const Clause& reason)
{
    return failure(ErrorCode::InvalidField, QLatin1String(field), reason);
}

/// What importMask means by its "as": one that is there; none: a new one.
Result<std::optional<int>> segmentMeant(const ImportMask& edit, const Document& document)
{
    if (!edit.as)
        return std::optional<int>();
    if (edit.as->number) {
        if (!document.segment(*edit.as->number))
            return failure(ErrorCode::UnknownSegment, QString::number(*edit.as->number),
                Clause::saying("in field 'importMask.as'"));
        return edit.as->number;
    }
    const auto named = std::find_if(document.segments.begin(), document.segments.end(),
        [&](const Segment& segment) { return segment.name == edit.as->name; });
    return named == document.segments.end() ? std::optional<int>()
                                            : std::optional<int>(named->label);
}

Result<void> checkPlanes(const ImportMask& edit)
{
    if (!edit.planes)
        return {};
    if (edit.as)
        return notSo("importMask.planes", Clause::saying("all becomes one segment, of one plane"));
    if (edit.planes->size() != edit.segments->size())
        return notSo("importMask.planes",
            Clause::saying("names %1 planes, the list has %2 segments", edit.planes->size(),
                edit.segments->size()));
    return {};
}

} // namespace

std::bitset<256> overwrittenBy(const ImportMask& edit, int plane, const Document& document)
{
    return edit.overwriteUnlocked ? document.unlockedLabels(plane) : std::bitset<256>();
}

Result<ImportTargets> importTargets(const ImportMask& edit, const Document& document)
{
    if (!edit.segments || !edit.size)
        return notSo("importMask.segments", Clause::saying("its file has not been read"));
    const Result<std::optional<int>> meant = segmentMeant(edit, document);
    if (!meant)
        return tl::unexpected(meant.error());
    ImportTargets result{.targets = {}, .isNew = !*meant};
    const int room = mostLabels - document.lastLabelGiven();
    const auto wanted = std::ssize(*edit.segments);
    for (const int place : edit.ahead.value_or(std::vector<int>())) {
        if (place < 1 || place > wanted)
            return notSo("importMask.ahead",
                Clause::saying("there is no segment %1 in its list of %2", place, wanted));
    }
    if (result.isNew && (edit.as ? 1 : wanted) > room)
        return notSo("importMask.segments",
            Clause::saying("there is room for %1 segments more, it brings %2", room, wanted));
    Result<LabelTarget> target =
        labelTarget({.segment = *meant, .name = {}}, edit.overwriteUnlocked, document);
    if (!target)
        return tl::unexpected(target.error());
    if (const Result<void> planes = checkPlanes(edit); !planes)
        return tl::unexpected(planes.error());
    for (std::ptrdiff_t i = 0; i < wanted; ++i) {
        LabelTarget& its = result.targets.emplace_back(*target);
        if (edit.planes) {
            its.plane = std::uint8_t((*edit.planes)[std::size_t(i)]);
            its.overwritable = overwrittenBy(edit, its.plane, document);
        }
        if (!edit.as)
            ++target->label;
    }
    return result;
}

std::vector<std::size_t> segmentsByPrecedence(
    const std::optional<std::vector<int>>& ahead, std::size_t count)
{
    std::vector<std::size_t> order;
    std::vector<bool> taken(count, false);
    const auto take = [&](std::size_t segment) {
        if (segment < count && !taken[segment])
            order.push_back(segment);
        if (segment < count)
            taken[segment] = true;
    };
    for (const int place : ahead.value_or(std::vector<int>())) {
        if (place >= 1)
            take(std::size_t(place) - 1);
    }
    for (std::size_t segment = 0; segment < count; ++segment)
        take(segment);
    return order;
}

} // namespace core
