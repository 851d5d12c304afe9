// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMeshDelta.h"

namespace core {

/// What was written of a mesh, each once, ascending; some of it may be gone by now. For whoever
/// draws it: what is drawn of anything else is still right.
struct WrittenParts {
    std::vector<VertexId> vertices;
    std::vector<FaceId> faces;
};

/// The one door through which a mesh is written: an open transaction that saves each vertex and
/// face on first touch. It ends with commit() or rollback(); left without either, it is rolled
/// back.
///
/// Green vertices are immutable here, below every tool: who is to change one marks it otherwise
/// first.
class SimplexMeshEdit {
public:
    /// @param mesh must outlive it, and is written by nobody else meanwhile
    explicit SimplexMeshEdit(SimplexMesh& mesh);
    ~SimplexMeshEdit();
    SimplexMeshEdit(const SimplexMeshEdit&) = delete;
    SimplexMeshEdit& operator=(const SimplexMeshEdit&) = delete;

    [[nodiscard]] const SimplexMesh& mesh() const { return m_mesh; }

    /// A green vertex stays where it is.
    void move(VertexId id, const glm::dvec3& positionLps);
    void setMark(VertexId id, SurfaceMark mark);

    // The structure, for SimplexOperations.h: in between, the mesh is none.
    VertexId addVertex(const SimplexVertex& vertex);
    void removeVertex(VertexId id);
    /// Neighbours and faces; position and mark stay.
    void link(
        VertexId id, const std::array<VertexId, 3>& neighbours, const std::array<FaceId, 3>& faces);
    FaceId addFace(FaceRing ring);
    void setRing(FaceId id, FaceRing ring);
    void removeFace(FaceId id);

    /// What was written since it was last asked, or since the beginning.
    [[nodiscard]] WrittenParts takeWritten();

    /// The changes; what is as it was before is left out. Nothing may be written afterwards.
    SimplexMeshDelta commit();
    void rollback();

private:
    void touchVertex(VertexId id);
    void touchFace(FaceId id);
    [[nodiscard]] SimplexMeshDelta changes();

    SimplexMesh& m_mesh;
    bool m_isOpen = true;
    std::vector<bool> m_touched; ///< by vertex
    std::vector<bool> m_touchedFaces;
    SimplexMeshDelta m_before; ///< in the order of touching, `after` unset
    std::vector<bool> m_isWritten; ///< by vertex, since takeWritten()
    std::vector<bool> m_isFaceWritten;
    WrittenParts m_written; ///< in the order of writing
};

} // namespace core
