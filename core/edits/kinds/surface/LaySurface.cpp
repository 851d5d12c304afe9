// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/LaySurface.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/ListEdits.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/surface/parts/SurfaceParts.h"

namespace core {

using namespace rowWords;

Result<void> check(const LaySurface& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const LaySurface& edit, Document& document)
{
    if (!document.segment(edit.segment))
        return unknownSegment(edit.segment);
    constexpr int fewest = 100;
    if (edit.vertices != 0 && edit.vertices < fewest)
        return failure(ErrorCode::InvalidField, QStringLiteral("surface.vertices"),
            Clause::saying("%1 are too few: %2 at least, or 0 for as many as it takes",
                edit.vertices, fewest));
    if (!beginsSurface(edit)) {
        if (document.surface && document.surface->segment != edit.segment)
            return failure(ErrorCode::InvalidField, QStringLiteral("surface.segment"),
                Clause::saying("the surface is that of segment %1", document.surface->segment));
        return changeSurface(document, true);
    }
    document.surface = {.segment = edit.segment, .differs = false};
    return true;
}

EditEffects effects(const LaySurface&)
{
    return surfaceEffects(false);
}

RowTitle rowTitle(const LaySurface& lay, const RowFacts& row)
{
    if (!beginsSurface(lay))
        return {.code = RowTitleCode::LayCrossingsAnew,
            .then = {figure(RowTitleCode::Vertices, row.statistics.verticesChanged)}};
    return {.code = RowTitleCode::SurfaceOf,
        .arguments = {segmentName(lay.segment, row.document)},
        .then = {figure(RowTitleCode::Vertices, row.statistics.verticesChanged)}};
}

EditDependencies dependencies(const LaySurface&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core
