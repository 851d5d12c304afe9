// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/SurfaceRobot.h"

#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/surface/ApplyTemplate.h"
#include "core/edits/kinds/surface/AttractSurface.h"
#include "core/edits/kinds/surface/ChangeMarks.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/MarkSurface.h"
#include "core/edits/kinds/surface/PlaneScrape.h"
#include "core/edits/kinds/surface/PointDrag.h"
#include "core/edits/kinds/surface/SmoothSurface.h"
#include "core/edits/kinds/surface/SpherePush.h"
#include "core/edits/kinds/surface/WriteBack.h"
#include "core/edits/kinds/surface/parts/SurfacePath.h"
#include "core/session/SessionSurface.h"
#include "tests/reenactment/BallStroke.h"
#include "tests/reenactment/ChunkStroke.h"
#include "tests/reenactment/RobotLog.h"
#include "tests/reenactment/ToolPlans.h"
#include "tests/reenactment/UserHand.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>

using namespace core;

namespace reenact {

namespace {

/// Chunks are for what few of them explain: the first stroke mends so much of what is wrong, each
/// further one so much of what is left.
constexpr double firstChunkShare = 0.5;
constexpr double nextChunkShare = 0.3;
/// Of the organ's voxels: who hopes for less gives up.
constexpr double leastHope = 3e-4;
constexpr std::size_t mostRegions = 5;
/// Of what is wrong under a sweep of attraction (by more than a voxel: it does no better than that
/// where there is noise) and of smoothing, what a user hopes to mend.
constexpr double attractHope = 0.6;
constexpr double smoothHope = 0.12;
constexpr double sweepReach = 28.0; ///< voxels
/// What a hope is worth after each failure of the tool; that of attraction and smoothing says that
/// the picture, or the surface, is not made for it.
constexpr double trust = 0.6;
constexpr double sweepTrust = 0.2;
/// Of what was hoped for: with less a tool has failed.
constexpr double leastKept = 0.2;
/// After so many failures a user tries something else on a region.
constexpr int mostTries = 2;
/// A sphere that is too small for what it pushes leaves folds.
constexpr double leastSphere = 2.0;

class Robot {
public:
    Robot(RefinementBench& bench, const Truth& truth, const RobotGoal& goal,
        const SurfaceRobotTools& tools, std::uint64_t seed)
        : m_bench(bench)
        , m_truth(truth)
        , m_goal(goal)
        , m_tools(tools)
        , m_hand(bench.geometry(), seed)
        , m_log(bench, truth)
    {
    }

    RobotRun run()
    {
        if (m_tools.chunks)
            mendByChunks();
        if (isDone())
            return m_log.finished();
        if (!m_log.prepare(LaySurface{.segment = 1, .vertices = m_tools.vertices},
                QStringLiteral("lay the surface")))
            return m_log.finished();
        while (!isDone() && mendRegion()) { }
        m_log.prepare(WriteBack{}, QStringLiteral("write back"));
        return m_log.finished();
    }

private:
    enum class Tool : std::uint8_t { Sphere, Scrape, Drag, Template, Attract, Smooth };

    [[nodiscard]] bool isDone() const
    {
        return m_log.error() <= m_goal.error || m_log.actions() >= m_goal.mostActions;
    }

    void mendByChunks()
    {
        if (!m_log.prepare(
                DivideSegment{.segment = 1, .marginMm = m_hand.mm(8.0)}, QStringLiteral("divide")))
            return;
        const auto map = m_bench.chunks();
        if (!map)
            return;
        int division = 0;
        for (int failures = 0; !isDone() && failures < 2;) {
            const UserEye eye(m_log.seen(), m_truth.plain);
            const double wrong = double(differing(m_log.seen(), m_truth.plain));
            ChunkStroke stroke = bestChunkStroke(*map, eye, division);
            const ChunkStroke other = bestChunkStroke(*map, eye, 0);
            // Another place of the slider is an action by itself.
            if (stroke.gain < 0.5 * other.gain)
                stroke = other;
            if (stroke.gain < (division == 0 ? firstChunkShare : nextChunkShare) * wrong)
                return;
            if (stroke.division != division)
                m_log.countOne(QStringLiteral("slider to %1").arg(stroke.division));
            division = stroke.division;
            ChunkToggle toggle{.segment = 1,
                .chunks = division,
                .mode = stroke.adds ? ChunkToggle::Mode::Add : ChunkToggle::Mode::Remove};
            toggle.pointsLps = m_hand.lps(within(alongStroke(m_hand.drawn(stroke.points))));
            if (!m_log.act(toggle,
                    QStringLiteral("%1 chunks, %2 points")
                        .arg(stroke.adds ? QStringLiteral("add") : QStringLiteral("remove"))
                        .arg(stroke.points.size())))
                ++failures;
        }
    }

    /// A pen does not leave the picture.
    [[nodiscard]] std::vector<glm::dvec3> within(std::vector<glm::dvec3> places) const
    {
        const glm::dvec3 most(m_bench.geometry().size - 1);
        for (glm::dvec3& place : places)
            place = glm::clamp(place, glm::dvec3(0.0), most);
        return places;
    }

    /// @return whether there was anything to be done
    bool mendRegion()
    {
        const UserEye eye(m_log.seen(), m_truth.plain);
        const auto regions = eye.regions();
        struct Choice {
            double worth = 0.0; ///< voxels for an action
            std::function<bool()> act;
            Tool tool = Tool::Sphere;
            std::size_t place = 0;
            int gain = 0;
        };
        Choice best;
        const auto offer = [&](Tool tool, const UserEye::Region& region, int gain, int actions,
                               std::function<bool()> act) {
            const std::size_t place = eye.seen().offset(region.part.deepest);
            if (m_tries[{tool, place}] >= mostTries)
                return;
            double worth = double(gain) / double(actions);
            const bool sweeps = tool == Tool::Attract || tool == Tool::Smooth;
            for (int i = 0; i < m_failures[std::size_t(tool)]; ++i)
                worth *= sweeps ? sweepTrust : trust;
            if (worth > best.worth)
                best = {worth, std::move(act), tool, place, gain};
        };
        std::vector<BallStroke> balls(mostRegions);
        std::vector<ScrapePlan> scrapes(mostRegions);
        std::vector<DragPlan> drags(mostRegions);
        std::vector<TemplatePlan> templates(mostRegions);
        std::vector<SweepPlan> attracts(mostRegions);
        std::vector<SweepPlan> smooths(mostRegions);
        for (std::size_t i = 0; i < std::min(mostRegions, regions.size()); ++i) {
            const UserEye::Region& region = regions[i];
            balls[i] = bestStroke(eye, region, leastSphere);
            scrapes[i] = bestScrape(eye, region);
            drags[i] = bestDrag(eye, region);
            templates[i] =
                templateFor(eye, region, *m_bench.session().surface().mesh(), m_bench.geometry());
            offer(Tool::Sphere, region, balls[i].gain, 1,
                [&, i] { return push(eye, regions[i], balls[i]); });
            offer(Tool::Scrape, region, scrapes[i].gain, 1, [&, i] { return scrape(scrapes[i]); });
            offer(Tool::Drag, region, drags[i].gain, 1, [&, i] { return drag(drags[i]); });
            offer(Tool::Template, region, templates[i].gain, templates[i].actions(),
                [&, i] { return shape(templates[i]); });
            // A smaller brush looks less far, and meets fewer other edges.
            const int tried = m_tries[{Tool::Attract, eye.seen().offset(region.part.deepest)}];
            const double wide = (tried > 0 ? 2.0 : 4.0) * region.part.radius + 2.0;
            attracts[i] = sweep(eye, region, std::clamp(wide, 3.0, tried > 0 ? 5.0 : 9.0));
            offer(Tool::Attract, region,
                attracts[i].points.empty() ? 0 : int(attractHope * attracts[i].deep), 1, [&, i] {
                    return m_log.act(
                        AttractSurface{pathOf(attracts[i])}, told("attract", attracts[i]));
                });
            smooths[i] = sweep(eye, region, 3.0);
            offer(Tool::Smooth, region, int(smoothHope * smooths[i].wrong), 1, [&, i] {
                return m_log.act(SmoothSurface{pathOf(smooths[i])}, told("smooth", smooths[i]));
            });
        }
        if (best.worth < leastHope * double(countOf(m_truth.plain)))
            return false;
        int& failures = m_failures[std::size_t(best.tool)];
        const std::int64_t wrong = differing(m_log.seen(), m_truth.plain);
        const bool helped = best.act()
            && double(wrong - differing(m_log.seen(), m_truth.plain)) >= leastKept * best.gain;
        failures = helped ? 0 : failures + 1;
        if (!helped)
            ++m_tries[{best.tool, best.place}];
        return true;
    }

    [[nodiscard]] SweepPlan sweep(
        const UserEye& eye, const UserEye::Region& region, double leastRadius)
    {
        return sweepOver(eye, region, *m_bench.session().surface().mesh(), m_bench.geometry(),
            sweepReach, leastRadius);
    }
    [[nodiscard]] SurfacePath pathOf(const SweepPlan& plan)
    {
        return {
            .radiusMm = m_hand.mm(plan.radius), .pointsLps = m_hand.lps(m_hand.drawn(plan.points))};
    }
    [[nodiscard]] static QString told(const char* what, const SweepPlan& plan)
    {
        return QStringLiteral("%1 r=%2, %3 points over %4 wrong")
            .arg(QLatin1String(what))
            .arg(plan.radius, 0, 'f', 1)
            .arg(plan.points.size())
            .arg(plan.wrong);
    }

    bool push(const UserEye& eye, const UserEye::Region& region, const BallStroke& stroke)
    {
        // It comes from the side from which it is to push: from within the mask, or from outside.
        const double side = region.isMissing ? -1.0 : 1.0;
        glm::dvec3 begin = stroke.points.front();
        for (int i = 0; i < 40 && side * eye.offSeen(begin) < 0.5 * stroke.radius; ++i) {
            glm::dvec3 rise(0.0);
            for (int axis = 0; axis < 3; ++axis) {
                glm::dvec3 step(0.0);
                step[axis] = 1.0;
                rise[axis] = eye.offSeen(begin + step) - eye.offSeen(begin - step);
            }
            const double length = glm::length(rise);
            if (length < 1e-6)
                break;
            begin += side * rise / length;
        }
        std::vector<glm::dvec3> points{begin};
        points.insert(points.end(), stroke.points.begin(), stroke.points.end());
        return m_log.act(SpherePush{.path = {.radiusMm = m_hand.mm(stroke.radius),
                                        .pointsLps = m_hand.lps(m_hand.drawn(points))}},
            QStringLiteral("sphere r=%1, %2 points, hopes for %3")
                .arg(stroke.radius)
                .arg(points.size())
                .arg(stroke.gain));
    }

    bool scrape(const ScrapePlan& plan)
    {
        const VolumeGeometry& geometry = m_bench.geometry();
        const glm::dvec3 normal = glm::normalize(
            geometry.toWorld(plan.place + plan.normal) - geometry.toWorld(plan.place));
        return m_log.act(PlaneScrape{.path = {.radiusMm = m_hand.mm(plan.radius),
                                         .pointsLps = m_hand.lps(m_hand.drawn({plan.place}))},
                             .normalLps = normal},
            QStringLiteral("plane r=%1, hopes for %2").arg(plan.radius, 0, 'f', 1).arg(plan.gain));
    }

    bool drag(const DragPlan& plan)
    {
        return m_log.act(
            PointDrag{.path = {.radiusMm = m_hand.mm(plan.radius),
                          .pointsLps = m_hand.lps(m_hand.drawn({plan.from, plan.to}))}},
            QStringLiteral("drag r=%1 by %2, hopes for %3")
                .arg(plan.radius, 0, 'f', 1)
                .arg(glm::distance(plan.from, plan.to), 0, 'f', 1)
                .arg(plan.gain));
    }

    bool shape(const TemplatePlan& plan)
    {
        // What tools left red elsewhere would join the region.
        const SimplexMesh& mesh = *m_bench.session().surface().mesh();
        const auto marks = mesh.marks();
        if (std::find(marks.begin(), marks.end(), SurfaceMark::Red) != marks.end())
            m_log.prepare(ChangeMarks{.mark = SurfaceMark::Red, .way = ChangeMarks::Way::Invert},
                QStringLiteral("marks"));
        return m_log.prepare(MarkSurface{.mark = SurfaceMark::Red,
                                 .path = {.radiusMm = m_hand.mm(plan.paintRadius),
                                     .pointsLps = m_hand.lps(m_hand.drawn(plan.paint))}},
                   QStringLiteral("red r=%1").arg(plan.paintRadius, 0, 'f', 1))
            && applyTemplate(plan);
    }

    bool applyTemplate(const TemplatePlan& plan)
    {
        ApplyTemplate shape{.contoursLps = {}, .rules = newestSurfaceRules};
        for (const TemplatePlan::Contour& contour : plan.contours) {
            shape.contoursLps.push_back(
                m_hand.lps(m_hand.drawnOnPlane(contour.points, contour.normal)));
            m_log.countOne(QStringLiteral("contour of %1").arg(contour.points.size()));
        }
        return m_log.act(shape, QStringLiteral("template, hopes for %1").arg(plan.gain));
    }

    RefinementBench& m_bench;
    const Truth& m_truth;
    RobotGoal m_goal;
    SurfaceRobotTools m_tools;
    UserHand m_hand;
    RobotLog m_log;
    std::array<int, 6> m_failures{};
    std::map<std::pair<Tool, std::size_t>, int> m_tries; ///< by the region's deepest voxel
};

} // namespace

RobotRun runSurfaceRobot(RefinementBench& bench, const Truth& truth, const RobotGoal& goal,
    const SurfaceRobotTools& tools, std::uint64_t seed)
{
    return Robot(bench, truth, goal, tools, seed).run();
}

} // namespace reenact
