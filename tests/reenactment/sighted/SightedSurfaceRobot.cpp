// SPDX-License-Identifier: Apache-2.0
#include "core/session/SessionSurface.h"
#include "tests/reenactment/sighted/SightedRobots.h"
#include "tests/reenactment/sighted/SurfaceActions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

using namespace core;

namespace reenact {

namespace {

/// Chunks are for what few of them explain: the first stroke mends so much of what is seen to be
/// wrong, each further one so much of what is left.
constexpr double firstChunkShare = 0.5;
constexpr double nextChunkShare = 0.3;
/// Of the organ's voxels: who hopes for less gives up.
constexpr double leastHope = 1e-3;
/// Laying and writing back are two actions: not for less than this.
constexpr double leastForSurface = 4e-3;
constexpr std::size_t mostRegions = 4;
/// Of what lies deep under a sweep of attraction, what a user hopes to mend: where organs touch, it
/// finds the edge of a neighbour as readily.
constexpr double attractHope = 0.25;
constexpr double sweepReach = 28.0; ///< voxels
/// Of the outline that is to be reached, so much must be an edge for attraction to be tried.
constexpr double leastEdgeShare = 0.6;
/// What a hope is worth after each failure of the tool.
constexpr double trust = 0.5;
/// Of what was hoped for: with less a tool has failed.
constexpr double leastKept = 0.2;
constexpr int mostTries = 2; ///< of a tool on a region
/// Contours of a vessel run along both of its walls: templates are for lobes.
constexpr double leastTemplate = 3.0; ///< voxels
/// Edges of the surface: a sphere that is smaller than what it pushes leaves folds.
constexpr double leastSphereEdges = 2.5;
constexpr double leastSphere = 1.2; ///< voxels

/// How long the edges of a surface are, in the mean.
double edgeMm(const SimplexMesh& mesh)
{
    double sum = 0.0;
    for (const VertexId id : mesh.vertexIds()) {
        for (const VertexId near : mesh.neighbours(id))
            sum += glm::distance(mesh.position(id), mesh.position(near)) / 3.0;
    }
    return sum / double(mesh.vertexCount());
}

class Robot {
public:
    Robot(
        RefinementBench& bench, Reader& reader, const SightedPatience& patience, std::uint64_t seed)
        : m_bench(bench)
        , m_reader(reader)
        , m_patience(patience)
        , m_inspection(reader, bench.geometry(), bench.seen())
        , m_log(bench, m_inspection)
        , m_actions(bench, m_inspection, m_log, seed)
        , m_voxels(double(countOf(m_inspection.organ())))
    {
    }

    SightedRun run()
    {
        if (quarrel() > 0)
            mendByChunks();
        const bool isWorthIt = double(quarrel()) >= leastForSurface * m_voxels && isLeft(4);
        if (isWorthIt && m_actions.lay()) {
            while (mendRegion()) { }
            m_actions.writeBack();
        }
        return m_log.finished(m_reader.looks());
    }

private:
    enum class Tool : std::uint8_t { Sphere, Scrape, Drag, Template, Attract };

    [[nodiscard]] bool isLeft(int actions) const
    {
        return m_log.actions() + actions <= m_patience.mostActions;
    }
    [[nodiscard]] std::size_t quarrel() const
    {
        return differing(m_log.seen(), m_inspection.meant(m_log.seen()));
    }

    void mendByChunks()
    {
        const double marginMm =
            ChunkMap::suitableMarginMm(std::int64_t(m_voxels), m_bench.geometry());
        if (!m_actions.divide(marginMm))
            return;
        const auto map = m_bench.chunks();
        if (!map)
            return;
        int division = 0;
        for (int failures = 0; isLeft(3) && failures < 2;) {
            const Mask meant = m_inspection.meant(m_log.seen());
            const UserEye eye(m_log.seen(), meant);
            const double wrong = double(differing(m_log.seen(), meant));
            ChunkStroke stroke = bestChunkStroke(*map, eye, division);
            const ChunkStroke other = bestChunkStroke(*map, eye, 0);
            // Another place of the slider is an action by itself.
            if (stroke.gain < 0.5 * other.gain)
                stroke = other;
            if (stroke.gain < (division == 0 ? firstChunkShare : nextChunkShare) * wrong
                || stroke.gain < leastHope * m_voxels)
                return;
            if (stroke.division != division)
                m_log.countOne(QStringLiteral("slider to %1").arg(stroke.division));
            division = stroke.division;
            failures += m_actions.clickChunks(stroke) ? 0 : 1;
        }
    }

    struct Choice {
        Tool tool = Tool::Sphere;
        double worth = 0.0; ///< voxels for an action
        int gain = 0;
        std::size_t place = 0;
        std::function<bool()> act;
    };

    /// @return whether there was anything to be done
    bool mendRegion()
    {
        const Mask meant = m_inspection.meant(m_log.seen());
        const UserEye eye(m_log.seen(), meant);
        const auto regions = eye.regions();
        Choice best;
        for (std::size_t i = 0; i < std::min(mostRegions, regions.size()); ++i)
            consider(eye, regions[i], best);
        if (best.worth < leastHope * m_voxels)
            return false;
        const std::size_t was = m_inspection.wrongIn(m_log.seen());
        const bool isKept = best.act();
        const double mended = double(was) - double(m_inspection.wrongIn(m_log.seen()));
        const bool helped = isKept && mended >= leastKept * best.gain;
        m_trust[std::size_t(best.tool)] = helped ? 1.0 : trust * m_trust[std::size_t(best.tool)];
        if (!helped)
            ++m_tries[{best.tool, best.place}];
        return true;
    }

    void consider(const UserEye& eye, const UserEye::Region& region, Choice& best)
    {
        const std::size_t place = eye.seen().offset(region.part.deepest);
        const auto offer = [&](Tool tool, int gain, int actions, std::function<bool()> act) {
            // It may have to be taken back, a template may have to clear marks first, and in the
            // end the surface is written back.
            const int more = tool == Tool::Template ? 3 : 2;
            if (m_tries[{tool, place}] >= mostTries || !isLeft(actions + more))
                return;
            const double worth = m_trust[std::size_t(tool)] * double(gain) / double(actions);
            if (worth > best.worth)
                best = {tool, worth, gain, place, std::move(act)};
        };
        const SimplexMesh& mesh = *m_bench.session().surface().mesh();
        const VolumeGeometry& geometry = m_bench.geometry();
        const double voxelMm = std::cbrt(geometry.voxelVolumeMm3());
        const BallStroke ball = bestStroke(
            eye, region, std::max(leastSphere, leastSphereEdges * edgeMm(mesh) / voxelMm));
        offer(Tool::Sphere, ball.gain, 1,
            [this, &eye, region, ball] { return m_actions.push(eye, region, ball); });
        const ScrapePlan plane = bestScrape(eye, region);
        offer(Tool::Scrape, plane.gain, 1, [this, plane] { return m_actions.scrape(plane); });
        const DragPlan drag = bestDrag(eye, region);
        offer(Tool::Drag, drag.gain, 1, [this, drag] { return m_actions.drag(drag); });
        if (region.part.radius >= leastTemplate) {
            const TemplatePlan shape = templateFor(eye, region, mesh, geometry);
            offer(Tool::Template, shape.gain, shape.actions(),
                [this, shape] { return m_actions.shape(shape); });
        }
        if (m_inspection.edgeShareNear(region.part.voxels) >= leastEdgeShare) {
            const double wide = std::clamp(4.0 * region.part.radius + 2.0, 3.0, 9.0);
            const SweepPlan attract = sweepOver(eye, region, mesh, geometry, sweepReach, wide);
            offer(Tool::Attract, attract.points.empty() ? 0 : int(attractHope * attract.deep), 1,
                [this, attract] { return m_actions.attract(attract); });
        }
    }

    RefinementBench& m_bench;
    Reader& m_reader;
    SightedPatience m_patience;
    Inspection m_inspection;
    SightedLog m_log;
    SurfaceActions m_actions;
    double m_voxels; ///< of the organ, as it was read
    std::array<double, 5> m_trust{1.0, 1.0, 1.0, 1.0, 1.0}; ///< by tool
    std::map<std::pair<Tool, std::size_t>, int> m_tries; ///< by the region's deepest voxel
};

} // namespace

SightedRun runSightedSurfaceRobot(
    RefinementBench& bench, Reader& reader, const SightedPatience& patience, std::uint64_t seed)
{
    return Robot(bench, reader, patience, seed).run();
}

} // namespace reenact
