// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

namespace core {

/// Whether a kind of edit is one of these. Visitors list every kind that they treat alike, so that
/// a kind added later does not compile until it was considered.
template <class E, class... Es> inline constexpr bool isOneOf = (std::is_same_v<E, Es> || ...);

} // namespace core
