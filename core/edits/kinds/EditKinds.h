// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"

#include <variant>

namespace core {

template <class Kinds> struct VariantOfKinds;
template <class... Es> struct VariantOfKinds<EditKinds<Es...>> {
    using Type = std::variant<Es...>;
};

/// Whether an edit is of one of some kinds.
template <class... Es> [[nodiscard]] bool isAmong(const Edit& edit, EditKinds<Es...>)
{
    return (edit.is<Es>() || ...);
}

/// Calls the visitor with an edit that is of one of some kinds, as what it is; does nothing with
/// others. Only these kinds have to be whole where this is asked.
template <class Visitor, class... Es>
void visitAmong(const Visitor& visitor, const Edit& edit, EditKinds<Es...>)
{
    const auto visit = [&visitor](const auto* known) {
        if (known)
            visitor(*known);
    };
    (visit(edit.as<Es>()), ...);
}

} // namespace core
