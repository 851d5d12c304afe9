// SPDX-License-Identifier: Apache-2.0
#include "core/refine/tools/TemplateShape.h"
#include "core/refine/tools/ToolBehaviour.h"

#include <algorithm>
#include <utility>

namespace core {

namespace {

class TemplateBehaviour final : public ToolBehaviour {
public:
    TemplateBehaviour(const TemplateTool& tool, const ToolScale& scale, const SimplexMesh& mesh)
        : ToolBehaviour(scale)
    {
        if (tool.shape)
            m_shape = *tool.shape;
        else if (auto shape = TemplateShape::make(mesh, tool.contours, scale.areaMm2))
            m_shape = *std::move(shape);
        else
            return;
        grow(mesh);
        for (std::size_t i = 0; i < m_shape->region().size(); ++i) {
            const VertexId id = m_shape->region()[i];
            m_parts[id].isRegion = true;
            if (m_shape->isBody())
                continue;
            m_parts[id].place = m_shape->places()[i];
            m_parts[id].target = m_shape->at(m_parts[id].place);
        }
        if (m_shape->isBody())
            return;
        for (const VertexId id : m_shape->region()) {
            for (const VertexId near : mesh.neighbours(id))
                static_cast<void>(placeOf(mesh, near));
        }
    }

    double walkMm(double /*pressure*/) const override { return 1e9; }
    int stepsAtPlace() const override { return 4; }
    int mostStepsAtPlace() const override { return 4; }

    std::vector<VertexId> moveTo(
        const SimplexMesh& /*mesh*/, const SurfaceSample& /*sample*/) override
    {
        if (!m_shape || m_isBegun)
            return {};
        m_isBegun = true;
        return m_shape->region();
    }

    /// All go the same share of their ways: those that had the shorter one would stand around a pit
    /// in which the others lag.
    void beginStep(const SimplexMesh& mesh) override
    {
        if (m_shape && !m_shape->isBody())
            relax(mesh);
        double mostMm = 0.0;
        for (VertexId id = 0; id < m_parts.size() && m_shape && !m_shape->isBody(); ++id) {
            if (m_parts[id].isRegion && mesh.hasVertex(id))
                mostMm = std::max(mostMm, glm::distance(m_parts[id].target, mesh.position(id)));
        }
        const double strideMm = 0.35 * m_scale.edgeMm;
        m_share = mostMm > strideMm ? strideMm / mostMm : 1.0;
    }

    std::optional<Grip> gripOf(
        const SurfacePoint& point, const Past& /*past*/, const glm::dvec3& placeLps) override
    {
        if (point.vertex >= m_parts.size() || !m_parts[point.vertex].isRegion)
            return std::nullopt;
        const glm::dvec3 way = m_shape->isBody() ? m_shape->wayMm(point.positionLps)
                                                 : m_parts[point.vertex].target - point.positionLps;
        const double leftMm = glm::length(way);
        if (m_shape->isBody())
            return towardsBody(point, placeLps, way, leftMm, m_scale.strideMm(point));
        if (m_share >= 1.0)
            return Grip{.placeLps = m_parts[point.vertex].target, .leftMm = leftMm};
        return Grip{.placeLps = point.positionLps + m_share * way, .leftMm = leftMm};
    }

    void adopt(const SimplexMesh& mesh, VertexId id) override
    {
        if (!m_shape)
            return;
        const bool wasThere = id < m_parts.size() && m_parts[id].isAdopted;
        grow(mesh);
        Part& part = m_parts[id];
        // The first time, it may be one of those that were there from the beginning.
        if (!wasThere && isOfRegion(id)) {
            part.isAdopted = true;
            return;
        }
        part = {};
        part.isAdopted = true;
        if (mesh.mark(id) != SurfaceMark::Red)
            return;
        glm::dvec2 sum(0.0);
        for (const VertexId near : mesh.neighbours(id)) {
            const bool isKnown = m_parts[near].isRegion;
            part.isRegion = part.isRegion || isKnown;
            if (m_shape->isBody())
                continue;
            sum += placeOf(mesh, near);
        }
        if (!part.isRegion || m_shape->isBody())
            return;
        part.place = sum / 3.0;
        part.target = m_shape->at(part.place);
    }

private:
    struct Part {
        glm::dvec2 place{0.0}; ///< in the template's plane
        glm::dvec3 target{0.0};
        bool isRegion = false;
        bool isBorder = false; ///< not of it, but with a place
        bool isAdopted = false; ///< seen in a step
    };

    /// Of a vertex beside the region that in which it was first met: where it is drawn along, the
    /// region would shrink after it.
    [[nodiscard]] glm::dvec2 placeOf(const SimplexMesh& mesh, VertexId id)
    {
        Part& part = m_parts[id];
        if (!part.isRegion && !part.isBorder) {
            part.isBorder = true;
            part.place = m_shape->placeOf(mesh.position(id));
        }
        return part.place;
    }

    /// A step towards each being in the middle of its neighbours in the template's plane: what
    /// restructuring puts in between would stand there in folds.
    void relax(const SimplexMesh& mesh)
    {
        grow(mesh);
        std::vector<std::pair<VertexId, glm::dvec2>> moved;
        for (VertexId id = 0; id < m_parts.size(); ++id) {
            if (!m_parts[id].isRegion || !mesh.hasVertex(id))
                continue;
            const auto neighbours = mesh.neighbours(id);
            // One that has just been made gets its place in this step.
            if (std::any_of(neighbours.begin(), neighbours.end(), [this](VertexId near) {
                    const Part& part = m_parts[near];
                    return !part.isRegion && !part.isBorder && !part.isAdopted;
                }))
                continue;
            glm::dvec2 sum(0.0);
            for (const VertexId near : neighbours)
                sum += placeOf(mesh, near);
            moved.emplace_back(id, sum / 3.0);
        }
        for (const auto& [id, place] : moved) {
            m_parts[id].place = place;
            m_parts[id].target = m_shape->at(place);
        }
    }

    void grow(const SimplexMesh& mesh)
    {
        m_parts.resize(std::max<std::size_t>(m_parts.size(), mesh.vertexSlots()));
    }
    [[nodiscard]] bool isOfRegion(VertexId id) const
    {
        const auto& region = m_shape->region();
        return std::binary_search(region.begin(), region.end(), id);
    }
    [[nodiscard]] static Grip towardsBody(const SurfacePoint& point, const glm::dvec3& placeLps,
        const glm::dvec3& way, double leftMm, double strideMm)
    {
        // Aside, forces may have their way.
        glm::dvec3 aside = placeLps - point.positionLps;
        if (leftMm > 0.0)
            aside -= glm::dot(aside, way) / (leftMm * leftMm) * way;
        const double asideMm = glm::length(aside);
        if (asideMm > 0.5 * strideMm)
            aside *= 0.5 * strideMm / asideMm;
        const double share = leftMm > strideMm ? strideMm / leftMm : 1.0;
        return {.placeLps = point.positionLps + aside + share * way, .leftMm = leftMm};
    }

    std::optional<TemplateShape> m_shape;
    std::vector<Part> m_parts; ///< by vertex
    double m_share = 1.0; ///< of its way, that each vertex goes in this step
    bool m_isBegun = false;
};

} // namespace

std::unique_ptr<ToolBehaviour> behaviourOf(
    const TemplateTool& tool, const ToolScale& scale, const SimplexMesh& mesh)
{
    if (tool.shape && tool.shape->form() == TemplateForm::Body)
        return bodyBehaviour(tool.shape, scale, mesh);
    return std::make_unique<TemplateBehaviour>(tool, scale, mesh);
}

} // namespace core
