// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/MarkSurface.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/EditReach.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/surface/SurfaceParts.h"

namespace core {

using namespace rowWords;

Result<void> check(const MarkSurface& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const MarkSurface&, Document& document)
{
    return changeSurface(document, false);
}

EditEffects effects(const MarkSurface&)
{
    return surfaceEffects(true);
}

QString rowName(const MarkSurface& mark, const RowFacts& row)
{
    return withVertices(QStringLiteral("Mark %1, brush %2")
                            .arg(markWord(mark.mark), millimetres(mark.path.radiusMm)),
        row.statistics);
}

EditReach reach(const MarkSurface&, const ReachFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core
