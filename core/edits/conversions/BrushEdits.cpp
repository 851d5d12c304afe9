// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"

#include "core/edits/kinds/growth/BarrierStroke.h"

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

} // namespace core
