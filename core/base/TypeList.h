// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

namespace core {

/// Types that belong together.
template <class... Ts> struct TypeList {
    using Variant = std::variant<Ts...>;
    /// To a value of one of them, which is not copied; implicit from its address, and from that of
    /// no other type.
    using Pointer = std::variant<const Ts*...>;
};

/// One list of the types of several.
template <class... Lists> struct JoinedTypes;
template <class... Ts> struct JoinedTypes<TypeList<Ts...>> {
    using List = TypeList<Ts...>;
};
template <class... Ts, class... Us, class... Lists>
struct JoinedTypes<TypeList<Ts...>, TypeList<Us...>, Lists...>
    : JoinedTypes<TypeList<Ts..., Us...>, Lists...> {
};

} // namespace core
