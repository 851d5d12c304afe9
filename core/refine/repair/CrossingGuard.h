// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMeshEdit.h"
#include "core/refine/repair/FaceGrid.h"

#include <set>
#include <span>

namespace core {

/// Keeps a surface from passing through itself while it is deformed. Exact: what it lets pass has
/// no pair of faces that SelfIntersections.h finds, apart from pairs that the surface had before.
///
/// It remembers where the vertices were when no new pair was there. After a move it looks at the
/// faces that moved and what lies around them. Vertices of faces that cross then go only half of
/// their way, or not at all, until no face crosses: this ends, since two faces that did not move at
/// all do not cross. The result does not depend on the number of threads.
class CrossingGuard {
public:
    /// @param mesh, geometry must outlive this; the mesh is written only through edits that are
    /// reported here. Cost ∝ the faces.
    /// @param progress once it is cancelled nothing is kept apart any more, and every change of
    /// structure is refused: only a rollback makes sense then. Null: it never is; must outlive this
    CrossingGuard(const SimplexMesh& mesh, const VolumeGeometry& geometry,
        const Progress* progress = nullptr);

    /// Reports vertices that may have moved since the last call of keepApart().
    void moved(std::span<const VertexId> vertices);
    /// Takes back of the moves as much as needed. Returns the vertices that were moved less far
    /// than they should have been, ascending.
    [[nodiscard]] std::vector<VertexId> keepApart(SimplexMeshEdit& edit);
    /// The greatest distance that a reported vertex has moved since keepApart(), mm.
    [[nodiscard]] double movedMm() const;

    /// Carries out a change of structure unless faces would cross afterwards. Only faces whose ring
    /// it writes are looked at: other faces must not have a vertex that it moves. To be called
    /// directly after keepApart(). False: it was refused, or the change itself did, and nothing is
    /// changed.
    template <typename Change> bool attempt(SimplexMeshEdit& edit, const Change& change)
    {
        if (isCancelled())
            return false;
        edit.beginTrial();
        return concludes(edit, change());
    }

private:
    [[nodiscard]] bool isCancelled() const;
    [[nodiscard]] bool concludes(SimplexMeshEdit& edit, bool isChanged);
    /// Of these, the pairs that were not there before.
    void forgetKnown(std::vector<CrossingFaces>& crossings) const;
    [[nodiscard]] std::vector<FaceId> facesAt(std::span<const VertexId> vertices) const;
    /// Forgets known pairs of faces that were written, unless they still cross: ids of faces are
    /// used again. Both ascending.
    void dropKnown(std::span<const FaceId> written, std::span<const CrossingFaces> crossings);
    void remember(std::span<const FaceId> faces);

    const SimplexMesh& m_mesh;
    const Progress* m_progress;
    FaceGrid m_grid;
    std::vector<glm::dvec3> m_safe; ///< by vertex: where it was when no new pair was there
    std::vector<VertexId> m_moved; ///< since keepApart(), each once
    std::vector<bool> m_isMoved; ///< by vertex: it is among them
    std::set<CrossingFaces> m_known; ///< the surface had them before
};

} // namespace core
