// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/parts/Palette.h"

#include <algorithm>
#include <vector>

namespace gpu {

namespace {

/// Of a segment that is shown: never 0.
std::uint8_t alphaOf(std::uint8_t transparencyPercent)
{
    const int opacity = 100 - std::min<int>(transparencyPercent, 100);
    return std::uint8_t(std::max((opacity * 255 + 50) / 100, 1));
}

} // namespace

Palette::Palette()
    : m_texture({.label = "segment palette", .size = {256, 1}, .format = GL_RGBA8})
{
    m_texture.clear();
}

void Palette::set(const SegmentDisplay& segments)
{
    const bool same = segments.rgb == m_current.rgb && segments.visible == m_current.visible
        && segments.transparencyPercent == m_current.transparencyPercent
        && segments.warningRgb == m_current.warningRgb;
    m_current = segments;
    if (same)
        return;
    m_translucent = false;
    std::vector<std::uint8_t> texels;
    for (std::size_t label = 0; label < segments.rgb.size(); ++label) {
        const std::uint32_t rgb = label > 0 ? segments.rgb[label] : segments.warningRgb;
        texels.push_back(std::uint8_t(rgb >> 16));
        texels.push_back(std::uint8_t(rgb >> 8));
        texels.push_back(std::uint8_t(rgb));
        const std::uint8_t opacity =
            label > 0 && segments.visible[label] ? alphaOf(segments.transparencyPercent[label]) : 0;
        texels.push_back(opacity);
        m_translucent = m_translucent || (opacity > 0 && opacity < 255);
    }
    m_texture.upload<std::uint8_t>(texels);
}

} // namespace gpu
