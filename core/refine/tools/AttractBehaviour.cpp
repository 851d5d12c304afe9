// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/InternalForces.h"
#include "core/refine/tools/EdgeTracks.h"
#include "core/refine/tools/ToolBehaviour.h"
#include "core/refine/voxels/GreyBox.h"

#include <algorithm>

namespace core {

namespace {

/// Of the way to the edge, in a step.
constexpr double attractedShare = 0.5;

/// Outwards, with a share of its neighbours' ones: of length 1, or 0.
glm::dvec3 evenNormal(const SimplexMesh& mesh, VertexId id)
{
    glm::dvec3 sum = 3.0 * frameAt(mesh, id).normalLps;
    for (const VertexId near : mesh.neighbours(id))
        sum += frameAt(mesh, near).normalLps;
    const double length = glm::length(sum);
    return length > 0.0 ? sum / length : glm::dvec3(0.0);
}

/// Edges are looked for once, from where the surface is when the stroke comes to it: from where it
/// is later it would go on from edge to edge.
class AttractBehaviour final : public ToolBehaviour {
public:
    AttractBehaviour(const AttractTool& tool, const ToolScale& scale)
        : ToolBehaviour(scale)
        , m_tool(tool)
        , m_tracks(1.5 * scale.edgeMm)
    {
    }

    double walkMm(double pressure) const override { return 0.25 * m_tool.radiusMm * pressure; }
    int stepsAtPlace() const override { return 3; }

    std::vector<VertexId> moveTo(const SimplexMesh& mesh, const SurfaceSample& sample) override
    {
        std::vector<VertexId> reached;
        if (!m_tool.grey)
            return reached;
        grow(mesh);
        const double radiusMm = m_tool.radiusMm * sample.pressure;
        for (VertexId id = 0; id < mesh.vertexSlots(); ++id) {
            const glm::dvec3 way = mesh.position(id) - sample.placeLps;
            if (!mesh.hasVertex(id) || mesh.mark(id) == SurfaceMark::Green
                || glm::dot(way, way) > radiusMm * radiusMm)
                continue;
            if (!m_parts[id].isTouched)
                touch(mesh, id);
            reached.push_back(id);
        }
        return reached;
    }

    std::optional<Grip> gripOf(
        const SurfacePoint& point, const Past& /*past*/, const glm::dvec3& placeLps) override
    {
        if (point.vertex >= m_parts.size() || !m_parts[point.vertex].isTouched)
            return std::nullopt;
        const auto leftMm = m_tracks.leftMm(point.positionLps);
        // Forces alone would shrink what there is no edge for.
        if (!leftMm)
            return Grip{.placeLps = point.positionLps};
        const double lengthMm = glm::length(*leftMm);
        const double strideMm = std::min(lengthMm, m_scale.strideMm(point));
        return Grip{.placeLps = lengthMm > 0.0
                ? placeLps + attractedShare * strideMm / lengthMm * *leftMm
                : placeLps};
    }

    void adopt(const SimplexMesh& mesh, VertexId id) override
    {
        grow(mesh);
        const auto& near = mesh.neighbours(id);
        // It lies among those whose edges are known, and has none of its own to look for.
        m_parts[id].isTouched =
            m_parts[id].isTouched || std::count_if(near.begin(), near.end(), [&](VertexId other) {
                return m_parts[other].isTouched;
            }) >= 2;
    }

private:
    /// Of a vertex, as it was when somebody first looked at it.
    struct Part {
        glm::dvec3 from{0.0};
        glm::dvec3 normal{0.0}; ///< outwards
        bool isKnown = false;
        bool isTouched = false;
        bool isSeen = false;
        EdgeProfile profile{}; ///< along the normal; no changes: nobody has looked
        std::optional<double> seenMm{}; ///< an edge along the normal, if it was looked for
    };

    /// One line through noise sees edges everywhere, and neighbours would part for different ones.
    /// So each looks at the mean of what those around it see, as noise is not common to them; and
    /// goes where most of them would have it, along its own normal.
    void touch(const SimplexMesh& mesh, VertexId id)
    {
        constexpr std::size_t fewest = 3;
        Part& part = known(mesh, id);
        part.isTouched = true;
        std::vector<double> edgesMm;
        for (const VertexId near : around(mesh, id)) {
            if (const auto edgeMm = seenMm(mesh, near)) {
                const Part& other = m_parts[near];
                edgesMm.push_back(
                    glm::dot(other.from + *edgeMm * other.normal - part.from, part.normal));
            }
        }
        if (edgesMm.size() < fewest)
            return;
        const auto middle = edgesMm.begin() + std::ptrdiff_t(edgesMm.size() / 2);
        std::nth_element(edgesMm.begin(), middle, edgesMm.end());
        m_tracks.add(part.from, part.from + *middle * part.normal, part.normal);
    }

    Part& known(const SimplexMesh& mesh, VertexId id)
    {
        Part& part = m_parts[id];
        if (!part.isKnown) {
            part.from = mesh.position(id);
            part.normal = evenNormal(mesh, id);
            part.isKnown = true;
        }
        return part;
    }

    const EdgeProfile& profileAt(const SimplexMesh& mesh, VertexId id)
    {
        Part& part = known(mesh, id);
        if (part.profile.changes.empty())
            part.profile = m_tool.grey->profileAlong(part.from, part.normal, m_tool.reachMm);
        return part.profile;
    }

    std::optional<double> seenMm(const SimplexMesh& mesh, VertexId id)
    {
        if (known(mesh, id).isSeen)
            return m_parts[id].seenMm;
        EdgeProfile mean = profileAt(mesh, id);
        const std::vector<VertexId> others = around(mesh, id);
        for (std::size_t i = 1; i < others.size(); ++i) {
            const std::vector<double>& changes = profileAt(mesh, others[i]).changes;
            for (std::size_t k = 0; k < changes.size(); ++k)
                mean.changes[k] += changes[k];
        }
        for (double& change : mean.changes)
            change /= double(others.size());
        m_parts[id].isSeen = true;
        return m_parts[id].seenMm = mean.edgeMm();
    }

    /// A vertex, then those that are one and two edges from it.
    static std::vector<VertexId> around(const SimplexMesh& mesh, VertexId id)
    {
        std::vector<VertexId> found{id};
        std::size_t first = 0;
        for (int ring = 0; ring < 2; ++ring) {
            for (const std::size_t end = found.size(); first < end; ++first) {
                for (const VertexId near : mesh.neighbours(found[first])) {
                    if (std::find(found.begin(), found.end(), near) == found.end())
                        found.push_back(near);
                }
            }
        }
        return found;
    }

    void grow(const SimplexMesh& mesh)
    {
        m_parts.resize(std::max<std::size_t>(m_parts.size(), mesh.vertexSlots()));
    }

    AttractTool m_tool;
    EdgeTracks m_tracks;
    std::vector<Part> m_parts; ///< by vertex
};

} // namespace

std::unique_ptr<ToolBehaviour> behaviourOf(const AttractTool& tool, const ToolScale& scale)
{
    return std::make_unique<AttractBehaviour>(tool, scale);
}

} // namespace core
