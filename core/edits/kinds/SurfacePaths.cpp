// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/SurfacePaths.h"

#include <type_traits>

namespace core {

namespace {

template <class E, class... Es> constexpr bool isOneOf = (std::is_same_v<E, Es> || ...);

template <class E>
constexpr bool hasPath =
    isOneOf<E, MarkSurface, SpherePush, PlaneScrape, PointDrag, SmoothSurface, AttractSurface>;

} // namespace

bool isOfSurface(const Edit& edit)
{
    return std::visit(
        [](const auto& known) {
            using E = std::decay_t<decltype(known)>;
            return hasPath<
                       E> || isOneOf<E, LaySurface, DropSurface, FollowMask, ChangeMarks, ApplyTemplate, WriteBack, SurfaceBarrier>;
        },
        edit);
}

const SurfacePath* surfacePathOf(const Edit& edit)
{
    return std::visit(
        [](const auto& known) -> const SurfacePath* {
            if constexpr (hasPath<std::decay_t<decltype(known)>>)
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
