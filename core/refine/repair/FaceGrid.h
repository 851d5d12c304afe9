// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMesh.h"
#include "core/refine/repair/SelfIntersections.h"
#include "core/refine/repair/TriangleCrossing.h"
#include "core/volume/WorldToIndex.h"

#include <span>
#include <vector>

namespace core {

/// The faces of a mesh in a spatial grid that is kept up to date face by face, to find those that
/// pass through each other exactly as SelfIntersections.h does, at a cost ∝ the faces asked about.
class FaceGrid {
public:
    /// @param mesh, geometry must outlive this. Cost ∝ the faces.
    FaceGrid(const SimplexMesh& mesh, const VolumeGeometry& geometry);

    /// To be called for faces whose vertices moved or changed, or that were made or removed.
    void refresh(std::span<const FaceId> faces);

    /// The pairs that pass through each other of which at least one is among @p faces.
    /// @param faces ascending, each once
    [[nodiscard]] std::vector<CrossingFaces> crossingsOf(std::span<const FaceId> faces) const;

private:
    struct Box {
        glm::ivec3 low{0};
        glm::ivec3 high{-1}; ///< below low: the face is not in the grid
        [[nodiscard]] bool empty() const { return high.x < low.x; }
    };
    using Fan = std::vector<LatticeTriangle>; ///< the triangles of a face

    [[nodiscard]] glm::ivec3 cellOf(const glm::ivec3& place) const;
    [[nodiscard]] std::vector<FaceId>& bucketOf(const glm::ivec3& cell);
    [[nodiscard]] const std::vector<FaceId>& bucketOf(const glm::ivec3& cell) const;
    [[nodiscard]] std::size_t placeOf(const glm::ivec3& cell) const;
    void enter(FaceId face);
    void leave(FaceId face);
    void measure(FaceId face);
    void fanOf(FaceId face, Fan& fan) const;
    void lookAround(FaceId face, const std::vector<bool>& isAsked, std::vector<FaceId>& near,
        std::array<Fan, 2>& fans, std::vector<CrossingFaces>& found) const;
    [[nodiscard]] static bool cross(const Fan& one, const Fan& other);
    [[nodiscard]] static bool crossesItself(const Fan& fan);

    const SimplexMesh& m_mesh;
    WorldToIndex m_toIndex;
    std::vector<glm::ivec3> m_points; ///< by vertex
    std::vector<glm::ivec3> m_middles; ///< by face
    std::vector<Box> m_boxes; ///< by face
    std::int32_t m_cell = 1; ///< width of a cell
    /// By a hash of the cell, so that faces of several cells may share one.
    std::vector<std::vector<FaceId>> m_buckets;
};

} // namespace core
