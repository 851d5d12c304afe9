// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/parts/Palette.h"

#include <vector>

namespace gpu {

Palette::Palette()
    : m_texture({.label = "segment palette", .size = {256, 1}, .format = GL_RGBA8})
{
    m_texture.clear();
}

void Palette::set(const SegmentDisplay& segments)
{
    const bool same = segments.rgb == m_current.rgb && segments.visible == m_current.visible
        && segments.warningRgb == m_current.warningRgb;
    m_current = segments;
    if (same)
        return;
    std::vector<std::uint8_t> texels;
    for (std::size_t label = 0; label < segments.rgb.size(); ++label) {
        const std::uint32_t rgb = label > 0 ? segments.rgb[label] : segments.warningRgb;
        texels.push_back(std::uint8_t(rgb >> 16));
        texels.push_back(std::uint8_t(rgb >> 8));
        texels.push_back(std::uint8_t(rgb));
        texels.push_back(label > 0 && segments.visible[label] ? 255 : 0);
    }
    m_texture.upload<std::uint8_t>(texels);
}

} // namespace gpu
