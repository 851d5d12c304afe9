// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMeshDelta.h"

namespace core {

/// The vertices and faces of a mesh that were written, each once, ascending; some may have been
/// removed since. For drawing: everything else is unchanged on the screen.
struct WrittenParts {
    std::vector<VertexId> vertices;
    std::vector<FaceId> faces;
};

/// A transaction on a mesh, and the only way to write one. It saves each vertex and face when it is
/// first written, and ends with commit() or rollback(); the destructor rolls back.
///
/// Green vertices cannot be moved, whatever the tool: they must be given another mark first.
class SimplexMeshEdit {
public:
    /// @param mesh must outlive this; nothing else may write it meanwhile
    explicit SimplexMeshEdit(SimplexMesh& mesh);
    ~SimplexMeshEdit();
    SimplexMeshEdit(const SimplexMeshEdit&) = delete;
    SimplexMeshEdit& operator=(const SimplexMeshEdit&) = delete;

    [[nodiscard]] const SimplexMesh& mesh() const { return m_mesh; }

    /// A green vertex is not moved.
    void move(VertexId id, const glm::dvec3& positionLps);
    void setMark(VertexId id, SurfaceMark mark);

    // Changes of structure, for SimplexOperations.h. Between these calls the mesh is inconsistent.
    VertexId addVertex(const SimplexVertex& vertex);
    void removeVertex(VertexId id);
    /// Sets neighbours and faces; position and mark stay.
    void link(
        VertexId id, const std::array<VertexId, 3>& neighbours, const std::array<FaceId, 3>& faces);
    FaceId addFace(FaceRing ring);
    void setRing(FaceId id, FaceRing ring);
    void removeFace(FaceId id);

    /// Begins a trial: everything that is written from here on can be reverted separately, until
    /// one of the two functions below is called. Meant for changes of a few vertices and faces.
    void beginTrial();
    /// The faces that were written in the trial, ascending; some may have been removed.
    [[nodiscard]] std::vector<FaceId> trialFaces() const;
    void keepTrial();
    void revertTrial();

    /// What was written since the last call, or since the beginning.
    [[nodiscard]] WrittenParts takeWritten();

    /// Ends the transaction and returns the changes, without what is as it was before. Nothing may
    /// be written afterwards.
    SimplexMeshDelta commit();
    void rollback();

private:
    void touchVertex(VertexId id);
    void touchFace(FaceId id);
    [[nodiscard]] SimplexMeshDelta::VertexChange asItIs(VertexId id) const;
    [[nodiscard]] SimplexMeshDelta changes();

    SimplexMesh& m_mesh;
    bool m_isOpen = true;
    std::vector<bool> m_touched; ///< by vertex
    std::vector<bool> m_touchedFaces;
    SimplexMeshDelta m_before; ///< in the order of first writing, `after` unset
    std::vector<bool> m_isWritten; ///< by vertex, since takeWritten()
    std::vector<bool> m_isFaceWritten;
    WrittenParts m_written; ///< in the order of writing
    /// The previous state of what was written in a trial; none: there is no trial.
    std::optional<SimplexMeshDelta> m_trial;
};

} // namespace core
