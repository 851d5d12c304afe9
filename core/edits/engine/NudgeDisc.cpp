// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/NudgeDisc.h"

#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/parts/BrushPath.h"

namespace core {

Result<NudgeDisc> nudgeDisc(
    const BrushPath& path, const VolumeGeometry& geometry, const QString& name)
{
    if (path.shape != BrushPath::Shape::Disc)
        return failure(ErrorCode::InvalidField, name + QStringLiteral(".shape"),
            Clause::saying("a nudge is a disc"));
    const Result<CapsuleFrame> frame = capsuleFrame(path, geometry, name);
    if (!frame)
        return tl::unexpected(frame.error());
    NudgeDisc disc{.frame = *frame};
    const std::vector<Capsule> begin = capsules(path, geometry, nullptr, {path.pointsLps.front()});
    if (begin.empty())
        return disc;
    disc.centre = begin.front().from;
    disc.bricks = bricksNear(disc.frame, begin.front(), BrickGrid{geometry.size});
    return disc;
}

double fittingRadiusMm(const NudgeStart& start)
{
    return double(start.fittingRadius) / 65536.0;
}

} // namespace core
