// SPDX-License-Identifier: Apache-2.0
#pragma once

// Every kind of edit, whole. Only sources that ask all of them alike include this: they are built
// anew when any edit changes.

#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/Edits.h"

#include <utility>
#include <variant>

namespace core {

template <class Kinds> struct VariantOfKinds;
template <class... Es> struct VariantOfKinds<EditKinds<Es...>> {
    using Type = std::variant<Es...>;
};

struct EditVariant : VariantOfKinds<AllEdits>::Type {
    using VariantOfKinds<AllEdits>::Type::variant;
};

/// Calls the visitor with the edit as what it is. It must have an answer for every kind: one that
/// it forgot does not compile.
template <class Visitor> decltype(auto) visitEdit(Visitor&& visitor, const Edit& edit)
{
    return std::visit(std::forward<Visitor>(visitor), edit.any());
}
template <class Visitor> decltype(auto) visitEdit(Visitor&& visitor, Edit& edit)
{
    return std::visit(std::forward<Visitor>(visitor), edit.any());
}

} // namespace core
