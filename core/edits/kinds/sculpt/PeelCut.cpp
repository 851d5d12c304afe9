// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/sculpt/PeelCut.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/CutFrames.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/sculpt/CutParts.h"
#include "core/edits/kinds/sculpt/OutlinedPlane.h"

#include <utility>

namespace core {

using namespace rowWords;

namespace {

/// No peel reaches farther than this along the view, however steep the surface.
constexpr double farthestPeelMm = 64.0;

} // namespace

Result<void> check(const PeelCut& edit, const Document& document)
{
    return checkCut(edit, "peel.layer", shellPeel(edit, document), document);
}

Result<bool> apply(const PeelCut&, Document&)
{
    return false;
}

EditEffects effects(const PeelCut&)
{
    return {.task = engineTask<PeelCut>(),
        .standsOpen = true,
        .fills = fillsNothing,
        .boundToStudy = true};
}

Result<ShellPeel> shellPeel(const PeelCut& peel, const Document& document)
{
    Result<OutlinedPlane> plane = outlinedPlane(peel.polygonMm,
        {.view = peel.view,
            .surfaceThreshold = peel.surfaceThreshold,
            .maxDepthMm = farthestPeelMm,
            .throughGaps = peel.throughGaps,
            .restore = peel.restore,
            .hidden = peel.hidden,
            .protectedSegments = peel.protectedSegments},
        document, QStringLiteral("peel"));
    if (!plane)
        return tl::unexpected(plane.error());
    ShellPeel made{.layer = std::uint8_t(peel.layer), .frame = plane->frame};
    made.mask = std::move(plane->mask);
    if (peel.jumpMm > 0.0)
        made.jump = mm16(peel.jumpMm);
    made.laying = peel.restore ? Laying::Refill : Laying::Carve;
    return made;
}

PeelDepth peelDepth(const PeelCut& peel)
{
    return {mm16(peel.depthMm)};
}

Result<EngineEdit> engineEdit(const PeelCut& edit, const Document& document)
{
    return engineEditFrom(shellPeel(edit, document));
}

/// "Peel 4.0 mm, 214 bricks".
RowTitle rowTitle(const PeelCut& peel, const RowFacts& row)
{
    return {.code = peel.restore ? RowTitleCode::RestorePeel : RowTitleCode::Peel,
        .arguments = {inMm(peel.depthMm)},
        .then = {figure(RowTitleCode::Bricks, row.statistics.bricks)}};
}

EditDependencies dependencies(const PeelCut& edit, const DependencyFacts& row)
{
    const Result<ShellPeel> cut = shellPeel(edit, row.document);
    if (!cut)
        return reachesNothing();
    return sweptOutline(cut->frame, edit.polygonMm, labelsReadBy(edit, row.document), row);
}

} // namespace core
