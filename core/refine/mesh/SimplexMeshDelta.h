// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMesh.h"

namespace core {

/// What changed in a mesh: every changed vertex and face, before and after. Applying it in either
/// direction is exact bit by bit.
struct SimplexMeshDelta {
    struct VertexChange {
        VertexId id = noId;
        std::optional<SimplexVertex> before; ///< none: it did not exist
        std::optional<SimplexVertex> after; ///< none: it was removed
    };
    struct FaceChange {
        FaceId id = noId;
        FaceRing before; ///< empty: it did not exist
        FaceRing after; ///< empty: it was removed
    };
    std::vector<VertexChange> vertices; ///< ids ascend
    std::vector<FaceChange> faces; ///< ids ascend

    [[nodiscard]] bool empty() const { return vertices.empty() && faces.empty(); }
    /// @pre the mesh is as it was before the change
    void redo(SimplexMesh& mesh) const;
    /// @pre the mesh is as it was after the change
    void undo(SimplexMesh& mesh) const;
};

} // namespace core
