// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace core {

/// The colour, 0xRRGGBB, of a segment for which none was chosen. @p place is its number, from 0.
[[nodiscard]] inline std::uint32_t usualSegmentColour(std::size_t place)
{
    constexpr std::array<std::uint32_t, 12> colours{0x4a9bff, 0x5bc07c, 0xf0b04a, 0xef6a5b,
        0xb98cf0, 0x4fc7c7, 0xe889b5, 0xc9d14f, 0x7f9cf5, 0xd98e5f, 0x8fd694, 0xe5dcc3};
    return colours[place % colours.size()];
}

} // namespace core
