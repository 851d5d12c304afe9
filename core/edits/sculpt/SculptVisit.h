// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/sculpt/LaserStroke.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "core/edits/sculpt/SculptEdits.h"

#include <utility>
#include <variant>

namespace core {

/// The kind of a cut. @tparam Cut SculptEdit, const or not
template <class Cut, class... Es> auto sculptKindOf(Cut& cut, EditKinds<Es...>)
{
    std::variant<decltype(cut.template as<Es>())...> found;
    const auto take = [&found](auto* known) {
        if (known)
            found = known;
    };
    (take(cut.template as<Es>()), ...);
    return found;
}

/// Calls the visitor with the actual edit; it must handle every kind.
template <class Visitor> decltype(auto) visitSculpt(Visitor&& visitor, const SculptEdit& cut)
{
    return std::visit([&visitor](const auto* known) -> decltype(auto) { return visitor(*known); },
        sculptKindOf(cut, SculptKinds()));
}
template <class Visitor> decltype(auto) visitSculpt(Visitor&& visitor, SculptEdit& cut)
{
    return std::visit([&visitor](auto* known) -> decltype(auto) { return visitor(*known); },
        sculptKindOf(cut, SculptKinds()));
}

} // namespace core
