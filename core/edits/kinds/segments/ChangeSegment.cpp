// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/ChangeSegment.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/ListEdits.h"
#include "core/edits/answers/RowDeeds.h"
#include "core/edits/answers/RowFacts.h"

namespace core {

using namespace rowWords;

Result<void> check(const ChangeSegment& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const ChangeSegment& edit, Document& document)
{
    Segment* segment = document.segment(edit.segment);
    if (!segment)
        return unknownSegment(edit.segment);
    bool changed = assign(segment->name, edit.name);
    changed |= assign(segment->rgb, edit.rgb);
    changed |= assign(segment->code, edit.code);
    changed |= assign(segment->locked, edit.locked);
    changed |= assign(segment->uncarvable, edit.uncarvable);
    return changed;
}

EditEffects effects(const ChangeSegment&)
{
    return documentEffects(DocumentChange::What::Segments);
}

RowTitle rowTitle(const ChangeSegment& edit, const RowFacts& row)
{
    const Document& document = row.document;
    const Segment* before = document.segment(edit.segment);
    const QString name = segmentName(edit.segment, document);
    Deeds deeds;
    if (differs(edit.name, before ? &before->name : nullptr))
        deeds.add({.code = RowTitleCode::RenameSegment,
                      .arguments = {TitleNumber{edit.segment}, *edit.name}},
            {});
    if (differs(edit.code, before ? &before->code : nullptr)) {
        const QString& meaning = edit.code->meaning;
        if (edit.code->isSet())
            deeds.add({.code = RowTitleCode::CodeSegment, .arguments = {name, meaning}},
                {.code = RowTitleCode::CodeIt, .arguments = {meaning}});
        else
            deeds.add({.code = RowTitleCode::TakeCode, .arguments = {name}},
                {.code = RowTitleCode::TakeItsCode});
    }
    if (differs(edit.rgb, before ? &before->rgb : nullptr))
        deeds.add({.code = RowTitleCode::RecolourSegment, .arguments = {name}},
            {.code = RowTitleCode::RecolourIt});
    if (differs(edit.locked, before ? &before->locked : nullptr)) {
        if (*edit.locked)
            deeds.add({.code = RowTitleCode::LockSegment, .arguments = {name}},
                {.code = RowTitleCode::LockIt});
        else
            deeds.add({.code = RowTitleCode::UnlockSegment, .arguments = {name}},
                {.code = RowTitleCode::UnlockIt});
    }
    if (differs(edit.uncarvable, before ? &before->uncarvable : nullptr)) {
        if (*edit.uncarvable)
            deeds.add({.code = RowTitleCode::ProtectSegment, .arguments = {name}},
                {.code = RowTitleCode::ProtectIt});
        else
            deeds.add({.code = RowTitleCode::LetCarveSegment, .arguments = {name}},
                {.code = RowTitleCode::LetCarveIt});
    }
    return deeds.title();
}

EditDependencies dependencies(const ChangeSegment&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core
