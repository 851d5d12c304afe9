// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/SurfaceEdit.h"

#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/kinds/IsOneOf.h"

#include <type_traits>
#include <utility>

namespace core {

std::optional<SurfaceEdit> surfaceEditOf(const Edit& edit)
{
    return visitEdit(
        [](const auto& known) -> std::optional<SurfaceEdit> {
            if constexpr (std::is_constructible_v<SurfaceEdit, decltype(known)>)
                return known;
            else
                return std::nullopt;
        },
        edit);
}

const SurfacePath* surfacePathOf(const Edit& edit)
{
    return visitEdit(
        [](const auto& known) -> const SurfacePath* {
            using E = std::decay_t<decltype(known)>;
            if constexpr (isOneOf<E, MarkSurface, SpherePush, PlaneScrape, PointDrag, SmoothSurface,
                              AttractSurface>)
                return &known.path;
            else
                return nullptr;
        },
        edit);
}

SurfacePath* surfacePathOf(Edit& edit)
{
    return const_cast<SurfacePath*>(surfacePathOf(std::as_const(edit)));
}

} // namespace core
