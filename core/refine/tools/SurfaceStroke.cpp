// SPDX-License-Identifier: Apache-2.0
#include "core/refine/tools/SurfaceStroke.h"

#include "core/base/Progress.h"
#include "core/refine/deform/BoundaryForce.h"
#include "core/refine/deform/Deformation.h"
#include "core/refine/repair/CrossingGuard.h"
#include "core/refine/repair/MeshRestructuring.h"
#include "core/refine/tools/MarkPaint.h"
#include "core/refine/tools/SurfaceHolds.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// A regular hexagon of area 1 has edges of this length.
constexpr double hexagonEdge = 0.6204032394013997;
/// As long as the tool has something to move, and then until all is at rest
/// (ToolBehaviour::mostStepsToRest).
constexpr int mostStepsToMove = 600;
/// What is kept apart and was moved by a tool of the pen: when the pen is lifted, most of it is
/// done.
constexpr int mostStepsAfterPen = 160;
/// What a stroke has stretched more than this is split in the end, of the intended face.
constexpr double largestFace = 4.0;
constexpr double longestEdge = 4.0;
/// The last steps change no structure, so that they can come to an end.
constexpr int stepsWithStructure = 40;
/// What may move before it is looked whether the surface passes through itself, in edges.
constexpr double movedUnseen = 0.5;
/// How far beyond the tool, where it was, vertices are moved at all, in edges: what moves wakes
/// what is beside it, and in a rugged surface that would go on and on.
constexpr double reachAround = 8.0;
/// What other parts of the surface hold up is not waited for: so many steps in which nothing comes
/// nearer to where the tool wants it, by a share of an edge, are enough.
constexpr int mostInVain = 4;
constexpr int mostInVainAfterPen = 20;
constexpr double leastNearer = 0.02;
/// Of a mean, in which the last few vertices count little.
constexpr double leastNearerInMean = 0.004;
/// A mean is not measured in each step: so many measures are enough.
constexpr int mostLooksInVain = 8;
/// How far from where the tool wants them vertices may be left on the way, in edges.
constexpr double leftOnTheWay = 0.25;

/// How far from the pen a tool works; none: its region is given.
struct ToolReach {
    template <typename Tool> std::optional<double> operator()(const Tool& tool) const
    {
        return tool.radiusMm;
    }
    std::optional<double> operator()(const PlaneTool& tool) const
    {
        return tool.radiusMm + tool.heightMm;
    }
    std::optional<double> operator()(const TemplateTool&) const { return std::nullopt; }
};

/// Whether it still pays to wait for what a tool moves.
class Patience {
public:
    Patience(double leastMm, int mostVain)
        : m_leastMm(leastMm)
        , m_mostVain(mostVain)
    {
    }
    /// @param leftMm how far it still has to go
    [[nodiscard]] bool lasts(double leftMm)
    {
        if (leftMm < m_nearestMm - m_leastMm) {
            m_nearestMm = leftMm;
            m_inVain = 0;
            return true;
        }
        return ++m_inVain < m_mostVain;
    }

private:
    double m_leastMm;
    int m_mostVain;
    double m_nearestMm = 1e300;
    int m_inVain = 0;
};

} // namespace

double edgeMmOf(const SimplexMesh& mesh, double areaMm2)
{
    return hexagonEdge * std::sqrt(areaMm2 > 0.0 ? areaMm2 : meanFaceAreaMm2(mesh));
}

class SurfaceStroke::Motion {
public:
    Motion(SimplexMesh& mesh, const BoundaryForce* boundary, const SurfaceTool& tool,
        const SurfaceStrokeSettings& settings)
        : m_edit(mesh)
        , m_mesh(mesh)
        , m_boundary(boundary)
        , m_settings(settings)
    {
        m_structure.areaMm2 = settings.areaMm2 > 0.0 ? settings.areaMm2 : meanFaceAreaMm2(mesh);
        m_scale = {.areaMm2 = m_structure.areaMm2,
            .edgeMm = edgeMmOf(mesh, m_structure.areaMm2),
            .isApart = settings.apartOn != nullptr};
        m_deformation = Deformation({.negligibleMm = 0.01 * m_scale.edgeMm,
            .stirringMm = 0.25 * m_scale.edgeMm,
            .shares = settings.shares});
        std::visit([this](const auto& kind) { take(kind); }, tool);
        if (settings.apartOn)
            m_reachMm = std::visit(ToolReach(), tool);
        if (const auto* brush = std::get_if<MarkBrush>(&tool))
            m_brush = *brush;
        m_holds = std::make_unique<SurfaceHolds>(*m_tool, boundary != nullptr);
    }

    void add(const SurfaceSample& sample)
    {
        const SurfaceSample from = m_last.value_or(sample);
        const double walkMm = walkMmOf(std::min(from.pressure, sample.pressure));
        const double wayMm = glm::distance(from.placeLps, sample.placeLps);
        // A surface without faces has no edges to measure by.
        const double places = walkMm > 0.0 ? std::min(wayMm / walkMm, double(mostPlaces)) : 1.0;
        const int count = std::max(int(std::ceil(places)), 1);
        for (int i = 1; i <= count && !isCancelled(); ++i) {
            const double share = double(i) / double(count);
            visit(i == count
                    ? sample
                    : SurfaceSample{
                        .placeLps = from.placeLps + share * (sample.placeLps - from.placeLps),
                        .pressure = from.pressure + share * (sample.pressure - from.pressure),
                        .normalLps = from.normalLps + share * (sample.normalLps - from.normalLps)});
        }
        m_last = sample;
        keepApart();
    }

    void settle()
    {
        if (m_isSettled)
            return;
        m_isSettled = true;
        m_tool->lift();
        m_holds->letYellowGo();
        const double nearMm = leftOnTheWay * m_scale.edgeMm;
        const bool measuresItself = m_tool->leftMm().has_value();
        Patience patience((measuresItself ? leastNearerInMean : leastNearer) * m_scale.edgeMm,
            measuresItself ? mostLooksInVain : mostInVainAfterPen);
        bool isPatient = true;
        int looks = -1;
        const int most = m_scale.isApart && m_reachMm ? mostStepsAfterPen : mostStepsToMove;
        const int mostToRest = m_tool->mostStepsToRest();
        const int withStructure = std::min(stepsWithStructure, mostToRest / 2);
        for (int i = 0, since = 0;
             i < most && since < mostToRest && !m_deformation.active().empty(); ++i) {
            if (isCancelled())
                return;
            step(since < withStructure);
            const double leftMm = leftToGoMm();
            // What measures its way itself is done when that gets no shorter.
            const bool isNews = measuresItself ? looks != m_tool->looks() : m_scale.isApart;
            looks = m_tool->looks();
            isPatient = isPatient && (!isNews || patience.lasts(leftMm));
            const bool waits = (leftMm > nearMm || measuresItself) && isPatient;
            since = waits ? 0 : since + 1;
        }
        keepApart();
        if (m_guard && !isCancelled())
            splitStretched(m_edit, m_everActive,
                {.areaMm2 = largestFace * m_scale.areaMm2, .edgeMm = longestEdge * m_scale.edgeMm},
                &*m_guard);
        const VertexId dragged = m_tool->dragged();
        if (dragged != noId)
            m_edit.setMark(dragged, SurfaceMark::Green);
    }

    SimplexMeshEdit& edit() { return m_edit; }
    [[nodiscard]] std::size_t active() const { return m_deformation.active().size(); }
    [[nodiscard]] int steps() const { return m_steps; }

private:
    /// Strokes of more than this are not by hand.
    static constexpr int mostPlaces = 100'000;

    [[nodiscard]] bool isCancelled() const
    {
        return m_settings.progress && m_settings.progress->cancelled();
    }

    template <typename Kind> void take(const Kind& kind) { m_tool = behaviourOf(kind, m_scale); }
    void take(const TemplateTool& tool) { m_tool = behaviourOf(tool, m_scale, m_mesh); }

    [[nodiscard]] double walkMmOf(double pressure) const
    {
        return std::max(m_tool->walkMm(pressure), 0.1 * m_scale.edgeMm);
    }

    void visit(const SurfaceSample& sample)
    {
        if (m_reachMm)
            noteVisit(sample);
        if (m_brush)
            paint(sample);
        m_deformation.activate(m_mesh, m_tool->moveTo(m_mesh, sample));
        freeDragged();
        const double nearMm = leftOnTheWay * m_scale.edgeMm;
        Patience patience(leastNearer * m_scale.edgeMm, mostInVain);
        for (int i = 0; i < m_tool->mostStepsAtPlace() && !m_deformation.active().empty(); ++i) {
            if (isCancelled())
                return;
            step(true);
            const double leftMm = m_holds->leftMm(m_deformation.active());
            const bool waits = leftMm > nearMm && (!m_scale.isApart || patience.lasts(leftMm));
            if (i + 1 >= m_tool->stepsAtPlace() && !waits)
                return;
        }
    }

    [[nodiscard]] double leftToGoMm() const
    {
        const std::optional<double> leftMm = m_tool->leftMm();
        return leftMm ? *leftMm : m_holds->leftMm(m_deformation.active());
    }

    void noteActive()
    {
        m_isNoted.resize(std::max<std::size_t>(m_isNoted.size(), m_mesh.vertexSlots()), false);
        for (const VertexId id : m_deformation.active()) {
            if (m_isNoted[id])
                continue;
            m_isNoted[id] = true;
            m_everActive.push_back(id);
        }
    }

    /// One place stands for those within half a reach, whenever the tool was there.
    void noteVisit(const SurfaceSample& sample)
    {
        m_pressure = std::max(m_pressure, sample.pressure);
        if (!isVisited(sample.placeLps, 0.5 * *m_reachMm))
            m_visited.push_back(sample.placeLps);
    }

    /// Whether the tool was within this distance of a place. From the newest: what moves is near.
    [[nodiscard]] bool isVisited(const glm::dvec3& placeLps, double withinMm) const
    {
        return std::any_of(m_visited.rbegin(), m_visited.rend(), [&](const glm::dvec3& visited) {
            const glm::dvec3 way = placeLps - visited;
            return glm::dot(way, way) < withinMm * withinMm;
        });
    }

    /// What was woken far from where the tool was goes back to rest.
    void restFar()
    {
        if (!m_reachMm)
            return;
        const double farMm = (m_pressure + 0.5) * *m_reachMm + reachAround * m_scale.edgeMm;
        std::vector<VertexId> far;
        for (const VertexId id : m_deformation.active()) {
            if (m_mesh.hasVertex(id) && !isVisited(m_mesh.position(id), farMm))
                far.push_back(id);
        }
        m_deformation.rest(far);
    }

    void paint(const SurfaceSample& sample)
    {
        const auto painted =
            paintMarks(m_edit, sample.placeLps, m_brush->radiusMm * sample.pressure, m_brush->mark);
        // What is yellow now goes back to the mask.
        if (m_boundary && m_brush->mark == SurfaceMark::Yellow)
            m_deformation.activate(m_mesh, painted);
    }

    void step(bool structure)
    {
        std::vector<const ExternalForce*> forces;
        if (m_boundary)
            forces.push_back(m_boundary);
        m_tool->beginStep(m_mesh);
        freeDragged();
        restFar();
        m_holds->learn(m_mesh, m_deformation.active());
        forces.push_back(m_holds.get());
        if (m_settings.apartOn && !m_guard)
            m_guard.emplace(m_mesh, *m_settings.apartOn, m_settings.progress);
        if (isCancelled())
            return;
        // Some may be at rest after it.
        if (m_guard) {
            m_guard->moved(m_deformation.active());
            noteActive();
        }
        m_deformation.step(m_edit, forces, m_holds.get());
        ++m_steps;
        if (isCancelled())
            return;
        if (m_settings.reddens)
            redden();
        const bool restructures = structure && m_settings.restructureEvery > 0
            && m_steps % m_settings.restructureEvery == 0;
        if (m_guard && (restructures || m_guard->movedMm() > movedUnseen * m_scale.edgeMm))
            keepApart();
        if (!restructures || isCancelled())
            return;
        const Restructured done =
            restructure(m_edit, m_deformation.active(), m_structure, m_guard ? &*m_guard : nullptr);
        m_deformation.restructured(m_mesh, done.vertices);
    }

    void keepApart()
    {
        if (!m_guard || isCancelled())
            return;
        const std::vector<VertexId> stopped = m_guard->keepApart(m_edit);
        m_deformation.stop(stopped);
        m_holds->stopped(m_mesh, stopped);
    }

    /// The mask has no say in it, nor that it may have been dragged before.
    void freeDragged()
    {
        const VertexId dragged = m_tool->dragged();
        if (dragged == noId || m_mesh.mark(dragged) == SurfaceMark::Red)
            return;
        m_edit.setMark(dragged, SurfaceMark::Red);
        m_deformation.activate(m_mesh, std::vector<VertexId>{dragged});
    }

    void redden()
    {
        for (const VertexId id : m_deformation.active()) {
            if (m_mesh.mark(id) == SurfaceMark::Yellow && m_holds->isGripped(id))
                m_edit.setMark(id, SurfaceMark::Red);
        }
    }

    SimplexMeshEdit m_edit;
    const SimplexMesh& m_mesh;
    const BoundaryForce* m_boundary;
    SurfaceStrokeSettings m_settings;
    RestructuringSettings m_structure;
    ToolScale m_scale;
    Deformation m_deformation{{}};
    std::optional<CrossingGuard> m_guard; ///< from the first step on
    std::optional<MarkBrush> m_brush;
    std::unique_ptr<ToolBehaviour> m_tool;
    std::unique_ptr<SurfaceHolds> m_holds;
    std::optional<SurfaceSample> m_last;
    std::optional<double> m_reachMm; ///< of the tool; none: what is woken may be anywhere
    double m_pressure = 0.0; ///< the greatest so far
    std::vector<glm::dvec3> m_visited; ///< about where the tool was
    std::vector<VertexId> m_everActive; ///< in a stroke that is kept apart
    std::vector<bool> m_isNoted; ///< by vertex: it is among them
    bool m_isSettled = false;
    int m_steps = 0;
};

SurfaceStroke::SurfaceStroke(SimplexMesh& mesh, const BoundaryForce* boundary,
    const SurfaceTool& tool, const SurfaceStrokeSettings& settings)
    : m_motion(std::make_unique<Motion>(mesh, boundary, tool, settings))
{
}

SurfaceStroke::~SurfaceStroke() = default;

void SurfaceStroke::add(const SurfaceSample& sample)
{
    m_motion->add(sample);
}

void SurfaceStroke::settle()
{
    m_motion->settle();
}

WrittenParts SurfaceStroke::takeWritten()
{
    return m_motion->edit().takeWritten();
}

std::size_t SurfaceStroke::activeVertices() const
{
    return m_motion->active();
}

int SurfaceStroke::steps() const
{
    return m_motion->steps();
}

SimplexMeshDelta SurfaceStroke::commit()
{
    m_motion->settle();
    return m_motion->edit().commit();
}

void SurfaceStroke::rollback()
{
    m_motion->edit().rollback();
}

} // namespace core
