// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/AddSegment.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/parts/SegmentChoice.h"

namespace core {

namespace {

constexpr int lastLabel = 255;

} // namespace

Result<void> check(const AddSegment& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const AddSegment& edit, Document& document)
{
    const int label = document.lastLabelGiven() + 1;
    if (label > lastLabel)
        return failure(ErrorCode::InvalidField, QStringLiteral("addSegment"),
            Clause::saying(
                "a label plane has room for %1 segments, those deleted included", lastLabel));
    document.segments.push_back({.label = std::uint8_t(label),
        .plane = std::uint8_t(edit.plane.value_or(0)),
        .name = edit.name,
        .rgb = edit.rgb,
        .code = edit.code});
    return true;
}

Result<bool> addNewSegment(const SegmentChoice& choice, Document& document)
{
    if (choice.segment)
        return false;
    return apply(AddSegment{.name = choice.name, .rgb = choice.rgb, .code = {}}, document);
}

Result<void> checkNewSegment(const SegmentChoice& choice, const Document& document)
{
    if (choice.segment)
        return {};
    Document copy = document;
    return discardValue(addNewSegment(choice, copy));
}

EditEffects effectsOn(const SegmentChoice& choice, EditTask task, bool boundToStudy)
{
    return {.task = task,
        .standsOpen = false,
        .changes = choice.segment ? std::nullopt : std::optional(DocumentChange::What::Segments),
        .takesVoxelsOrNothing = true,
        .writesTo = choice.segment,
        .fills = {.label = choice.segment, .added = AddedSegments::Known},
        .boundToStudy = boundToStudy};
}

EditEffects effects(const AddSegment&)
{
    return documentEffects(DocumentChange::What::Segments);
}

RowTitle rowTitle(const AddSegment& edit, const RowFacts&)
{
    return {.code = RowTitleCode::AddSegment, .arguments = {edit.name}};
}

EditDependencies dependencies(const AddSegment&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core
