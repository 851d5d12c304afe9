// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMeshEdit.h"
#include "core/refine/repair/FaceGrid.h"

#include <set>
#include <span>

namespace core {

/// Prevents a surface from passing through itself while it is deformed. Exact: afterwards
/// SelfIntersections.h finds no pair of faces that the surface did not already have before.
///
/// It remembers the position of each vertex at a time when there was no new pair. After a move it
/// examines the moved faces and those around them. Vertices of faces that cross then go only half
/// of their way, and if that does not suffice stay where they were, until no faces cross. This
/// terminates, because two faces that do not move at all do not cross. The result does not depend
/// on the number of threads.
class CrossingGuard {
public:
    /// @param mesh, geometry must outlive this; the mesh may be written only by edits that are
    /// reported here. Cost ∝ the faces.
    /// @param progress once it is cancelled, nothing is kept apart any more and every change of
    /// structure is refused; then only a rollback makes sense. Null: it is never cancelled. Must
    /// outlive this
    CrossingGuard(const SimplexMesh& mesh, const VolumeGeometry& geometry,
        const Progress* progress = nullptr);

    /// Reports vertices that may have moved since the last call of keepApart().
    void moved(std::span<const VertexId> vertices);
    /// Reverts as much of the reported moves as needed. Returns the vertices that were moved less
    /// far than they should have been, ascending.
    [[nodiscard]] std::vector<VertexId> keepApart(SimplexMeshEdit& edit);
    /// The greatest distance that a reported vertex has moved since keepApart(), mm.
    [[nodiscard]] double movedMm() const;

    /// Carries out a change of structure unless faces would cross afterwards. Only faces whose ring
    /// the change writes are examined, so no other face may have a vertex that it moves. Must be
    /// called directly after keepApart(). Returns false if it was refused, or if the change itself
    /// returned false; then nothing is changed.
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
    /// Removes the pairs that were there before.
    void forgetKnown(std::vector<CrossingFaces>& crossings) const;
    [[nodiscard]] std::vector<FaceId> facesAt(std::span<const VertexId> vertices) const;
    /// Forgets known pairs of faces that were written, unless they still cross: ids of faces are
    /// used again. Both ascending.
    void dropKnown(std::span<const FaceId> written, std::span<const CrossingFaces> crossings);
    void remember(std::span<const FaceId> faces);

    const SimplexMesh& m_mesh;
    const Progress* m_progress;
    FaceGrid m_grid;
    std::vector<glm::dvec3> m_safe; ///< for each vertex, its position when there was no new pair
    std::vector<VertexId> m_moved; ///< since keepApart(), each once
    std::vector<bool> m_isMoved; ///< for each vertex, whether it is in m_moved
    std::set<CrossingFaces> m_known; ///< pairs that the surface had before
};

} // namespace core
