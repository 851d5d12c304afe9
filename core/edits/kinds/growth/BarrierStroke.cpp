// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/BarrierStroke.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/criteria/GrowthParts.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/edits/open/OpenBrush.h"

namespace core {

using namespace rowWords;

Result<void> check(const BarrierStroke& edit, const Document& document)
{
    return discardValue(paintBarrier(edit, document));
}

Result<bool> apply(const BarrierStroke&, Document&)
{
    return false;
}

EditEffects effects(const BarrierStroke&)
{
    return {.task = engineTask<BarrierStroke>(),
        .standsOpen = opens<BarrierStroke>(),
        .fills = fillsNothing,
        .boundToStudy = true};
}

Result<PaintBarrier> paintBarrier(const BarrierStroke& stroke, const Document& document)
{
    const Result<CapsuleFrame> frame =
        capsuleFrame(stroke.path, document.volumes.front().geometry, QStringLiteral("barrier"));
    if (!frame)
        return tl::unexpected(frame.error());
    const Result<std::uint8_t> plane =
        growthPlane(stroke.plane, document, QStringLiteral("barrier"));
    if (!plane)
        return tl::unexpected(plane.error());
    PaintBarrier barrier;
    barrier.plane = *plane;
    barrier.erase = stroke.erase;
    barrier.frame = *frame;
    barrier.lockedLabels = document.lockedLabels(barrier.plane);
    return barrier;
}

Result<EngineEdit> engineEdit(const BarrierStroke& edit, const Document& document)
{
    return engineEditFrom(paintBarrier(edit, document));
}

std::unique_ptr<OpenStroke> openStroke(BarrierStroke& edit)
{
    return std::make_unique<OpenBrush>(edit.path);
}

RowTitle rowTitle(const BarrierStroke& edit, const RowFacts& row)
{
    return {.code = edit.erase ? RowTitleCode::OpenBarrier : RowTitleCode::Barrier,
        .arguments = {inMm(edit.path.radiusMm)},
        .then = {figure(RowTitleCode::Voxels, row.facts.seedWordsChanged)}};
}

EditDependencies dependencies(const BarrierStroke& edit, const DependencyFacts& row)
{
    return row.labelled(edit.path, growthPlaneOf(edit.plane));
}

} // namespace core
