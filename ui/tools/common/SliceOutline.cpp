// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/common/SliceOutline.h"

#include "ui/tools/common/EllipseCorners.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr double shortestStepPixels = 1.5;
constexpr double leastBoxPixels = 4.0;
constexpr double cornerPixels = 8.0; ///< a click this near to a corner is on it
constexpr std::size_t mostPoints = 6000; ///< an edit takes no more than 10000
constexpr double samePlaneMm = 0.01;

double distancePixels(const QPointF& one, const QPointF& other)
{
    return std::hypot(one.x() - other.x(), one.y() - other.y());
}

} // namespace

void SliceOutline::begin(Shape shape, const QPointF& at, const ViewContext& view)
{
    m_shape = shape;
    lieIn(view);
    m_points = {inPlane(at, view)};
    if (shape == Shape::Rectangle || shape == Shape::Ellipse)
        m_points.push_back(m_points.front());
}

void SliceOutline::lay(
    Shape shape, const std::vector<glm::dvec3>& cornersLps, const ViewContext& view)
{
    m_shape = shape;
    lieIn(view);
    setCorners(cornersLps);
}

void SliceOutline::setCorners(const std::vector<glm::dvec3>& cornersLps)
{
    m_points.clear();
    m_points.reserve(cornersLps.size());
    for (const glm::dvec3& corner : cornersLps)
        m_points.push_back(inPlane(corner));
}

void SliceOutline::lieIn(const ViewContext& view)
{
    const auto& scene = std::get<gpu::SliceScene>(view.scene);
    m_originLps = scene.centreLps;
    m_rightLps = scene.rightLps;
    m_upLps = -scene.downLps;
}

bool SliceOutline::liesIn(const ViewContext& view) const
{
    const auto* scene = std::get_if<gpu::SliceScene>(&view.scene);
    if (!scene)
        return false;
    const glm::dvec3 normal = glm::normalize(glm::cross(m_rightLps, m_upLps));
    const auto isAlong = [&normal](const glm::dvec3& direction) {
        return std::abs(glm::dot(normal, glm::normalize(direction))) < 1e-5;
    };
    return isAlong(scene->rightLps) && isAlong(scene->downLps)
        && std::abs(glm::dot(normal, scene->centreLps - m_originLps)) < samePlaneMm;
}

void SliceOutline::extend(const QPointF& at, const ViewContext& view)
{
    if (m_shape != Shape::Lasso) {
        m_points.back() = inPlane(at, view);
        return;
    }
    if (distancePixels(at, toPixel(m_points.back(), view)) < shortestStepPixels)
        return;
    if (m_points.size() >= mostPoints) {
        // Whoever draws on and on gets a coarser curve.
        std::size_t kept = 0;
        for (std::size_t i = 0; i < m_points.size(); i += 2)
            m_points[kept++] = m_points[i];
        m_points.resize(kept);
    }
    m_points.push_back(inPlane(at, view));
}

void SliceOutline::addCorner(const QPointF& at, const ViewContext& view)
{
    if (m_points.size() < mostPoints)
        m_points.push_back(inPlane(at, view));
}

bool SliceOutline::endsAt(const QPointF& at, const ViewContext& view) const
{
    const auto isAt = [&](const glm::dvec2& corner) {
        return distancePixels(at, toPixel(corner, view)) <= cornerPixels;
    };
    return isAt(m_points.front()) || isAt(m_points.back());
}

std::vector<glm::dvec2> SliceOutline::polygonMm() const
{
    if (m_points.empty() || (m_shape != Shape::Rectangle && m_shape != Shape::Ellipse))
        return m_points;
    const glm::dvec2 low = glm::min(m_points.front(), m_points.back());
    const glm::dvec2 high = glm::max(m_points.front(), m_points.back());
    if (m_shape == Shape::Rectangle)
        return {low, glm::dvec2(high.x, low.y), high, glm::dvec2(low.x, high.y)};
    return ellipseCorners((low + high) / 2.0, (high - low) / 2.0);
}

bool SliceOutline::isMeant(const ViewContext& view) const
{
    // A polygon is clicked together on purpose, and what was found in the picture was seen.
    if (m_shape != Shape::Lasso && m_shape != Shape::Rectangle && m_shape != Shape::Ellipse)
        return m_points.size() >= 3;
    const QRectF box = pixels(view).boundingRect();
    return (m_shape != Shape::Lasso || m_points.size() >= 3) && box.width() >= leastBoxPixels
        && box.height() >= leastBoxPixels;
}

QPolygonF SliceOutline::pixels(const ViewContext& view) const
{
    QPolygonF polygon;
    for (const glm::dvec2& place : polygonMm())
        polygon << toPixel(place, view);
    return polygon;
}

QPointF SliceOutline::firstPixel(const ViewContext& view) const
{
    return toPixel(m_points.front(), view);
}

glm::dvec2 SliceOutline::inPlane(const glm::dvec3& placeLps) const
{
    const glm::dvec3 from = placeLps - m_originLps;
    return {glm::dot(from, m_rightLps), glm::dot(from, m_upLps)};
}

glm::dvec2 SliceOutline::inPlane(const QPointF& at, const ViewContext& view) const
{
    return inPlane(view.toLps(at));
}

QPointF SliceOutline::toPixel(const glm::dvec2& place, const ViewContext& view) const
{
    return view.toPixel(m_originLps + m_rightLps * place.x + m_upLps * place.y);
}

} // namespace ui
