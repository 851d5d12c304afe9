// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/ChunkShades.h"

#include "core/chunks/ChunkColours.h"

#include <array>

namespace ui {

namespace {

/// Light and dark, warm and cool, none near another.
constexpr std::array<std::uint32_t, core::ChunkColours::colours> palette{0xE6553C, 0x3F7FE0,
    0xE8D84A, 0xA970E0, 0x35A04F, 0xF2A134, 0x4FC3F7, 0xD63F86, 0x9BD64A, 0x6B5BD6, 0xF0A58A,
    0x3CD0C0, 0xE07AD0, 0xA86B3F, 0xB9C8A4, 0x7F9BC8};

// Of 255: chunks that the segment has, has not, and those a tool is about.
constexpr std::uint32_t ownShare = 255;
constexpr std::uint32_t otherShare = 90;
constexpr std::uint32_t litOwnShare = 255;
constexpr std::uint32_t litOtherShare = 225;

std::uint32_t mixed(std::uint32_t rgb, std::uint32_t other, int percent)
{
    std::uint32_t result = 0;
    for (const int shift : {16, 8, 0}) {
        const int from = int(rgb >> shift & 255U);
        const int to = int(other >> shift & 255U);
        result |= std::uint32_t(from + (to - from) * percent / 100) << shift;
    }
    return result;
}

} // namespace

std::uint32_t argbOf(const ChunkShade& shade)
{
    const std::uint32_t rgb = palette[shade.colour];
    const std::uint32_t share = shade.isHidden ? 0
        : shade.isLit                          ? (shade.isOwn ? litOwnShare : litOtherShare)
                                               : (shade.isOwn ? ownShare : otherShare);
    return share << 24 | (shade.isLit ? mixed(rgb, 0xFFFFFF, 55) : rgb);
}

} // namespace ui
