// SPDX-License-Identifier: Apache-2.0
#include "core/base/ParallelFor.h"
#include "core/refine/tools/TemplateShape.h"
#include "core/refine/tools/ToolBehaviour.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace core {

namespace {

/// Where the surface is nearer than this, in edges, it goes straight to the body.
constexpr double straightFrom = 1.0;
/// What is farther than this from the body, in edges, is not measured again before it has gone a
/// quarter of that way.
constexpr double farFrom = 2.0;
/// And nearer, as far as the body is as good as flat, in edges.
constexpr double stillThere = 0.15;
/// At most, however far it is: the way may lead past a part of the body.
constexpr double unmeasured = 2.0;
/// The body rises by about 1 mm per mm near what it runs through. Where it rises less than this,
/// value by rise would say anything.
constexpr double leastRise = 0.5;
/// Steps from one look at how far all still has to go to the next. The first is before the second
/// step: in the first step all are measured.
constexpr int stepsBetweenLooks = 5;

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
        if (m_steps++ % stepsBetweenLooks != 1)
            return;
        std::vector<glm::dvec3> region;
        double offMm = 0.0;
        for (VertexId id = 0; id < m_parts.size(); ++id) {
            const Part& part = m_parts[id];
            if (!part.isRegion || part.measuredMm < 0.0 || !mesh.hasVertex(id))
                continue;
            region.push_back(mesh.position(id));
            offMm += part.offMm;
        }
        if (region.empty())
            return;
        const std::vector<glm::dvec3>& points = m_shape->pointsLps();
        std::vector<double> squared(points.size(), 1e300); // of each point, to the nearest
        parallelFor(int(points.size()), [&](int i) {
            for (const glm::dvec3& place : region) {
                const glm::dvec3 way = place - points[std::size_t(i)];
                squared[std::size_t(i)] = std::min(squared[std::size_t(i)], glm::dot(way, way));
            }
        });
        double missedMm = 0.0;
        for (const double nearest : squared)
            missedMm += std::sqrt(nearest);
        ++m_looks;
        m_leftMm = offMm / double(region.size())
            + missedMm / double(std::max<std::size_t>(points.size(), 1));
    }

    std::optional<double> leftMm() const override { return m_leftMm; }
    int looks() const override { return m_looks; }

    std::optional<Grip> gripOf(
        const SurfacePoint& point, const Past& /*past*/, const glm::dvec3& placeLps) override
    {
        if (point.vertex >= m_parts.size() || !m_parts[point.vertex].isRegion)
            return std::nullopt;
        Part& part = m_parts[point.vertex];
        measure(part, point.positionLps);
        const double strideMm = m_scale.strideMm(point);
        const double offMm = part.offMm;
        const double side = part.isInside ? 1.0 : -1.0;
        const glm::dvec3& straight = part.straight;
        const double nearMm = straightFrom * m_scale.edgeMm;
        const double share = offMm > nearMm ? nearMm / offMm : 1.0;
        glm::dvec3 way = share * straight + (1.0 - share) * side * point.normalLps;
        const double length = glm::length(way);
        way = length > 1e-3 ? way / length : straight;
        // Aside, forces may have their way, so that faces stay even; far away, also along the way,
        // so that the front has no pits and bumps.
        glm::dvec3 aside = placeLps - point.positionLps;
        aside -= share * glm::dot(aside, way) * way;
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
        part.measuredMm = -1.0;
    }

private:
    struct Part {
        double offMm = 0.0; ///< from the body, at the last step
        double measuredMm = -1.0; ///< how far off it was when that was measured; < 0: never
        glm::dvec3 measuredAt{0.0}; ///< and where
        VariationalBody::Value measured; ///< the body there
        glm::dvec3 straight{0.0}; ///< the shortest way, as a unit vector; 0: there is none
        bool isInside = false; ///< the body
        bool isRegion = false;
        bool isAdopted = false; ///< seen in a step
    };

    /// Anew where it has gone so far that what was measured says too little.
    void measure(Part& part, const glm::dvec3& placeLps) const
    {
        const glm::dvec3 gone = placeLps - part.measuredAt;
        const double goneMm = glm::length(gone);
        const bool isFar = part.measuredMm > farFrom * m_scale.edgeMm;
        const double enoughMm = isFar
            ? std::min(0.25 * part.measuredMm, unmeasured * m_scale.edgeMm)
            : stillThere * m_scale.edgeMm;
        if (part.measuredMm < 0.0 || goneMm > enoughMm) {
            part.measured = m_shape->valueAt(placeLps);
            part.measuredAt = placeLps;
        }
        const double steep = glm::length(part.measured.rise);
        const bool isKnown = steep > 1e-6;
        const double value = part.measuredAt == placeLps
            ? part.measured.value
            : part.measured.value + glm::dot(part.measured.rise, gone);
        part.isInside = value > 0.0;
        part.offMm = std::abs(value) / std::max(steep, leastRise);
        part.straight =
            isKnown ? (part.isInside ? -1.0 : 1.0) / steep * part.measured.rise : glm::dvec3(0.0);
        if (part.measuredAt == placeLps)
            part.measuredMm = part.offMm;
    }

    void grow(const SimplexMesh& mesh)
    {
        m_parts.resize(std::max<std::size_t>(m_parts.size(), mesh.vertexSlots()));
    }

    std::shared_ptr<const TemplateShape> m_shape;
    std::vector<Part> m_parts; ///< by vertex
    std::optional<double> m_leftMm;
    int m_looks = 0;
    int m_steps = 0;
    bool m_isBegun = false;
};

} // namespace

std::unique_ptr<ToolBehaviour> bodyBehaviour(
    std::shared_ptr<const TemplateShape> shape, const ToolScale& scale, const SimplexMesh& mesh)
{
    return std::make_unique<BodyBehaviour>(std::move(shape), scale, mesh);
}

} // namespace core
