// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMeshEdit.h"

#include <vector>

namespace core {

/// What has to be drawn anew of a surface, by the ids of its mesh. A value: it goes from the thread
/// that deforms to the one that draws, which keeps all the rest as it was told before.
struct SurfaceUpdate {
    struct Vertex {
        VertexId id = noId;
        glm::dvec3 positionLps{0.0}; ///< world, mm
        glm::dvec3 normalLps{0.0}; ///< outwards, of length 1; 0 where its neighbours lie in a line
        SurfaceMark mark = SurfaceMark::Yellow;
    };
    struct Face {
        FaceId id = noId;
        FaceRing ring; ///< empty: it is gone
    };
    bool isWhole = false; ///< forget what was told before
    std::vector<Vertex> vertices; ///< ids ascend; those that are gone are in no ring
    std::vector<Face> faces; ///< ids ascend
};

/// All of a mesh. Empty lists for an empty mesh: nothing is to be drawn.
[[nodiscard]] SurfaceUpdate wholeUpdate(const SimplexMesh& mesh);
/// What was written, and the vertices around that have another normal for it.
[[nodiscard]] SurfaceUpdate updateOf(const SimplexMesh& mesh, const WrittenParts& written);

} // namespace core
