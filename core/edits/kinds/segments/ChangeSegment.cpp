// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/ChangeSegment.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/EditReach.h"
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

QString rowName(const ChangeSegment& edit, const RowFacts& row)
{
    const Document& document = row.document;
    const Segment* before = document.segment(edit.segment);
    const QString name = quoted(segmentName(edit.segment, document));
    Deeds deeds;
    if (differs(edit.name, before ? &before->name : nullptr))
        deeds.add(
            QStringLiteral("Rename segment %1 to %2").arg(edit.segment).arg(quoted(*edit.name)),
            {});
    if (differs(edit.code, before ? &before->code : nullptr)) {
        if (edit.code->isSet())
            deeds.add(QStringLiteral("Code segment %1 as %2").arg(name, edit.code->meaning),
                QStringLiteral("code it as ") + edit.code->meaning);
        else
            deeds.add(QStringLiteral("Take the code from segment ") + name,
                QStringLiteral("take its code away"));
    }
    if (differs(edit.rgb, before ? &before->rgb : nullptr))
        deeds.add(QStringLiteral("Recolour segment ") + name, QStringLiteral("recolour it"));
    if (differs(edit.locked, before ? &before->locked : nullptr)) {
        if (*edit.locked)
            deeds.add(QStringLiteral("Lock segment ") + name, QStringLiteral("lock it"));
        else
            deeds.add(QStringLiteral("Unlock segment ") + name, QStringLiteral("unlock it"));
    }
    if (differs(edit.uncarvable, before ? &before->uncarvable : nullptr)) {
        if (*edit.uncarvable)
            deeds.add(QStringLiteral("Protect segment %1 from sculpting").arg(name),
                QStringLiteral("protect it from sculpting"));
        else
            deeds.add(QStringLiteral("Let tools carve segment ") + name,
                QStringLiteral("let tools carve it"));
    }
    return deeds.text();
}

EditReach reach(const ChangeSegment&, const ReachFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core
