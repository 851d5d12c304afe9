// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace gpu {

/// The colours in which grey values are shown. HotIron, HotMetalBlue and Pet20Step are the palettes
/// of these names in DICOM PS3.6 annex B.1. EvenLightness goes from nearly black over blue and
/// green to light yellow; its lightness (CIE L*) increases as evenly as that of a grey scale.
enum class ColourMap : std::uint8_t { Grey, HotIron, HotMetalBlue, Pet20Step, EvenLightness };
inline constexpr std::size_t colourMaps = 5;

/// Colours as 0xRRGGBB, by grey value 0 … 255.
using ColourEntries = std::array<std::uint32_t, 256>;
[[nodiscard]] const ColourEntries& entriesOf(ColourMap map);

} // namespace gpu
