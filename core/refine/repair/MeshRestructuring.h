// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMeshEdit.h"

#include <span>

namespace core {

/// When the structure of a mesh is changed to suit its shape (seed B §6.4).
struct RestructuringSettings {
    double areaMm2 = 0.0; ///< that a face is to have where the surface is flat
    double finest = 0.25; ///< share of it that is wanted where the surface is bent most
    double leastShare = 0.35; ///< of the wanted area: smaller faces are merged
    double greatestShare = 2.2; ///< of the wanted area: larger faces are split
    double greatestElongation = 2.6; ///< longer faces are split, or merged if they are small
};

/// What was done.
struct Restructured {
    int welded = 0; ///< faces joined that looked away from each other
    int merged = 0;
    int split = 0;
    int swapped = 0;
    /// Those that have other neighbours or faces now, or are new, with all of their faces'
    /// vertices; ascending.
    std::vector<VertexId> vertices;

    [[nodiscard]] bool empty() const { return welded + merged + split + swapped == 0; }
};

/// Looks once at every face of these vertices and changes what the settings ask for: first
/// neighbours whose fitted planes look away from each other are joined, then small faces are
/// merged, large and long ones split, and edges swapped where that evens the number of vertices of
/// faces. The mesh stays closed and manifold, of its genus; faces with a green vertex stay as they
/// are.
Restructured restructure(
    SimplexMeshEdit& edit, std::span<const VertexId> around, const RestructuringSettings& settings);

/// The mean area of a mesh's faces.
[[nodiscard]] double meanFaceAreaMm2(const SimplexMesh& mesh);

} // namespace core
