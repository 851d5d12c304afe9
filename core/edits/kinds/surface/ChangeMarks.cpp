// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/ChangeMarks.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/EditReach.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/surface/SurfaceParts.h"

namespace core {

namespace {

QString marksName(const ChangeMarks& change)
{
    const QString word = markWord(change.mark);
    const QString what = change.nearLps ? QStringLiteral("region") : QStringLiteral("marks");
    switch (change.way) {
    case ChangeMarks::Way::Grow:
        return QStringLiteral("Grow %1 marks").arg(word);
    case ChangeMarks::Way::Shrink:
        return QStringLiteral("Shrink %1 marks").arg(word);
    case ChangeMarks::Way::Invert:
        return QStringLiteral("Invert %1 marks").arg(word);
    case ChangeMarks::Way::Accept:
        return QStringLiteral("Sign off %1 %2").arg(word, what);
    case ChangeMarks::Way::Clear:
        break;
    }
    return QStringLiteral("Clear %1 %2").arg(word, what);
}

} // namespace

Result<void> check(const ChangeMarks& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const ChangeMarks& edit, Document& document)
{
    if (edit.mark == SurfaceMark::Yellow)
        return failure(ErrorCode::InvalidField, QStringLiteral("changeMarks.mark"),
            QStringLiteral("yellow is what is not marked"));
    using Way = ChangeMarks::Way;
    if (edit.way == Way::Accept && edit.mark != SurfaceMark::Red)
        return failure(ErrorCode::InvalidField, QStringLiteral("changeMarks.mark"),
            QStringLiteral("only what is red can be accepted"));
    if (edit.nearLps && edit.way != Way::Clear && edit.way != Way::Accept)
        return failure(ErrorCode::InvalidField, QStringLiteral("changeMarks.nearLps"),
            QStringLiteral("goes with clear and accept"));
    return changeSurface(document, false);
}

EditEffects effects(const ChangeMarks&)
{
    return surfaceEffects(false);
}

QString rowName(const ChangeMarks& change, const RowFacts& row)
{
    return withVertices(marksName(change), row.statistics);
}

EditReach reach(const ChangeMarks&, const ReachFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core
