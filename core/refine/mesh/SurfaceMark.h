// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace core {

/// The user's judgement on a place of the surface (seed B §4.3).
enum class SurfaceMark : std::uint8_t {
    Yellow, ///< follows the boundary of the mask
    Green, ///< approved: nothing moves it
    Red, ///< wrong: independent of the mask, tools may change it
};

} // namespace core
