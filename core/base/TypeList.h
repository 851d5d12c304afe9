// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

namespace core {

/// Types that belong together.
template <class... Ts> struct TypeList {
    using Variant = std::variant<Ts...>;
    /// A pointer to a value of one of these types; converts implicitly from such an address and
    /// from no other.
    using Pointer = std::variant<const Ts*...>;
};

/// Joins the types of several lists into one.
template <class... Lists> struct JoinedTypes;
template <class... Ts> struct JoinedTypes<TypeList<Ts...>> {
    using List = TypeList<Ts...>;
};
template <class... Ts, class... Us, class... Lists>
struct JoinedTypes<TypeList<Ts...>, TypeList<Us...>, Lists...>
    : JoinedTypes<TypeList<Ts..., Us...>, Lists...> {
};

} // namespace core
