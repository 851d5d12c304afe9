// SPDX-License-Identifier: Apache-2.0
#include "core/refine/tools/TemplateShape.h"

#include "core/base/Progress.h"
#include "core/refine/mesh/InternalForces.h"
#include "core/refine/repair/FaceShape.h"
#include "core/refine/tools/ContourBody.h"
#include "core/refine/tools/MarkPaint.h"
#include "core/refine/tools/ToolBehaviour.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace core {

namespace {

/// More would take longer to solve than they say.
constexpr double mostContourPoints = 150.0;
constexpr double mostBorderPoints = 150.0;
/// Nobody draws more; with TemplateForm::OfBefore nobody was asked.
constexpr std::size_t mostContours = 500;
/// Of the relaxation that lays the region over the plane.
constexpr int mostSweeps = 600;
constexpr double overRelaxation = 1.9;
constexpr int previewSteps = 30;
/// How far a body may reach beyond what was drawn, of its extent.
constexpr double beyondDrawn = 0.1;

tl::unexpected<Error> refused(const Clause& why)
{
    return failure(ErrorCode::InvalidField, QStringLiteral("contours"), why);
}

double squaredOf(const glm::dvec3& way)
{
    return glm::dot(way, way);
}

/// Along a contour: its points but for those that lie too near to the last, and others between
/// those that lie far apart.
std::vector<glm::dvec3> spaced(const TemplateContour& contour, double leastMm)
{
    std::vector<glm::dvec3> line = contour.pointsLps;
    if (contour.isClosed && !line.empty())
        line.push_back(line.front());
    std::vector<glm::dvec3> points;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (points.empty()) {
            points.push_back(line[i]);
            continue;
        }
        const glm::dvec3 from = points.back();
        const double wayMm = glm::distance(from, line[i]);
        const bool isEnd = i + 1 == line.size();
        if (wayMm < leastMm) {
            // The end counts more than what lies just before it.
            if (isEnd && !contour.isClosed && points.size() > 1)
                points.back() = line[i];
            continue;
        }
        const int parts = std::max(1, int(wayMm / (2.0 * leastMm)));
        for (int part = 1; part <= parts; ++part)
            points.push_back(from + double(part) / double(parts) * (line[i] - from));
    }
    if (contour.isClosed && points.size() > 1
        && squaredOf(points.back() - points.front()) < leastMm * leastMm)
        points.pop_back();
    return points;
}

double lengthMm(const TemplateContour& contour)
{
    double sum = 0.0;
    for (std::size_t i = 1; i < contour.pointsLps.size(); ++i)
        sum += glm::distance(contour.pointsLps[i - 1], contour.pointsLps[i]);
    return sum;
}

} // namespace

/// Makes one, step by step.
class TemplateMaker {
public:
    TemplateMaker(const SimplexMesh& mesh, double edgeMm, const Progress* progress)
        : m_mesh(mesh)
        , m_edgeMm(edgeMm)
        , m_progress(progress)
        , m_isRegion(mesh.vertexSlots(), false)
    {
    }

    Result<TemplateShape> make(const std::vector<TemplateContour>& contours, TemplateForm form)
    {
        m_shape.m_form = form;
        if (form == TemplateForm::Body && contours.size() > mostContours)
            return refused(Clause::saying("there are more than 500 contours"));
        double wholeMm = 0.0;
        bool isBody = false;
        for (const TemplateContour& contour : contours) {
            wholeMm += lengthMm(contour);
            isBody = isBody || contour.isClosed;
        }
        const double leastMm = std::max(m_edgeMm, wholeMm / mostContourPoints);
        for (const TemplateContour& contour : contours) {
            m_contours.push_back(spaced(contour, leastMm));
            m_isClosed.push_back(contour.isClosed);
        }
        if (!findRegion())
            return isCancelled() ? failure(ErrorCode::Cancelled)
                                 : refused(Clause::saying("no contour lies near a red region"));
        findBorder();
        const bool made = form == TemplateForm::Body ? makeContourBody(contours)
            : isBody                                 ? makeBody()
                                                     : makeSpline();
        if (!made)
            return isCancelled() ? failure(ErrorCode::Cancelled) : refused(m_why);
        return std::move(m_shape);
    }

private:
    /// The red region to which most points of the contours are nearest.
    bool findRegion()
    {
        std::vector<VertexId> regionOf(m_mesh.vertexSlots(), noId); // by its least vertex
        std::map<VertexId, int> votes;
        for (const auto& contour : m_contours) {
            for (const glm::dvec3& point : contour) {
                if (isCancelled())
                    return false;
                const VertexId nearest = nearestVertex(m_mesh, point,
                    [&](VertexId id) { return m_mesh.mark(id) == SurfaceMark::Red; });
                if (nearest == noId)
                    return false;
                if (regionOf[nearest] == noId) {
                    const auto all = markedAround(m_mesh, nearest);
                    for (const VertexId id : all)
                        regionOf[id] = all.front();
                }
                ++votes[regionOf[nearest]];
            }
        }
        if (votes.empty())
            return false;
        const auto chosen = std::max_element(votes.begin(), votes.end(),
            [](const auto& a, const auto& b) { return a.second < b.second; });
        m_shape.m_region = markedAround(m_mesh, chosen->first);
        for (const VertexId id : m_shape.m_region)
            m_isRegion[id] = true;
        return true;
    }

    void findBorder()
    {
        std::vector<bool> seen(m_mesh.vertexSlots(), false);
        for (const VertexId id : m_shape.m_region) {
            for (const VertexId near : m_mesh.neighbours(id)) {
                if (m_isRegion[near] || seen[near])
                    continue;
                seen[near] = true;
                m_border.push_back(near);
            }
        }
        std::sort(m_border.begin(), m_border.end());
    }

    /// Of the border, no two nearer than this.
    [[nodiscard]] std::vector<VertexId> spacedBorder() const
    {
        const double leastMm =
            m_edgeMm * std::max(0.75, double(m_border.size()) / mostBorderPoints);
        std::vector<VertexId> chosen;
        for (const VertexId id : m_border) {
            if (std::all_of(chosen.begin(), chosen.end(), [&](VertexId other) {
                    return squaredOf(m_mesh.position(id) - m_mesh.position(other))
                        >= leastMm * leastMm;
                }))
                chosen.push_back(id);
        }
        return chosen;
    }

    bool makeSpline()
    {
        if (m_border.size() < 3)
            return because(Clause::saying("the red region has no border"));
        layPlane();
        if (m_shape.m_up == glm::dvec3(0.0))
            return because(Clause::saying("the red region opens nowhere"));
        if (!gatherPoints())
            return false;
        auto spline = ThinPlateSpline::through(m_points);
        if (!spline)
            return because(Clause::saying("no surface runs through these contours"));
        m_shape.m_spline = *std::move(spline);
        for (const glm::dvec3& point : m_points)
            m_shape.m_points.push_back(m_shape.m_origin + point.x * m_shape.m_u
                + point.y * m_shape.m_v + point.z * m_shape.m_up);
        layRegion();
        return true;
    }

    void layPlane()
    {
        // The area as a vector depends on the border alone.
        std::vector<FaceId> faces;
        for (const VertexId id : m_shape.m_region) {
            const auto& around = m_mesh.facesAt(id);
            faces.insert(faces.end(), around.begin(), around.end());
        }
        std::sort(faces.begin(), faces.end());
        faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
        glm::dvec3 area(0.0);
        for (const FaceId face : faces)
            area += areaVectorOf(m_mesh, face);
        const double size = glm::length(area);
        if (!(size > 1e-3 * m_edgeMm * m_edgeMm))
            return;
        m_shape.m_up = area / size;
        glm::dvec3 sum(0.0);
        for (const VertexId id : m_border)
            sum += m_mesh.position(id);
        m_shape.m_origin = sum / double(m_border.size());
        const glm::dvec3 slant = glm::abs(m_shape.m_up);
        const glm::dvec3 axis = slant.x <= slant.y && slant.x <= slant.z ? glm::dvec3(1, 0, 0)
            : slant.y <= slant.z                                         ? glm::dvec3(0, 1, 0)
                                                                         : glm::dvec3(0, 0, 1);
        m_shape.m_u = glm::normalize(glm::cross(axis, m_shape.m_up));
        m_shape.m_v = glm::cross(m_shape.m_up, m_shape.m_u);
    }

    [[nodiscard]] glm::dvec3 overPlane(const glm::dvec3& positionLps) const
    {
        const glm::dvec3 from = positionLps - m_shape.m_origin;
        return {
            glm::dot(from, m_shape.m_u), glm::dot(from, m_shape.m_v), glm::dot(from, m_shape.m_up)};
    }

    /// Those that lie over one place become their mean.
    bool gatherPoints()
    {
        struct Place {
            glm::dvec3 sum{0.0};
            double count = 0.0;
            double least = 0.0;
            double most = 0.0;
            [[nodiscard]] glm::dvec3 mean() const { return sum / count; }
        };
        std::vector<Place> places;
        const double nearMm = 0.5 * m_edgeMm;
        const auto placeAt = [&](const glm::dvec3& point) {
            return std::find_if(places.begin(), places.end(), [&](const Place& place) {
                const glm::dvec2 way = glm::dvec2(place.mean() - point);
                return glm::dot(way, way) < nearMm * nearMm;
            });
        };
        for (const auto& contour : m_contours) {
            for (const glm::dvec3& lps : contour) {
                const glm::dvec3 point = overPlane(lps);
                const auto place = placeAt(point);
                if (place == places.end()) {
                    places.push_back(
                        {.sum = point, .count = 1.0, .least = point.z, .most = point.z});
                    continue;
                }
                place->sum += point;
                place->count += 1.0;
                place->least = std::min(place->least, point.z);
                place->most = std::max(place->most, point.z);
            }
        }
        for (const Place& place : places) {
            if (place.most - place.least > 6.0 * m_edgeMm)
                return because(Clause::saying("contours lie above one another: draw closed ones"));
            m_points.push_back(place.mean());
        }
        for (const VertexId id : spacedBorder()) {
            const glm::dvec3 point = overPlane(m_mesh.position(id));
            if (placeAt(point) != places.end())
                continue;
            places.push_back({.sum = point, .count = 1.0});
            m_points.push_back(point);
        }
        return true;
    }

    /// The mean of the neighbours for each, by over-relaxation.
    void layRegion()
    {
        const auto& region = m_shape.m_region;
        std::vector<std::uint32_t> placeOf(m_mesh.vertexSlots(), noId);
        for (std::size_t i = 0; i < region.size(); ++i)
            placeOf[region[i]] = std::uint32_t(i);
        auto& places = m_shape.m_places;
        places.assign(region.size(), glm::dvec2(0.0));
        std::vector<glm::dvec2> fixed(m_mesh.vertexSlots(), glm::dvec2(0.0));
        for (const VertexId id : m_border)
            fixed[id] = glm::dvec2(overPlane(m_mesh.position(id)));
        const double enough = 1e-3 * m_edgeMm;
        for (int sweep = 0; sweep < mostSweeps; ++sweep) {
            double most = 0.0;
            for (std::size_t i = 0; i < region.size(); ++i) {
                glm::dvec2 sum(0.0);
                for (const VertexId near : m_mesh.neighbours(region[i]))
                    sum += placeOf[near] == noId ? fixed[near] : places[placeOf[near]];
                const glm::dvec2 way = sum / 3.0 - places[i];
                places[i] += overRelaxation * way;
                most = std::max({most, std::abs(way.x), std::abs(way.y)});
            }
            if (most < enough)
                break;
        }
    }

    bool makeBody()
    {
        std::vector<VariationalBody::Point> points;
        const auto isNew = [&](const glm::dvec3& place) {
            const double nearMm = 0.4 * m_edgeMm;
            return std::all_of(points.begin(), points.end(), [&](const auto& other) {
                return squaredOf(other.place - place) >= nearMm * nearMm;
            });
        };
        const auto take = [&](const glm::dvec3& place, const glm::dvec3& outwards) {
            const glm::dvec3 beyond = place + m_edgeMm * outwards;
            if (!isNew(place) || !isNew(beyond))
                return;
            points.push_back({.place = place, .value = 0.0});
            points.push_back({.place = beyond, .value = -m_edgeMm});
            m_shape.m_points.push_back(place);
        };
        for (std::size_t c = 0; c < m_contours.size(); ++c) {
            const auto& contour = m_contours[c];
            if (contour.size() < 3)
                continue;
            if (!m_isClosed[c])
                return because(Clause::saying("open and closed contours do not go together"));
            glm::dvec3 area(0.0);
            for (std::size_t i = 0; i < contour.size(); ++i)
                area += glm::cross(
                    contour[i] - contour[0], contour[(i + 1) % contour.size()] - contour[0]);
            for (std::size_t i = 0; i < contour.size(); ++i) {
                const glm::dvec3 along = contour[(i + 1) % contour.size()]
                    - contour[(i + contour.size() - 1) % contour.size()];
                const glm::dvec3 outwards = glm::cross(along, area);
                const double length = glm::length(outwards);
                if (length > 0.0)
                    take(contour[i], outwards / length);
            }
        }
        for (const VertexId id : spacedBorder())
            take(m_mesh.position(id), frameAt(m_mesh, id).normalLps);
        auto body = VariationalBody::through(points);
        if (!body)
            return because(Clause::saying("no body runs through these contours"));
        m_shape.m_body = *std::move(body);
        return true;
    }

    bool makeContourBody(const std::vector<TemplateContour>& contours)
    {
        if (m_border.size() < 3)
            return because(Clause::saying("the red region has no border"));
        ContourBodyPoints given{
            .contours = contours, .border = {}, .edgeMm = m_edgeMm, .isSound = {}};
        for (const VertexId id : spacedBorder())
            given.border.push_back(
                {.placeLps = m_mesh.position(id), .outwardsLps = frameAt(m_mesh, id).normalLps});
        // What is drawn along the sound surface is known better from the surface itself.
        given.isSound = [this](const glm::dvec3& point) {
            const VertexId nearest =
                nearestVertex(m_mesh, point, [](VertexId /*id*/) { return true; });
            const double nearMm = 2.0 * m_edgeMm;
            return nearest != noId && !m_isRegion[nearest]
                && squaredOf(m_mesh.position(nearest) - point) < nearMm * nearMm;
        };
        auto body = contourBody(given, m_progress);
        if (!body)
            return because(Clause::saying("no body runs through these contours"));
        m_shape.m_body = std::move(body->body);
        m_shape.m_points = std::move(body->pointsLps);
        glm::dvec3 least = m_shape.m_points.front();
        glm::dvec3 most = least;
        for (const glm::dvec3& point : m_shape.m_points) {
            least = glm::min(least, point);
            most = glm::max(most, point);
        }
        const glm::dvec3 margin = beyondDrawn * (most - least) + 2.0 * m_edgeMm;
        m_shape.m_leastLps = least - margin;
        m_shape.m_mostLps = most + margin;
        return true;
    }

    [[nodiscard]] bool isCancelled() const { return m_progress && m_progress->cancelled(); }

    bool because(const Clause& why)
    {
        m_why = why;
        return false;
    }

    const SimplexMesh& m_mesh;
    double m_edgeMm;
    const Progress* m_progress; ///< null: nobody cancels it
    std::vector<bool> m_isRegion; ///< by vertex
    std::vector<VertexId> m_border;
    std::vector<std::vector<glm::dvec3>> m_contours;
    std::vector<bool> m_isClosed;
    std::vector<glm::dvec3> m_points; ///< over the plane
    Clause m_why;
    TemplateShape m_shape;
};

Result<TemplateShape> TemplateShape::make(const SimplexMesh& mesh,
    const std::vector<TemplateContour>& contours, double areaMm2, TemplateForm form,
    const Progress* progress)
{
    return TemplateMaker(mesh, edgeMmOf(mesh, areaMm2), progress).make(contours, form);
}

glm::dvec3 TemplateShape::at(const glm::dvec2& place) const
{
    return m_origin + place.x * m_u + place.y * m_v + m_spline->at(place) * m_up;
}

glm::dvec2 TemplateShape::placeOf(const glm::dvec3& positionLps) const
{
    const glm::dvec3 from = positionLps - m_origin;
    return {glm::dot(from, m_u), glm::dot(from, m_v)};
}

glm::dvec3 TemplateShape::wayMm(const glm::dvec3& positionLps) const
{
    const VariationalBody::Value here = valueAt(positionLps);
    const double steep = glm::dot(here.rise, here.rise);
    return steep > 1e-12 ? -here.value / steep * here.rise : glm::dvec3(0.0);
}

VariationalBody::Value TemplateShape::valueAt(const glm::dvec3& positionLps) const
{
    VariationalBody::Value here = m_body->at(positionLps);
    if (m_form != TemplateForm::Body)
        return here;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const double insideMm = side < 0.0 ? positionLps[axis] - m_leastLps[axis]
                                               : m_mostLps[axis] - positionLps[axis];
            if (insideMm >= here.value)
                continue;
            here = {.value = insideMm, .rise = glm::dvec3(0.0)};
            here.rise[axis] = -side;
        }
    }
    return here;
}

std::vector<glm::dvec3> TemplateShape::preview(const SimplexMesh& mesh) const
{
    std::vector<glm::dvec3> preview;
    preview.reserve(m_region.size());
    for (std::size_t i = 0; i < m_region.size(); ++i) {
        if (!m_body) {
            preview.push_back(at(m_places[i]));
            continue;
        }
        glm::dvec3 place = mesh.position(m_region[i]);
        for (int step = 0; step < previewSteps; ++step)
            place += wayMm(place);
        preview.push_back(place);
    }
    return preview;
}

} // namespace core
