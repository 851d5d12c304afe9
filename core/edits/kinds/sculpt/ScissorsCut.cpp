// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/sculpt/ScissorsCut.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/CutFrames.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/sculpt/CutParts.h"
#include "core/edits/kinds/sculpt/OutlinedPlane.h"

#include <algorithm>
#include <utility>

namespace core {

using namespace rowWords;

namespace {

constexpr double wholeVolumeMm = 10000.0;

} // namespace

Result<void> check(const ScissorsCut& edit, const Document& document)
{
    return checkCut(edit, "scissors.layer", outlineCut(edit, document), document);
}

Result<bool> apply(const ScissorsCut&, Document&)
{
    return false;
}

EditEffects effects(const ScissorsCut&)
{
    return {.task = engineTask<ScissorsCut>(),
        .standsOpen = false,
        .fills = fillsNothing,
        .boundToStudy = true};
}

Result<OutlineCut> outlineCut(const ScissorsCut& cut, const Document& document)
{
    if (cut.restore && cut.firstLayerOnly)
        return failure(ErrorCode::InvalidField, QStringLiteral("scissors.firstLayerOnly"),
            Clause::saying("has no meaning while restoring"));
    Result<OutlinedPlane> plane = outlinedPlane(cut.polygonMm,
        {.view = cut.view,
            .surfaceThreshold = cut.surfaceThreshold,
            .maxDepthMm = std::min(cut.depthMm.value_or(wholeVolumeMm), wholeVolumeMm),
            .throughGaps = !cut.firstLayerOnly,
            .restore = cut.restore,
            .hidden = cut.hidden,
            .protectedSegments = cut.protectedSegments},
        document, QStringLiteral("scissors"));
    if (!plane)
        return tl::unexpected(plane.error());
    OutlineCut made{.layer = std::uint8_t(cut.layer), .frame = plane->frame};
    made.mask = std::move(plane->mask);
    made.fromSurface = cut.depthMm || cut.firstLayerOnly;
    made.laying = cut.restore ? Laying::Refill : Laying::Carve;
    return made;
}

Result<EngineEdit> engineEdit(const ScissorsCut& edit, const Document& document)
{
    return engineEditFrom(outlineCut(edit, document));
}

namespace {

RowTitleCode titleCode(const ScissorsCut& cut)
{
    if (cut.restore && cut.depthMm)
        return cut.firstLayerOnly ? RowTitleCode::RestoreScissorsDeepFirst
                                  : RowTitleCode::RestoreScissorsDeep;
    if (cut.restore)
        return cut.firstLayerOnly ? RowTitleCode::RestoreScissorsFirst
                                  : RowTitleCode::RestoreScissors;
    if (cut.depthMm)
        return cut.firstLayerOnly ? RowTitleCode::CarveScissorsDeepFirst
                                  : RowTitleCode::CarveScissorsDeep;
    return cut.firstLayerOnly ? RowTitleCode::CarveScissorsFirst : RowTitleCode::CarveScissors;
}

} // namespace

/// "Carve scissors 12.0 mm deep, 214 bricks".
RowTitle rowTitle(const ScissorsCut& cut, const RowFacts& row)
{
    RowTitle title{
        .code = titleCode(cut), .then = {figure(RowTitleCode::Bricks, row.statistics.bricks)}};
    if (cut.depthMm)
        title.arguments = {inMm(*cut.depthMm)};
    return title;
}

EditDependencies dependencies(const ScissorsCut& edit, const DependencyFacts& row)
{
    const Result<OutlineCut> cut = outlineCut(edit, row.document);
    if (!cut)
        return reachesNothing();
    return sweptOutline(cut->frame, edit.polygonMm, labelsReadBy(edit, row.document), row);
}

} // namespace core
