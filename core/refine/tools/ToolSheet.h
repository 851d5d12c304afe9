// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMesh.h"

#include <algorithm>
#include <vector>

namespace core {

/// The sheet of a surface under a tool: the vertices within the tool that are connected there with
/// the vertex nearest to the pen. Once a tool has touched a sheet, it stays with it as long as any
/// of its vertices, or a neighbour of them, is within the tool. So it does not jump to the opposite
/// wall of a structure.
class ToolSheet {
public:
    /// Updates the sheet for a new position. Cost ∝ the sheet, or ∝ the vertices of the mesh while
    /// the tool touches none.
    /// @param penLps where the pen is, LPS mm
    /// @param isWithin whether a place is within the tool
    template <typename IsWithin>
    void find(const SimplexMesh& mesh, const glm::dvec3& penLps, const IsWithin& isWithin)
    {
        VertexId from = noId;
        double least = 0.0;
        const auto consider = [&](VertexId id) {
            if (!mesh.hasVertex(id) || !isWithin(mesh.position(id)))
                return;
            const glm::dvec3 way = mesh.position(id) - penLps;
            const double squared = glm::dot(way, way);
            if (from != noId && (squared > least || (squared == least && id > from)))
                return;
            from = id;
            least = squared;
        };
        for (const VertexId id : m_vertices) {
            consider(id);
            if (!mesh.hasVertex(id))
                continue;
            for (const VertexId near : mesh.neighbours(id))
                consider(near);
        }
        for (VertexId id = 0; id < mesh.vertexSlots() && from == noId; ++id) {
            if (mesh.hasVertex(id) && isWithin(mesh.position(id))) {
                for (; id < mesh.vertexSlots(); ++id)
                    consider(id);
            }
        }
        m_isTouching = from != noId;
        if (m_isTouching)
            spread(mesh, from, isWithin);
    }

    /// Whether a vertex belongs to the sheet found by the last find(). Any thread.
    [[nodiscard]] bool contains(VertexId id) const
    {
        return m_isTouching && id < m_stamps.size() && m_stamps[id] == m_stamp;
    }
    /// The vertices of the sheet; none while the tool touches nothing.
    [[nodiscard]] std::vector<VertexId> vertices() const
    {
        return m_isTouching ? m_vertices : std::vector<VertexId>();
    }

private:
    template <typename IsWithin>
    void spread(const SimplexMesh& mesh, VertexId from, const IsWithin& isWithin)
    {
        m_stamps.resize(std::max<std::size_t>(m_stamps.size(), mesh.vertexSlots()), 0);
        ++m_stamp;
        m_vertices.assign(1, from);
        m_stamps[from] = m_stamp;
        for (std::size_t i = 0; i < m_vertices.size(); ++i) {
            for (const VertexId near : mesh.neighbours(m_vertices[i])) {
                if (m_stamps[near] == m_stamp || !isWithin(mesh.position(near)))
                    continue;
                m_stamps[near] = m_stamp;
                m_vertices.push_back(near);
            }
        }
        std::sort(m_vertices.begin(), m_vertices.end());
    }

    std::vector<VertexId> m_vertices; ///< vertices of the sheet that was touched last, ascending
    /// For each vertex, the number of the find() that found it last.
    std::vector<std::uint32_t> m_stamps;
    std::uint32_t m_stamp = 0;
    bool m_isTouching = false;
};

} // namespace core
