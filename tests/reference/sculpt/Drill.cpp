// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/sculpt/Drill.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace reference {

Drill::Drill(const DenseArray<std::uint16_t>& codes, DenseArray<std::uint8_t> radiation,
    DenseFields& fields, core::DrillCut cut)
    : m_cut(std::move(cut))
    , m_plane(codes, std::move(radiation), fields, m_cut.layer, m_cut.frame)
{
}

std::int64_t Drill::weightUnder(
    const core::DrillSample& sample, std::int64_t a, std::int64_t b) const
{
    const std::int64_t pitch = m_cut.frame.pitch;
    if (!m_cut.mask.values.empty()) {
        const std::int64_t x = a - floorDivide(sample.x, pitch) - m_cut.mask.first.x;
        const std::int64_t y = b - floorDivide(sample.y, pitch) - m_cut.mask.first.y;
        const bool inside = x >= 0 && y >= 0 && x < m_cut.mask.size.x && y < m_cut.mask.size.y;
        return inside ? m_cut.mask.values[std::size_t(y * m_cut.mask.size.x + x)] : 0;
    }
    const std::int64_t dx = a * pitch + pitch / 2 - sample.x;
    const std::int64_t dy = b * pitch + pitch / 2 - sample.y;
    const std::int64_t distance = squareRoot(dx * dx + dy * dy);
    return std::clamp<std::int64_t>(
        floorDivide((m_cut.maskRadius - distance) * 256 + 128 * pitch, pitch), 0, 256);
}

void Drill::extend(const std::vector<core::DrillSample>& samples)
{
    const core::CutFrame& frame = m_cut.frame;
    const std::int64_t pitch = frame.pitch;
    // A mask ends half an element beyond its radius; one more is asked for than can be reached.
    std::int64_t reach = m_cut.maskRadius / pitch + 2;
    for (const int side : {m_cut.mask.first.x, m_cut.mask.first.y,
             m_cut.mask.first.x + m_cut.mask.size.x, m_cut.mask.first.y + m_cut.mask.size.y})
        reach = std::max<std::int64_t>(reach, std::abs(side) + 1);
    for (const core::DrillSample& sample : samples) {
        if (sample.depth <= 0)
            continue;
        std::vector<std::pair<Element*, std::int64_t>> under; // with weights
        std::vector<std::int64_t> surfaces;
        const std::int64_t middleA = floorDivide(sample.x, pitch);
        const std::int64_t middleB = floorDivide(sample.y, pitch);
        for (std::int64_t b = middleB - reach; b <= middleB + reach; ++b) {
            for (std::int64_t a = middleA - reach; a <= middleA + reach; ++a) {
                const std::int64_t weight = weightUnder(sample, a, b);
                if (weight <= 0)
                    continue;
                const auto [element, isNew] = m_elements.try_emplace({a, b});
                if (isNew)
                    element->second.hit = m_plane.cast(a, b);
                if (!element->second.hit)
                    continue;
                under.emplace_back(&element->second, weight);
                surfaces.push_back(element->second.hit->zSurface);
            }
        }
        std::sort(surfaces.begin(), surfaces.end());
        for (const auto& [element, weight] : under) {
            if (m_cut.guard >= 0
                && element->hit->zSurface > surfaces[(surfaces.size() - 1) / 2] + m_cut.guard)
                continue;
            if (m_cut.mode == core::DrillMode::Limit) {
                element->depth = std::max(element->depth, (sample.depth * weight) >> 8);
            } else {
                element->sum += sample.depth * weight;
                element->depth = std::min<std::int64_t>(frame.maxDepth, element->sum >> 16);
            }
        }
    }

    std::map<ElementPlane::Place, ElementPlane::Column> columns;
    for (const auto& [place, element] : m_elements) {
        if (!element.hit || element.depth <= 0)
            continue;
        const ElementPlane::Hit& hit = *element.hit;
        columns[place] = frame.restore ? m_plane.restoring(hit, hit.zSurface - element.depth, 255)
                                       : ElementPlane::Column{hit.zSurface - frame.front,
                                           std::min(hit.zSurface + element.depth, hit.zExit)};
    }
    m_plane.lay(columns, m_cut.laying);
}

} // namespace reference
