// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

namespace core {

/// Whether a kind of edit is one of these. Visitors name every kind that they treat alike, so that
/// one that is added later does not compile until somebody has thought of it.
template <class E, class... Es> inline constexpr bool isOneOf = (std::is_same_v<E, Es> || ...);

} // namespace core
