// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMeshEdit.h"

#include <vector>

namespace core {

/// What must be drawn anew of a surface, by the ids of its mesh. A value that goes from the thread
/// that deforms to the one that draws, which keeps everything else.
struct SurfaceUpdate {
    struct Vertex {
        VertexId id = noId;
        glm::dvec3 positionLps{0.0}; ///< world, mm
        glm::dvec3 normalLps{0.0}; ///< outwards, of length 1; 0 if its neighbours lie in a line
        SurfaceMark mark = SurfaceMark::Yellow;
    };
    struct Face {
        FaceId id = noId;
        FaceRing ring; ///< empty: it was removed
    };
    bool isWhole = false; ///< discard everything received before
    std::vector<Vertex> vertices; ///< ids ascend; removed vertices are in no ring
    std::vector<Face> faces; ///< ids ascend
};

/// The whole mesh. An empty mesh gives empty lists: nothing is to be drawn.
[[nodiscard]] SurfaceUpdate wholeUpdate(const SimplexMesh& mesh);
/// What was written, and the vertices next to it whose normals changed because of it.
[[nodiscard]] SurfaceUpdate updateOf(const SimplexMesh& mesh, const WrittenParts& written);

} // namespace core
