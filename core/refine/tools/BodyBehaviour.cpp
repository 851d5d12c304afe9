// SPDX-License-Identifier: Apache-2.0
#include "core/refine/tools/TemplateShape.h"
#include "core/refine/tools/ToolBehaviour.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace core {

namespace {

/// Where the surface is nearer than this, in edges, it goes straight to the body.
constexpr double straightFrom = 1.0;

/// Blows a region up, or lets it collapse, until it lies on a body. The shortest way to the body
/// leads from the floor of a deep lobe to its walls, where no part of the floor belongs: far from
/// the body the region moves the way it faces, as a front, and only the last bit straight.
class BodyBehaviour final : public ToolBehaviour {
public:
    BodyBehaviour(
        std::shared_ptr<const TemplateShape> shape, const ToolScale& scale, const SimplexMesh& mesh)
        : ToolBehaviour(scale)
        , m_shape(std::move(shape))
    {
        grow(mesh);
        for (const VertexId id : m_shape->region())
            m_parts[id].isRegion = true;
    }

    double walkMm(double /*pressure*/) const override { return 1e9; }
    int stepsAtPlace() const override { return 4; }
    int mostStepsAtPlace() const override { return 4; }
    int mostStepsToRest() const override { return 24; }

    std::vector<VertexId> moveTo(
        const SimplexMesh& /*mesh*/, const SurfaceSample& /*sample*/) override
    {
        if (m_isBegun)
            return {};
        m_isBegun = true;
        return m_shape->region();
    }

    /// How far the region and the template are apart in the mean: each of its vertices from the
    /// body, and each point that was drawn from the nearest vertex. A front that goes into a lobe
    /// is no nearer to the lobe's walls, but to the points in the lobe.
    void beginStep(const SimplexMesh& mesh) override
    {
        grow(mesh);
        std::vector<glm::dvec3> region;
        double offMm = 0.0;
        for (VertexId id = 0; id < m_parts.size(); ++id) {
            if (!m_parts[id].isRegion || !mesh.hasVertex(id))
                continue;
            region.push_back(mesh.position(id));
            offMm += m_parts[id].offMm;
        }
        if (region.empty())
            return;
        double missedMm = 0.0;
        for (const glm::dvec3& point : m_shape->pointsLps()) {
            double least = 1e300;
            for (const glm::dvec3& place : region) {
                const glm::dvec3 way = place - point;
                least = std::min(least, glm::dot(way, way));
            }
            missedMm += std::sqrt(least);
        }
        m_leftMm = offMm / double(region.size())
            + missedMm / double(std::max<std::size_t>(m_shape->pointsLps().size(), 1));
    }

    std::optional<double> leftMm() const override { return m_leftMm; }

    std::optional<Grip> gripOf(
        const SurfacePoint& point, const Past& /*past*/, const glm::dvec3& placeLps) override
    {
        if (point.vertex >= m_parts.size() || !m_parts[point.vertex].isRegion)
            return std::nullopt;
        const VariationalBody::Value here = m_shape->valueAt(point.positionLps);
        const double steep = glm::length(here.rise);
        const double offMm = steep > 1e-6 ? std::abs(here.value) / steep : 0.0;
        m_parts[point.vertex].offMm = offMm;
        const double strideMm = m_scale.strideMm(point);
        if (!(steep > 1e-6))
            return Grip{.placeLps = point.positionLps, .leftMm = 0.0};
        const double side = here.value > 0.0 ? 1.0 : -1.0;
        const glm::dvec3 straight = -side / steep * here.rise;
        const double nearMm = straightFrom * m_scale.edgeMm;
        const double share = offMm > nearMm ? nearMm / offMm : 1.0;
        glm::dvec3 way = share * straight + (1.0 - share) * side * point.normalLps;
        const double length = glm::length(way);
        way = length > 1e-3 ? way / length : straight;
        // Aside, forces may have their way, so that faces stay even.
        glm::dvec3 aside = placeLps - point.positionLps;
        aside -= glm::dot(aside, way) * way;
        const double asideMm = glm::length(aside);
        if (asideMm > 0.5 * strideMm)
            aside *= 0.5 * strideMm / asideMm;
        return Grip{.placeLps = point.positionLps + aside + std::min(offMm, strideMm) * way,
            .leftMm = offMm};
    }

    void adopt(const SimplexMesh& mesh, VertexId id) override
    {
        grow(mesh);
        Part& part = m_parts[id];
        const auto& region = m_shape->region();
        const bool isFirst = !part.isAdopted;
        part.isAdopted = true;
        // The first time, it may be one of those that were there from the beginning.
        if (isFirst && std::binary_search(region.begin(), region.end(), id))
            return;
        const auto& near = mesh.neighbours(id);
        part.isRegion = mesh.mark(id) == SurfaceMark::Red
            && std::any_of(near.begin(), near.end(),
                [this](VertexId other) { return m_parts[other].isRegion; });
        part.offMm = 0.0;
    }

private:
    struct Part {
        double offMm = 0.0; ///< from the body, at the last step
        bool isRegion = false;
        bool isAdopted = false; ///< seen in a step
    };

    void grow(const SimplexMesh& mesh)
    {
        m_parts.resize(std::max<std::size_t>(m_parts.size(), mesh.vertexSlots()));
    }

    std::shared_ptr<const TemplateShape> m_shape;
    std::vector<Part> m_parts; ///< by vertex
    std::optional<double> m_leftMm;
    bool m_isBegun = false;
};

} // namespace

std::unique_ptr<ToolBehaviour> bodyBehaviour(
    std::shared_ptr<const TemplateShape> shape, const ToolScale& scale, const SimplexMesh& mesh)
{
    return std::make_unique<BodyBehaviour>(std::move(shape), scale, mesh);
}

} // namespace core
