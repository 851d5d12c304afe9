// SPDX-License-Identifier: Apache-2.0
#include "gpu/scene/ColourMap.h"

#include <span>

namespace gpu {

namespace {

struct Knot {
    int entry = 0;
    std::uint32_t rgb = 0; ///< 0xRRGGBB
};

// The palettes of DICOM consist of straight lines: between these knots, rounded to whole numbers,
// they are met in all their entries.
constexpr std::array<Knot, 2> greyKnots{{{0, 0x000000}, {255, 0xFFFFFF}}};
constexpr std::array<Knot, 6> hotIronKnots{{{0, 0x000000}, {126, 0xFC0000}, {128, 0xFF0000},
    {191, 0xFF7E00}, {254, 0xFFFCFC}, {255, 0xFFFFFF}}};
constexpr std::array<Knot, 12> hotMetalBlueKnots{{{0, 0x000000}, {16, 0x00001F}, {34, 0x000043},
    {68, 0x000085}, {85, 0x0000A7}, {102, 0x3200C8}, {119, 0x5A0096}, {136, 0x8C2032},
    {153, 0xBE4000}, {170, 0xFF6000}, {238, 0xFFE0C8}, {255, 0xFFFFFF}}};
/// Points of a curve through CIE L*a*b*, whose lightness grows from 4 to 96.
constexpr std::array<Knot, 12> evenLightnessKnots{{{0, 0x100B1B}, {23, 0x012046}, {46, 0x013456},
    {70, 0x034A66}, {93, 0x036076}, {116, 0x037885}, {139, 0x05918F}, {162, 0x01AB90},
    {185, 0x32C582}, {209, 0x86D879}, {232, 0xC7E878}, {255, 0xFFF5BD}}};
/// A step begins at each.
constexpr std::array<Knot, 20> pet20Steps{
    {{0, 0x000000}, {13, 0x600050}, {26, 0x303050}, {39, 0x303070}, {51, 0x505080}, {64, 0x6060B0},
        {77, 0x7070C0}, {90, 0x8080E0}, {102, 0x306030}, {115, 0x309030}, {128, 0x50C050},
        {141, 0x40E040}, {153, 0xE0E050}, {166, 0xD0D060}, {179, 0xD0B040}, {192, 0xD09000},
        {204, 0xC06000}, {217, 0xB03000}, {230, 0xFF0000}, {243, 0xFFFFFF}}};

/// @param beyond how far it lies from the lower knot, out of @p length
std::uint32_t between(std::uint32_t low, std::uint32_t high, int beyond, int length)
{
    std::uint32_t rgb = 0;
    for (const int shift : {16, 8, 0}) {
        const int a = int(low >> shift & 255U);
        const int b = int(high >> shift & 255U);
        const int sum = a * (length - beyond) + b * beyond;
        rgb |= std::uint32_t((2 * sum + length) / (2 * length)) << shift;
    }
    return rgb;
}

/// @param knots the first is entry 0, the last entry 255
ColourEntries lines(std::span<const Knot> knots)
{
    ColourEntries entries{};
    for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
        const Knot& low = knots[k];
        const Knot& high = knots[k + 1];
        for (int i = low.entry; i <= high.entry; ++i)
            entries[std::size_t(i)] =
                between(low.rgb, high.rgb, i - low.entry, high.entry - low.entry);
    }
    return entries;
}

ColourEntries steps(std::span<const Knot> knots)
{
    ColourEntries entries{};
    for (const Knot& knot : knots)
        for (auto i = std::size_t(knot.entry); i < entries.size(); ++i)
            entries[i] = knot.rgb;
    return entries;
}

} // namespace

const ColourEntries& entriesOf(ColourMap map)
{
    static const std::array<ColourEntries, colourMaps> all{lines(greyKnots), lines(hotIronKnots),
        lines(hotMetalBlueKnots), steps(pet20Steps), lines(evenLightnessKnots)};
    return all[std::size_t(map)];
}

} // namespace gpu
