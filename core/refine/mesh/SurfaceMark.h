// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace core {

/// What is thought of a place of the surface (seed B §4.3).
enum class SurfaceMark : std::uint8_t {
    Yellow, ///< follows the boundary of the mask
    Green, ///< right: nothing moves it
    Red, ///< wrong: free of the mask, tools may change it
};

} // namespace core
