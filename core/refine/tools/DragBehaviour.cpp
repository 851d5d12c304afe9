// SPDX-License-Identifier: Apache-2.0
#include "core/refine/tools/MarkPaint.h"
#include "core/refine/tools/ToolBehaviour.h"

#include <algorithm>

namespace core {

namespace {

/// Of a stride: one that goes with all others goes no farther, but for rounding.
constexpr double longestShare = 1.001;

class DragBehaviour final : public ToolBehaviour {
public:
    DragBehaviour(const DragTool& tool, const ToolScale& scale)
        : ToolBehaviour(scale)
        , m_tool(tool)
    {
    }

    double walkMm(double /*pressure*/) const override { return m_scale.edgeMm; }

    std::vector<VertexId> moveTo(const SimplexMesh& mesh, const SurfaceSample& sample) override
    {
        if (m_dragged == noId)
            pick(mesh, sample);
        else if (sample.pressure > m_pressure)
            widen(mesh, sample.pressure);
        if (m_dragged == noId)
            return {};
        m_wanted = sample.placeLps - m_from;
        std::vector<VertexId> reached;
        for (VertexId id = 0; id < m_parts.size(); ++id) {
            if (m_parts[id].weight > 0.0 && mesh.hasVertex(id))
                reached.push_back(id);
        }
        return reached;
    }

    /// All go together, each its share of the way.
    void beginStep(const SimplexMesh& mesh) override
    {
        if (m_dragged == noId)
            return;
        const glm::dvec3 way = m_wanted - m_shift;
        const double leftMm = glm::length(way);
        m_shift = leftMm > strideMm() ? m_shift + strideMm() / leftMm * way : m_wanted;
        m_leftMm = std::max(0.0, leftMm - strideMm());
        if (mesh.hasVertex(m_dragged) && m_parts[m_dragged].last == mesh.position(m_dragged))
            return;
        takeNearest(mesh);
    }

    std::optional<Grip> gripOf(
        const SurfacePoint& point, const Past& /*past*/, const glm::dvec3& /*placeLps*/) override
    {
        if (point.vertex >= m_parts.size())
            return std::nullopt;
        Part& part = m_parts[point.vertex];
        if (part.weight <= 0.0 || !(part.last == point.positionLps))
            return std::nullopt;
        const glm::dvec3 wanted = part.start + part.weight * m_shift;
        // One that was held up by another part of the surface does not leap after the others.
        const double wayMm = glm::distance(wanted, point.positionLps);
        const double mostMm = longestShare * strideMm();
        const bool lags = (m_scale.isApart || m_isWidened) && wayMm > mostMm;
        part.last =
            lags ? point.positionLps + mostMm / wayMm * (wanted - point.positionLps) : wanted;
        // One that was taken along later still has to catch up.
        const double behindMm = m_isWidened && lags ? wayMm - mostMm : 0.0;
        return Grip{.placeLps = part.last, .leftMm = part.weight * m_leftMm + behindMm};
    }

    void adopt(const SimplexMesh& mesh, VertexId id) override
    {
        if (m_dragged == noId || id == m_dragged)
            return;
        grow(mesh);
        Part& part = m_parts[id];
        if (part.last == mesh.position(id))
            return;
        double sum = 0.0;
        int known = 0;
        for (const VertexId near : mesh.neighbours(id)) {
            const Part& other = m_parts[near];
            if (other.weight > 0.0 && !(other.last == mesh.position(near)))
                continue;
            sum += other.weight;
            ++known;
        }
        part.weight = known > 0 ? sum / known : 0.0;
        part.last = mesh.position(id);
        part.start = part.last - part.weight * m_shift;
    }

    void stopped(const SimplexMesh& mesh, VertexId id) override
    {
        if (id < m_parts.size())
            m_parts[id].last = mesh.position(id);
    }

    VertexId dragged() const override { return m_dragged; }

private:
    /// What a vertex takes part in the drag.
    struct Part {
        glm::dvec3 start{0.0};
        glm::dvec3 last{0.0}; ///< where it was left
        double weight = 0.0;
    };

    /// How far it goes in a step.
    [[nodiscard]] double strideMm() const { return 0.35 * m_scale.edgeMm; }
    void grow(const SimplexMesh& mesh)
    {
        m_parts.resize(std::max<std::size_t>(m_parts.size(), mesh.vertexSlots()));
    }

    void pick(const SimplexMesh& mesh, const SurfaceSample& sample)
    {
        m_dragged = mesh.hasVertex(m_tool.again)
            ? m_tool.again
            : nearestVertex(mesh, sample.placeLps,
                [&](VertexId id) { return mesh.mark(id) != SurfaceMark::Green; });
        if (m_dragged == noId)
            return;
        grow(mesh);
        m_from = mesh.position(m_dragged);
        m_pressure = sample.pressure;
        for (VertexId id = 0; id < mesh.vertexSlots(); ++id)
            m_parts[id].last = mesh.position(id);
        const double radiusMm = m_tool.radiusMm * sample.pressure;
        for (const VertexId id : reachedWithin(mesh, m_dragged, m_from, radiusMm)) {
            const glm::dvec3 way = mesh.position(id) - m_from;
            const double near = 1.0 - glm::dot(way, way) / (radiusMm * radiusMm);
            m_parts[id] = {.start = mesh.position(id),
                .last = mesh.position(id),
                .weight = id == m_dragged ? 1.0 : near * near};
        }
    }

    /// Where the structure changed at the dragged vertex, the one that is nearest now takes its
    /// part.
    void takeNearest(const SimplexMesh& mesh)
    {
        m_dragged = nearestVertex(mesh, m_from + m_shift,
            [&](VertexId id) { return mesh.mark(id) != SurfaceMark::Green; });
        if (m_dragged == noId)
            return;
        grow(mesh);
        m_parts[m_dragged] = {.start = m_from, .last = mesh.position(m_dragged), .weight = 1.0};
    }

    /// Whoever presses harder takes along more around the point: what the surface had there before
    /// it was dragged.
    void widen(const SimplexMesh& mesh, double pressure)
    {
        m_pressure = pressure;
        m_isWidened = true;
        if (!mesh.hasVertex(m_dragged))
            takeNearest(mesh);
        if (m_dragged == noId)
            return;
        grow(mesh);
        const double radiusMm = m_tool.radiusMm * pressure;
        const auto nearOf = [&](VertexId id) {
            const Part& part = m_parts[id];
            const glm::dvec3 way = (part.weight > 0.0 ? part.start : mesh.position(id)) - m_from;
            return 1.0 - glm::dot(way, way) / (radiusMm * radiusMm);
        };
        std::vector<bool> isReached(mesh.vertexSlots(), false);
        std::vector<VertexId> reached{m_dragged};
        isReached[m_dragged] = true;
        for (std::size_t i = 0; i < reached.size(); ++i) {
            for (const VertexId next : mesh.neighbours(reached[i])) {
                if (isReached[next] || nearOf(next) <= 0.0)
                    continue;
                isReached[next] = true;
                reached.push_back(next);
            }
        }
        for (const VertexId id : reached) {
            const double near = nearOf(id);
            Part& part = m_parts[id];
            if (id == m_dragged || near * near <= part.weight)
                continue;
            if (part.weight <= 0.0)
                part = {.start = mesh.position(id), .last = mesh.position(id)};
            part.weight = near * near;
        }
    }

    DragTool m_tool;
    double m_pressure = 1.0; ///< the greatest so far
    bool m_isWidened = false; ///< it became greater since the point was picked
    VertexId m_dragged = noId;
    glm::dvec3 m_from{0.0}; ///< where it was picked
    glm::dvec3 m_wanted{0.0}; ///< how far it is to go
    glm::dvec3 m_shift{0.0}; ///< how far it has gone
    double m_leftMm = 0.0;
    std::vector<Part> m_parts; ///< by vertex
};

} // namespace

std::unique_ptr<ToolBehaviour> behaviourOf(const DragTool& tool, const ToolScale& scale)
{
    return std::make_unique<DragBehaviour>(tool, scale);
}

} // namespace core
