// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/sighted/SurfaceActions.h"

#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/surface/ApplyTemplate.h"
#include "core/edits/kinds/surface/AttractSurface.h"
#include "core/edits/kinds/surface/ChangeMarks.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/MarkSurface.h"
#include "core/edits/kinds/surface/PlaneScrape.h"
#include "core/edits/kinds/surface/PointDrag.h"
#include "core/edits/kinds/surface/SpherePush.h"
#include "core/edits/kinds/surface/WriteBack.h"
#include "core/session/SessionSurface.h"

#include <algorithm>
#include <cmath>

using namespace core;

namespace reenact {

namespace {

/// Of the surface, about: as many as a liver of 3 mm voxels has at its border.
constexpr int vertices = 12'000;
/// A contour is drawn where it is read; what is read farther from where it was meant is another
/// outline.
constexpr double sameOutlineMm = 8.0;

/// From a place on to where it lies deep enough within what is seen (@p side −1) or outside it (1).
/// @param flat the axis along which it must not move; −1: none
glm::dvec3 deeper(const UserEye& eye, glm::dvec3 place, double side, double enough, int flat)
{
    for (int i = 0; i < 40 && side * eye.offSeen(place) < enough; ++i) {
        glm::dvec3 rise(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            if (axis == flat)
                continue;
            glm::dvec3 step(0.0);
            step[axis] = 1.0;
            rise[axis] = eye.offSeen(place + step) - eye.offSeen(place - step);
        }
        const double length = glm::length(rise);
        if (length < 1e-6)
            break;
        place += side * rise / length;
    }
    return place;
}

QString millimetres(double mm)
{
    return QString::number(mm, 'f', 1);
}

} // namespace

SurfaceActions::SurfaceActions(
    RefinementBench& bench, Inspection& inspection, SightedLog& log, std::uint64_t seed)
    : m_bench(bench)
    , m_inspection(inspection)
    , m_log(log)
    , m_hand(bench.geometry(), seed)
{
}

bool SurfaceActions::divide(double marginMm)
{
    return m_log.prepare(
        DivideSegment{.segment = 1, .marginMm = marginMm}, QStringLiteral("divide"));
}

bool SurfaceActions::clickChunks(const ChunkStroke& stroke)
{
    ChunkToggle toggle{.segment = 1,
        .chunks = stroke.division,
        .mode = stroke.adds ? ChunkToggle::Mode::Add : ChunkToggle::Mode::Remove};
    toggle.pointsLps = m_hand.drawn(m_hand.lps(alongStroke(stroke.points)));
    return m_log.act(toggle,
        QStringLiteral("%1 chunks, %2 points")
            .arg(stroke.adds ? QStringLiteral("add") : QStringLiteral("remove"))
            .arg(stroke.points.size()));
}

bool SurfaceActions::lay()
{
    return m_log.prepare(
        LaySurface{.segment = 1, .vertices = vertices, .rules = newestSurfaceRules},
        QStringLiteral("lay the surface"));
}

bool SurfaceActions::writeBack()
{
    return m_log.prepare(WriteBack{.rules = newestSurfaceRules}, QStringLiteral("write back"));
}

SurfacePath SurfaceActions::pathOf(double radius, const std::vector<glm::dvec3>& points)
{
    const double radiusMm = m_hand.radiusMm(m_hand.mm(radius));
    return {.radiusMm = radiusMm,
        .pointsLps = m_hand.drawn(m_hand.lps(points)),
        .rules = newestSurfaceRules};
}

bool SurfaceActions::push(
    const UserEye& eye, const UserEye::Region& region, const BallStroke& stroke)
{
    const double side = region.isMissing ? -1.0 : 1.0;
    const double enough = 0.5 * stroke.radius;
    // It comes from the side from which it is to push: from within the mask, or from outside. On
    // the slice on which it is led, if that side is to be had there.
    glm::dvec3 begin = deeper(eye, stroke.points.front(), side, enough, stroke.axis);
    const bool isOnSlice = side * eye.offSeen(begin) >= enough;
    if (!isOnSlice)
        begin = deeper(eye, stroke.points.front(), side, enough, -1);
    std::vector<glm::dvec3> points{begin};
    points.insert(points.end(), stroke.points.begin(), stroke.points.end());
    SurfacePath path = pathOf(stroke.radius, {});
    const glm::dvec3 across = m_bench.geometry().direction()[stroke.axis];
    path.pointsLps = isOnSlice ? m_hand.drawnOnPlane(m_hand.lps(points), across)
                               : m_hand.drawn(m_hand.lps(points));
    return m_log.act(SpherePush{.path = path},
        QStringLiteral("sphere r=%1 mm, %2 points")
            .arg(millimetres(path.radiusMm))
            .arg(points.size()));
}

bool SurfaceActions::scrape(const ScrapePlan& plan)
{
    const VolumeGeometry& geometry = m_bench.geometry();
    const glm::dvec3 normal =
        glm::normalize(geometry.toWorld(plan.place + plan.normal) - geometry.toWorld(plan.place));
    const SurfacePath path = pathOf(plan.radius, {plan.place});
    return m_log.act(PlaneScrape{.path = path, .normalLps = m_hand.normal(normal, path.radiusMm)},
        QStringLiteral("plane r=%1 mm").arg(millimetres(path.radiusMm)));
}

bool SurfaceActions::drag(const DragPlan& plan)
{
    const SurfacePath path = pathOf(plan.radius, {plan.from, plan.to});
    return m_log.act(PointDrag{.path = path},
        QStringLiteral("drag r=%1 mm by %2 mm")
            .arg(millimetres(path.radiusMm),
                millimetres(m_hand.mm(glm::distance(plan.from, plan.to)))));
}

bool SurfaceActions::attract(const SweepPlan& plan)
{
    const SurfacePath path = pathOf(plan.radius, plan.points);
    return m_log.act(AttractSurface{.path = path},
        QStringLiteral("attract r=%1 mm, %2 points")
            .arg(millimetres(path.radiusMm))
            .arg(plan.points.size()));
}

bool SurfaceActions::shape(const TemplatePlan& plan)
{
    // What tools left red elsewhere would join the region.
    const auto marks = m_bench.session().surface().mesh()->marks();
    if (std::find(marks.begin(), marks.end(), SurfaceMark::Red) != marks.end())
        m_log.prepare(ChangeMarks{.mark = SurfaceMark::Red, .way = ChangeMarks::Way::Clear},
            QStringLiteral("clear the marks"));
    const SurfacePath path = pathOf(plan.paintRadius, plan.paint);
    if (!m_log.prepare(MarkSurface{.mark = SurfaceMark::Red, .path = path},
            QStringLiteral("paint red, r=%1 mm").arg(millimetres(path.radiusMm))))
        return false;
    ApplyTemplate shape{.contoursLps = {}, .rules = newestSurfaceRules};
    for (const TemplatePlan::Contour& contour : plan.contours) {
        shape.contoursLps.push_back(asRead(contour));
        m_log.countOne(QStringLiteral("contour of %1 points").arg(contour.points.size()));
    }
    return m_log.act(shape, QStringLiteral("template"));
}

std::vector<glm::dvec3> SurfaceActions::asRead(const TemplatePlan::Contour& contour)
{
    const VolumeGeometry& geometry = m_bench.geometry();
    std::vector<glm::dvec3> meant = m_hand.lps(contour.points);
    const glm::dvec3 normal =
        glm::normalize(geometry.toWorld(contour.normal) - geometry.toWorld(glm::dvec3(0.0)));
    const SeenPlane view = m_inspection.open(meant.front(), normal, m_log.seen());
    for (glm::dvec3& place : meant) {
        glm::dvec3 nearest = place;
        double least = sameOutlineMm;
        for (const PlaneLine& line : view.readings) {
            for (const glm::dvec3& read : line) {
                const double off = glm::distance(read, place);
                if (off >= least)
                    continue;
                least = off;
                nearest = read;
            }
        }
        place = nearest;
    }
    return m_hand.drawnOnPlane(meant, normal);
}

} // namespace reenact
