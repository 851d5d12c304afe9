// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"

#include "core/edits/engine/HiddenSides.h"
#include "core/edits/engine/SparedSegments.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"

namespace core {

Result<PaintBarrier> paintBarrier(const BarrierStroke& stroke, const Document& document)
{
    const Result<CapsuleFrame> frame =
        capsuleFrame(stroke.path, document.volumes.front().geometry, QStringLiteral("barrier"));
    if (!frame)
        return tl::unexpected(frame.error());
    PaintBarrier barrier;
    barrier.erase = stroke.erase;
    barrier.frame = *frame;
    barrier.frozen = document.lockedLabels(barrier.plane);
    return barrier;
}

Result<CapsuleCut> capsuleCut(const BrushStroke& stroke, const Document& document)
{
    const Result<CapsuleFrame> frame =
        capsuleFrame(stroke.path, document.volumes.front().geometry, QStringLiteral("brush"));
    if (!frame)
        return tl::unexpected(frame.error());
    if (const Result<void> checked =
            checkSpared(stroke.spared, stroke.restore, QStringLiteral("brush"));
        !checked)
        return tl::unexpected(checked.error());
    CapsuleCut cut;
    cut.layer = std::uint8_t(stroke.layer);
    cut.restore = stroke.restore;
    cut.frame = *frame;
    cut.hidden = hiddenHalves(stroke.hidden, document.volumes.front().geometry);
    cut.spared = sparedLabels(stroke.spared, document);
    return cut;
}

} // namespace core
