// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/parts/ColourTable.h"

#include <vector>

namespace gpu {

namespace {

constexpr GLuint colourUnit = 29; // colourMap.glsl

} // namespace

ColourTable::ColourTable()
    : m_texture({.label = "colour map", .size = {256, 1}, .format = GL_RGBA8})
{
    m_texture.clear();
}

void ColourTable::bind(Program& program, ColourMap map)
{
    if (map != ColourMap::Grey && map != m_current) {
        std::vector<std::uint8_t> texels;
        for (const std::uint32_t rgb : entriesOf(map)) {
            texels.push_back(std::uint8_t(rgb >> 16));
            texels.push_back(std::uint8_t(rgb >> 8));
            texels.push_back(std::uint8_t(rgb));
            texels.push_back(255);
        }
        m_texture.upload<std::uint8_t>(texels);
        m_current = map;
    }
    m_texture.bindUnit(colourUnit);
    program.set("coloured", map != ColourMap::Grey);
}

} // namespace gpu
