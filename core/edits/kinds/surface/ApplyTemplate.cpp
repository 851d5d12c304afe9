// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/ApplyTemplate.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/EditReach.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/surface/SurfaceParts.h"

namespace core {

using namespace rowWords;

Result<void> check(const ApplyTemplate& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const ApplyTemplate&, Document& document)
{
    return changeSurface(document, true);
}

EditEffects effects(const ApplyTemplate&)
{
    return surfaceEffects(true);
}

QString rowName(const ApplyTemplate& shape, const RowFacts& row)
{
    return withVertices(QStringLiteral("Template of %1")
                            .arg(counted(std::int64_t(shape.contoursLps.size()), "contour")),
        row.statistics);
}

EditReach reach(const ApplyTemplate&, const ReachFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core
