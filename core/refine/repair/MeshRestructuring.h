// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMeshEdit.h"

#include <span>

namespace core {

class CrossingGuard;

/// When the structure of a mesh is changed to fit its shape (seed B §6.4).
struct RestructuringSettings {
    double areaMm2 = 0.0; ///< intended area of a face where the surface is flat
    double finest = 0.25; ///< share of it that is intended where the surface is curved most
    double leastShare = 0.35; ///< of the intended area: smaller faces are merged
    double greatestShare = 2.2; ///< of the intended area: larger faces are split
    double greatestElongation = 2.6; ///< longer faces are split, or merged if they are small
};

/// What restructure() did.
struct Restructured {
    int welded = 0; ///< joined faces that were oriented away from each other
    int merged = 0;
    int split = 0;
    int swapped = 0;
    /// Vertices that are new or have other neighbours or faces, with all vertices of their faces;
    /// ascending.
    std::vector<VertexId> vertices;

    [[nodiscard]] bool empty() const { return welded + merged + split + swapped == 0; }
};

/// Examines every face of these vertices once and makes the changes that the settings ask for.
/// First, neighbours whose fitted planes are oriented away from each other are joined. Then small
/// faces are merged, large and long ones split, and edges swapped where that evens out the number
/// of vertices per face. The mesh stays closed, manifold and of the same genus. Faces with a green
/// vertex are not changed.
/// @param guard refuses each change that would let the surface pass through itself; its keepApart()
/// must have been called after vertices moved; null: no change is refused
Restructured restructure(SimplexMeshEdit& edit, std::span<const VertexId> around,
    const RestructuringSettings& settings, CrossingGuard* guard = nullptr);

/// The limits beyond which a face counts as stretched.
struct StretchLimits {
    double areaMm2 = 0.0; ///< greatest area of a face
    double edgeMm = 0.0;
};
/// Splits the stretched faces at these vertices through their longest edges, and then the resulting
/// faces, until no stretched face is left that can be split. No vertex moves, and green faces are
/// not changed.
/// @param guard as for restructure()
/// @return the number of splits
int splitStretched(SimplexMeshEdit& edit, std::span<const VertexId> around,
    const StretchLimits& limits, CrossingGuard* guard = nullptr);

/// The mean area of a mesh's faces.
[[nodiscard]] double meanFaceAreaMm2(const SimplexMesh& mesh);

} // namespace core
