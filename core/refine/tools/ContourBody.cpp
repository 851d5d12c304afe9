// SPDX-License-Identifier: Apache-2.0
#include "core/refine/tools/ContourBody.h"

#include "core/base/Progress.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// More points would take long to solve and add little.
constexpr std::size_t mostDrawnPoints = 260;
/// Steps of a contour between two of its points, for evening it out.
constexpr int stepsBetween = 6;
constexpr std::size_t mostSteps = 100'000;
/// How far the body may deviate from a contour, in units of the cube of the distance between the
/// contour's points: details shorter than about that distance are taken for unsteadiness of the
/// hand.
constexpr double handGive = 1.5;
/// A closed contour with less area than this share of its squared length runs to and fro; its area
/// comes from rounding or an unsteady hand. A circle has 0.08.
constexpr double leastArea = 1e-3;

glm::dvec3 unitOf(const glm::dvec3& way)
{
    const double length = glm::length(way);
    return length > 0.0 ? way / length : glm::dvec3(0.0);
}

/// A point of a contour that is evened out.
struct DrawnPoint {
    glm::dvec3 place{0.0};
    glm::dvec3 outwards{0.0};
};

/// Along a contour, evenly.
std::vector<glm::dvec3> steppedAlong(const TemplateContour& contour, double stepMm)
{
    std::vector<glm::dvec3> line = contour.pointsLps;
    if (contour.isClosed && !line.empty())
        line.push_back(line.front());
    std::vector<glm::dvec3> steps;
    double sinceMm = stepMm; // the last step
    for (std::size_t i = 1; i < line.size() && steps.size() < mostSteps; ++i) {
        const double wayMm = glm::distance(line[i - 1], line[i]);
        if (!(wayMm > 0.0))
            continue;
        double atMm = std::max(0.0, stepMm - sinceMm);
        for (; atMm < wayMm && steps.size() < mostSteps; atMm += stepMm)
            steps.push_back(line[i - 1] + atMm / wayMm * (line[i] - line[i - 1]));
        sinceMm = wayMm - (atMm - stepMm);
    }
    if (!contour.isClosed && !line.empty())
        steps.push_back(line.back());
    return steps;
}

double lengthMmOf(const std::vector<glm::dvec3>& line, bool isClosed)
{
    double sum = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i)
        sum += glm::distance(line[i - 1], line[i]);
    return isClosed && !line.empty() ? sum + glm::distance(line.back(), line.front()) : sum;
}

/// Each the mean of those around it, the nearer the more; ends stay where they are.
std::vector<glm::dvec3> evened(const std::vector<glm::dvec3>& steps, bool isClosed)
{
    const int count = int(steps.size());
    std::vector<glm::dvec3> even;
    even.reserve(steps.size());
    for (int i = 0; i < count; ++i) {
        const int reach = isClosed ? std::min(stepsBetween, (count - 1) / 2)
                                   : std::min({stepsBetween, i, count - 1 - i});
        glm::dvec3 sum(0.0);
        double weights = 0.0;
        for (int off = -reach; off <= reach; ++off) {
            const double weight = double(reach + 1 - std::abs(off));
            sum += weight * steps[std::size_t((i + off + count) % count)];
            weights += weight;
        }
        even.push_back(sum / weights);
    }
    return even;
}

/// Across the plane of a contour; 0 if it runs straight, or to and fro.
glm::dvec3 acrossOf(const std::vector<glm::dvec3>& steps, bool isClosed)
{
    if (isClosed) {
        glm::dvec3 area(0.0);
        for (std::size_t i = 0; i < steps.size(); ++i)
            area += glm::cross(steps[i] - steps[0], steps[(i + 1) % steps.size()] - steps[0]);
        const double lengthMm = lengthMmOf(steps, true);
        return 0.5 * glm::length(area) < leastArea * lengthMm * lengthMm ? glm::dvec3(0.0)
                                                                         : unitOf(area);
    }
    const auto farthest = std::max_element(
        steps.begin(), steps.end(), [&](const glm::dvec3& one, const glm::dvec3& other) {
            return glm::distance(one, steps[0]) < glm::distance(other, steps[0]);
        });
    const glm::dvec3 along = *farthest - steps[0];
    glm::dvec3 most(0.0);
    for (const glm::dvec3& step : steps) {
        const glm::dvec3 area = glm::cross(along, step - steps[0]);
        if (glm::dot(area, area) > glm::dot(most, most))
            most = area;
    }
    const double straight = 1e-6 * glm::dot(along, along);
    return glm::length(most) > straight ? unitOf(most) : glm::dvec3(0.0);
}

/// Computes a body, step by step.
class ContourBodyMaker {
public:
    ContourBodyMaker(const ContourBodyPoints& given, const Progress* progress)
        : m_given(given)
        , m_progress(progress)
    {
    }

    Result<ContourBody> make()
    {
        for (const BorderPlace& place : m_given.border)
            m_out += place.outwardsLps;
        m_out = unitOf(m_out);
        double wholeMm = 0.0;
        for (const TemplateContour& contour : m_given.contours)
            wholeMm += lengthMmOf(contour.pointsLps, contour.isClosed);
        m_spacingMm = std::max(m_given.edgeMm, wholeMm / double(mostDrawnPoints));
        for (const TemplateContour& contour : m_given.contours)
            draw(contour);
        if (m_drawn.empty())
            return failure(ErrorCode::InvalidField, QStringLiteral("contours"),
                Clause::saying("they have no length"));
        leaveOutSound();
        thin();
        Result<VariationalBody> first = solve();
        if (!first)
            return tl::unexpected(first.error());
        // The gradient of the first body gives the outward directions where a contour's plane is
        // not perpendicular to the surface.
        for (DrawnPoint& point : m_drawn) {
            const glm::dvec3 out = -unitOf(first->at(point.place).rise);
            if (glm::dot(out, point.outwards) > 0.3)
                point.outwards = out;
        }
        Result<VariationalBody> body = solve();
        if (!body)
            return tl::unexpected(body.error());
        return ContourBody{.body = *std::move(body), .pointsLps = m_points};
    }

private:
    void draw(const TemplateContour& contour)
    {
        const std::vector<glm::dvec3> steps =
            steppedAlong(contour, m_spacingMm / double(stepsBetween));
        if (steps.size() < 2)
            return;
        const bool isClosed = contour.isClosed;
        const std::vector<glm::dvec3> even = evened(steps, isClosed);
        const glm::dvec3 across = acrossOf(steps, isClosed);
        const int count = int(even.size());
        const auto stepAt = [&](int i) {
            return even[std::size_t(isClosed ? (i + count) % count : std::clamp(i, 0, count - 1))];
        };
        std::vector<DrawnPoint> points;
        for (int i = 0; i < count; i += stepsBetween) {
            const int reach = std::min(stepsBetween, std::max(1, count / 3));
            const glm::dvec3 along = stepAt(i + reach) - stepAt(i - reach);
            // Across a straight line no plane is known: out is where it is for the border.
            const glm::dvec3 outwards = across == glm::dvec3(0.0)
                ? glm::cross(along, glm::cross(m_out, along))
                : glm::cross(along, across);
            if (glm::dot(outwards, outwards) > 0.0)
                points.push_back({.place = even[std::size_t(i)], .outwards = unitOf(outwards)});
        }
        if (!isClosed && across != glm::dvec3(0.0) && looksIn(points)) {
            for (DrawnPoint& point : points)
                point.outwards = -point.outwards;
        }
        m_drawn.insert(m_drawn.end(), points.begin(), points.end());
    }

    /// Near the border a contour goes on as the sound surface does.
    [[nodiscard]] bool looksIn(const std::vector<DrawnPoint>& points) const
    {
        double vote = 0.0;
        for (const DrawnPoint& point : points) {
            for (const BorderPlace& place : m_given.border) {
                const glm::dvec3 way = place.placeLps - point.place;
                const double squared = glm::dot(way, way) + m_spacingMm * m_spacingMm;
                vote += glm::dot(point.outwards, place.outwardsLps) / (squared * squared);
            }
        }
        return vote < 0.0;
    }

    void leaveOutSound()
    {
        std::vector<DrawnPoint> kept;
        for (const DrawnPoint& point : m_drawn) {
            if (isCancelled())
                return;
            if (!m_given.isSound || !m_given.isSound(point.place))
                kept.push_back(point);
        }
        if (!kept.empty())
            m_drawn = std::move(kept);
    }

    /// Each contour has a point at least, however many there are.
    void thin()
    {
        const std::size_t count = m_drawn.size();
        if (count <= mostDrawnPoints)
            return;
        for (std::size_t i = 0; i < mostDrawnPoints; ++i)
            m_drawn[i] = m_drawn[i * count / mostDrawnPoints];
        m_drawn.resize(mostDrawnPoints);
    }

    [[nodiscard]] bool isCancelled() const { return m_progress && m_progress->cancelled(); }

    Result<VariationalBody> solve()
    {
        if (isCancelled())
            return failure(ErrorCode::Cancelled);
        std::vector<VariationalBody::Point> points;
        m_points.clear();
        const double beyondMm = m_given.edgeMm;
        const double nearMm = 0.4 * m_given.edgeMm;
        const auto isNew = [&](const glm::dvec3& place) {
            return std::all_of(points.begin(), points.end(), [&](const auto& other) {
                const glm::dvec3 way = other.place - place;
                return glm::dot(way, way) >= nearMm * nearMm;
            });
        };
        const auto take = [&](const glm::dvec3& place, const glm::dvec3& outwards, double give) {
            const glm::dvec3 beyond = place + beyondMm * outwards;
            if (outwards == glm::dvec3(0.0) || !isNew(place) || !isNew(beyond))
                return;
            points.push_back({.place = place, .value = 0.0, .giveMm3 = give});
            points.push_back({.place = beyond, .value = -beyondMm, .giveMm3 = give});
            m_points.push_back(place);
        };
        // Points of the border, which are exact, come first, so that they are not left out beside
        // inexact ones.
        std::vector<glm::dvec3> border;
        for (const BorderPlace& place : m_given.border)
            take(place.placeLps, place.outwardsLps, 0.0);
        border.swap(m_points);
        const double give = handGive * m_spacingMm * m_spacingMm * m_spacingMm;
        for (const DrawnPoint& point : m_drawn)
            take(point.place, point.outwards, give);
        m_points.insert(m_points.end(), border.begin(), border.end());
        return VariationalBody::through(points);
    }

    const ContourBodyPoints& m_given;
    const Progress* m_progress;
    double m_spacingMm = 1.0; ///< of the contours' points
    glm::dvec3 m_out{0.0}; ///< the border's mean
    std::vector<DrawnPoint> m_drawn;
    std::vector<glm::dvec3> m_points;
};

} // namespace

Result<ContourBody> contourBody(const ContourBodyPoints& given, const Progress* progress)
{
    return ContourBodyMaker(given, progress).make();
}

} // namespace core
