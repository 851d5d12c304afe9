// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"

#include <variant>

namespace core {

template <class Kinds> struct VariantOfKinds;
template <class... Es> struct VariantOfKinds<EditKinds<Es...>> {
    using Type = std::variant<Es...>;
};

/// Whether an edit is of one of the given kinds.
template <class... Es> [[nodiscard]] bool isAmong(const Edit& edit, EditKinds<Es...>)
{
    return (edit.is<Es>() || ...);
}

/// Calls the visitor with the actual edit if it is of one of the given kinds; otherwise does
/// nothing. Only the headers of these kinds are needed.
template <class Visitor, class... Es>
void visitAmong(const Visitor& visitor, const Edit& edit, EditKinds<Es...>)
{
    const auto visit = [&visitor](const auto* known) {
        if (known)
            visitor(*known);
    };
    (visit(edit.as<Es>()), ...);
}
template <class Visitor, class... Es>
void visitAmong(const Visitor& visitor, Edit& edit, EditKinds<Es...>)
{
    const auto visit = [&visitor](auto* known) {
        if (known)
            visitor(*known);
    };
    (visit(edit.as<Es>()), ...);
}

} // namespace core
