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

#include <type_traits>
#include <utility>

namespace core {

namespace {

template <class E>
concept hasSurfacePath = std::is_same_v<decltype(E::path), SurfacePath>;

} // namespace

std::optional<SurfaceEdit> surfaceEditOf(const Edit& edit)
{
    std::optional<SurfaceEdit> found;
    visitAmong([&found](const auto& known) { found = known; }, edit, SurfaceKinds());
    return found;
}

const SurfacePath* surfacePathOf(const Edit& edit)
{
    const SurfacePath* path = nullptr;
    const auto look = [&path](const auto& known) {
        if constexpr (hasSurfacePath<std::decay_t<decltype(known)>>)
            path = &known.path;
    };
    visitAmong(look, edit, SurfaceKinds());
    return path;
}

SurfacePath* surfacePathOf(Edit& edit)
{
    return const_cast<SurfacePath*>(surfacePathOf(std::as_const(edit)));
}

} // namespace core
