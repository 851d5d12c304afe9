// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/parts/TransferLookup.h"

#include "gpu/scene/WindowMapping.h"

#include <algorithm>
#include <cmath>

namespace gpu {

namespace {

constexpr int entries = TransferLookup::entryCount;

double lowestOf(const TransferFunction& function)
{
    return function.points.front().value;
}

double highestOf(const TransferFunction& function)
{
    return std::max(function.points.back().value, lowestOf(function) + 1e-6);
}

glm::dvec2 entryOf(double lowest, double highest, const core::VoxelEncoding& encoding)
{
    const glm::dvec2 value = valueOfTexel(encoding);
    const double perValue = (entries - 1.0) / (highest - lowest);
    return {value.x * perValue, (value.y - lowest) * perValue + 0.5};
}

glm::dvec3 colourOfRgb(std::uint32_t rgb)
{
    return glm::dvec3(rgb >> 16 & 255u, rgb >> 8 & 255u, rgb & 255u) / 255.0;
}

glm::dvec4 sample(const std::vector<TransferFunction::Point>& points, double value)
{
    const auto above = std::find_if(points.begin(), points.end(),
        [value](const TransferFunction::Point& point) { return point.value > value; });
    if (above == points.begin())
        return {colourOfRgb(above->rgb), above->opacity};
    const auto below = above - 1;
    if (above == points.end())
        return {colourOfRgb(below->rgb), below->opacity};
    const double part = (value - below->value) / (above->value - below->value);
    return glm::mix(glm::dvec4(colourOfRgb(below->rgb), below->opacity),
        glm::dvec4(colourOfRgb(above->rgb), above->opacity), part);
}

} // namespace

TransferLookup::TransferLookup()
    : m_texture({.label = "transfer function", .size = {entries, 1}, .format = GL_RGBA32F})
{
    m_texture.clear();
}

void TransferLookup::set(const TransferFunction& function, double stepMm)
{
    if (function == m_function && stepMm == m_stepMm)
        return;
    m_function = function;
    m_stepMm = stepMm;
    if (!function.points.empty()) {
        m_lowest = lowestOf(function);
        m_highest = highestOf(function);
    }
    m_texture.upload<float>(texelsOf(function, stepMm));
}

std::vector<float> TransferLookup::texelsOf(const TransferFunction& function, double stepMm)
{
    std::vector<float> texels(entries * 4, 0.0f);
    if (!function.points.empty()) {
        const double lowest = lowestOf(function);
        const double highest = highestOf(function);
        for (int i = 0; i < entries; ++i) {
            const double value = lowest + (highest - lowest) * i / (entries - 1);
            const glm::dvec4 at = sample(function.points, value);
            const double opacity = std::clamp(at.w, 0.0, 1.0);
            float* texel = &texels[std::size_t(i) * 4];
            texel[0] = float(at.x);
            texel[1] = float(at.y);
            texel[2] = float(at.z);
            texel[3] = float(1.0 - std::pow(1.0 - opacity, stepMm));
        }
    }
    return texels;
}

glm::dvec2 TransferLookup::entryOfTexel(const core::VoxelEncoding& encoding) const
{
    return entryOf(m_lowest, m_highest, encoding);
}

glm::dvec2 TransferLookup::entryOfTexel(
    const TransferFunction& function, const core::VoxelEncoding& encoding)
{
    return entryOf(lowestOf(function), highestOf(function), encoding);
}

VisibleCodes TransferLookup::visibleCodes(
    const TransferFunction& function, const core::VoxelEncoding& encoding)
{
    VisibleCodes visible;
    const auto& points = function.points;
    const auto add = [&visible](int lowest, int highest) {
        lowest = std::max(lowest, 0);
        highest = std::min(highest, core::VoxelEncoding::codeCount - 1);
        if (!visible.intervals.empty() && lowest <= visible.intervals.back().highest + 1)
            visible.intervals.back().highest = std::max(visible.intervals.back().highest, highest);
        else if (lowest <= highest)
            visible.intervals.push_back({lowest, highest});
    };
    if (points.empty())
        return visible;
    if (points.front().opacity > 0.0)
        add(0, encoding.highestCodeAtMost(points.front().value) + 1);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        if (points[i].opacity > 0.0 || points[i + 1].opacity > 0.0) {
            add(encoding.lowestCodeAtLeast(points[i].value) - 1,
                encoding.highestCodeAtMost(points[i + 1].value) + 1);
        }
    }
    if (points.back().opacity > 0.0) {
        add(encoding.lowestCodeAtLeast(points.back().value) - 1,
            core::VoxelEncoding::codeCount - 1);
    }
    return visible;
}

} // namespace gpu
