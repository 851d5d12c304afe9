// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace gpu {

/// In which colours grey values are shown. HotIron, HotMetalBlue and Pet20Step are the palettes of
/// these names that DICOM defines (PS3.6 annex B.1). EvenLightness goes from nearly black over blue
/// and green to light yellow and grows in lightness (CIE L*) as evenly as the grey scale does.
enum class ColourMap : std::uint8_t { Grey, HotIron, HotMetalBlue, Pet20Step, EvenLightness };
inline constexpr std::size_t colourMaps = 5;

/// Colours by grey value, 0 … 255, each 0xRRGGBB.
using ColourEntries = std::array<std::uint32_t, 256>;
[[nodiscard]] const ColourEntries& entriesOf(ColourMap map);

} // namespace gpu
