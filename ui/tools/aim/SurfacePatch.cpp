// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/aim/SurfacePatch.h"

#include "core/edits/engine/PickRays.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ui {

SurfacePatch::SurfacePatch(
    const core::OrthographicView& view, const std::vector<glm::dvec2>& outlineMm, int across)
    : m_view(view)
{
    m_axes[2] = glm::normalize(view.targetLps - view.eyeLps);
    m_axes[0] = glm::normalize(glm::cross(m_axes[2], view.up));
    m_axes[1] = glm::cross(m_axes[0], m_axes[2]);
    QPolygonF outline;
    for (const glm::dvec2& point : outlineMm)
        outline << QPointF(point.x, point.y);
    const QRectF box = outline.boundingRect();
    m_stepMm = std::max(std::max(box.width(), box.height()) / across, 1e-3);
    m_middleMm = {box.center().x(), box.center().y()};
    // The middle is one of the rays.
    const glm::ivec2 half(int(box.width() / 2.0 / m_stepMm), int(box.height() / 2.0 / m_stepMm));
    m_size = 2 * half + 1;
    m_firstMm = m_middleMm - glm::dvec2(half) * m_stepMm;
    m_depths.resize(std::size_t(m_size.x) * std::size_t(m_size.y));
    for (int y = 0; y < m_size.y; ++y) {
        for (int x = 0; x < m_size.x; ++x) {
            const glm::dvec2 at = planeMm({x, y});
            if (outline.containsPoint(QPointF(at.x, at.y), Qt::WindingFill))
                m_rays.emplace_back(x, y);
        }
    }
}

glm::dvec2 SurfacePatch::planeMm(const glm::ivec2& at) const
{
    return m_firstMm + glm::dvec2(at) * m_stepMm;
}

std::size_t SurfacePatch::place(const glm::ivec2& at) const
{
    return std::size_t(at.x) + std::size_t(m_size.x) * std::size_t(at.y);
}

glm::dvec3 SurfacePatch::lps(const glm::ivec2& at) const
{
    const glm::dvec2 mm = planeMm(at);
    return m_view.targetLps + m_axes * glm::dvec3(mm, m_depths[place(at)].value_or(0.0));
}

core::PickQuestion SurfacePatch::question(
    const core::Volume& volume, double threshold, const core::ClipRegion& clip) const
{
    std::vector<glm::dvec2> points;
    points.reserve(m_rays.size());
    for (const glm::ivec2& ray : m_rays)
        points.push_back(planeMm(ray));
    core::PickQuestion question;
    question.rays = core::pickRays(m_view, points, volume.geometry, clip).rays;
    question.seenBy = core::SeenBy::Surface;
    question.thresholdCode = volume.encoding.lowestCodeAtLeast(threshold);
    return question;
}

void SurfacePatch::take(const core::Volume& volume, const PickedVoxels& picked)
{
    for (std::size_t i = 0; i < m_rays.size() && i < picked.size(); ++i) {
        Depth& depth = m_depths[place(m_rays[i])];
        depth.reset();
        if (picked[i])
            depth = glm::dot(
                volume.geometry.toWorld(glm::dvec3(*picked[i])) - m_view.targetLps, m_axes[2]);
    }
}

void SurfacePatch::dropBehind(double mm)
{
    std::vector<double> known;
    for (const Depth& depth : m_depths) {
        if (depth)
            known.push_back(*depth);
    }
    if (known.empty())
        return;
    const auto median = known.begin() + (std::ssize(known) - 1) / 2;
    std::nth_element(known.begin(), median, known.end());
    for (Depth& depth : m_depths) {
        if (depth && *depth > *median + mm)
            depth.reset();
    }
}

void SurfacePatch::keepLargest(double jumpMm)
{
    std::vector<int> part(m_depths.size(), 0);
    std::vector<std::size_t> sizes{0};
    for (const glm::ivec2& start : m_rays) {
        if (!m_depths[place(start)] || part[place(start)] != 0)
            continue;
        const int number = int(sizes.size());
        sizes.push_back(0);
        std::vector<glm::ivec2> front{start};
        part[place(start)] = number;
        while (!front.empty()) {
            const glm::ivec2 at = front.back();
            front.pop_back();
            ++sizes.back();
            for (const glm::ivec2& step :
                {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
                const glm::ivec2 next = at + step;
                if (next.x < 0 || next.y < 0 || next.x >= m_size.x || next.y >= m_size.y)
                    continue;
                const Depth& depth = m_depths[place(next)];
                if (!depth || part[place(next)] != 0
                    || std::abs(*depth - *m_depths[place(at)]) > jumpMm)
                    continue;
                part[place(next)] = number;
                front.push_back(next);
            }
        }
    }
    const int largest = int(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
    for (std::size_t i = 0; i < m_depths.size(); ++i) {
        if (part[i] != largest)
            m_depths[i].reset();
    }
}

std::optional<glm::ivec2> SurfacePatch::middle() const
{
    const glm::ivec2 at = m_size / 2;
    return m_depths[place(at)] ? std::optional(at) : std::nullopt;
}

std::optional<glm::dvec3> SurfacePatch::middleLps() const
{
    const std::optional<glm::ivec2> at = middle();
    return at ? std::optional(lps(*at)) : std::nullopt;
}

glm::dvec3 SurfacePatch::normalLps() const
{
    // Least squares of depth = a·x + b·y + c, over what belongs to the same surface.
    const Depth around = m_depths[place(m_size / 2)];
    const double reachMm = m_stepMm * std::max(m_size.x, m_size.y);
    glm::dmat3 sums(0.0);
    glm::dvec3 right(0.0);
    for (const glm::ivec2& ray : m_rays) {
        const Depth& depth = m_depths[place(ray)];
        if (!depth || (around && std::abs(*depth - *around) > reachMm))
            continue;
        const glm::dvec3 row(planeMm(ray) - m_middleMm, 1.0);
        sums += glm::outerProduct(row, row);
        right += row * *depth;
    }
    if (std::abs(glm::determinant(sums)) < 1e-9)
        return m_axes[2];
    const glm::dvec3 plane = glm::inverse(sums) * right;
    return glm::normalize(m_axes * glm::dvec3(-plane.x, -plane.y, 1.0));
}

std::vector<QPolygonF> SurfacePatch::squares(const ViewContext& view) const
{
    std::vector<QPolygonF> result;
    for (const glm::ivec2& ray : m_rays) {
        if (!m_depths[place(ray)])
            continue;
        const QPointF at = view.toPixel(lps(ray));
        const double half = 0.5 * m_stepMm / view.mmPerPixel();
        result.push_back(QPolygonF(QRectF(at - QPointF(half, half), at + QPointF(half, half))));
    }
    return result;
}

} // namespace ui
