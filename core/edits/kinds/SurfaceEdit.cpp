// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/SurfaceEdit.h"

#include "core/edits/kinds/surface/ApplyTemplate.h"
#include "core/edits/kinds/surface/AttractSurface.h"
#include "core/edits/kinds/surface/ChangeMarks.h"
#include "core/edits/kinds/surface/DropSurface.h"
#include "core/edits/kinds/surface/FollowMask.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/MarkSurface.h"
#include "core/edits/kinds/surface/PlaneScrape.h"
#include "core/edits/kinds/surface/PointDrag.h"
#include "core/edits/kinds/surface/SmoothSurface.h"
#include "core/edits/kinds/surface/SpherePush.h"
#include "core/edits/kinds/surface/SurfaceBarrier.h"
#include "core/edits/kinds/surface/WriteBack.h"

#include <utility>

namespace core {

std::optional<SurfaceEdit> surfaceEditOf(const Edit& edit)
{
    std::optional<SurfaceEdit> found;
    visitAmong([&found](const auto& known) { found = known; }, edit, SurfaceKinds());
    return found;
}

const SurfacePath* surfacePathOf(const Edit& edit)
{
    using WithPath =
        EditKinds<MarkSurface, SpherePush, PlaneScrape, PointDrag, SmoothSurface, AttractSurface>;
    const SurfacePath* path = nullptr;
    visitAmong([&path](const auto& known) { path = &known.path; }, edit, WithPath());
    return path;
}

SurfacePath* surfacePathOf(Edit& edit)
{
    return const_cast<SurfacePath*>(surfacePathOf(std::as_const(edit)));
}

} // namespace core
