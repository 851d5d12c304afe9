// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMesh.h"
#include "core/refine/repair/CrossingFaces.h"
#include "core/refine/repair/FaceFan.h"
#include "core/volume/WorldToIndex.h"

#include <span>
#include <vector>

namespace core {

class Progress;

/// The faces of a mesh in a spatial grid that is kept up to date face by face, to find those that
/// pass through each other exactly as SelfIntersections.h does, at a cost ∝ the faces asked about.
class FaceGrid {
public:
    /// @param mesh, geometry must outlive this. Cost ∝ the faces.
    /// @param progress once it is cancelled no pairs are looked for; null: it never is; must
    /// outlive this
    FaceGrid(const SimplexMesh& mesh, const VolumeGeometry& geometry,
        const Progress* progress = nullptr);

    /// To be called for faces whose vertices moved or changed, or that were made or removed.
    void refresh(std::span<const FaceId> faces);

    /// The pairs that pass through each other of which at least one is among @p faces.
    /// @param faces ascending, each once
    [[nodiscard]] std::vector<CrossingFaces> crossingsOf(std::span<const FaceId> faces);

private:
    [[nodiscard]] glm::ivec3 cellOf(const glm::ivec3& place) const;
    [[nodiscard]] std::uint32_t& firstOf(const glm::ivec3& cell);
    [[nodiscard]] std::size_t placeOf(const glm::ivec3& cell) const;
    template <typename Work> void forEachCell(const FaceBox& box, const Work& work) const
    {
        const glm::ivec3 low = cellOf(box.low);
        const glm::ivec3 high = cellOf(box.high);
        for (int z = low.z; z <= high.z; ++z) {
            for (int y = low.y; y <= high.y; ++y) {
                for (int x = low.x; x <= high.x; ++x)
                    work(glm::ivec3(x, y, z));
            }
        }
    }
    /// Chooses the width of a cell for the faces as they are, and enters them.
    void build();
    void enter(FaceId face);
    void leave(FaceId face);
    void place(VertexId id);
    void measure(FaceId face);
    [[nodiscard]] FaceFan fanOf(FaceId face) const;
    void lookAround(FaceId face, std::vector<CrossingFaces>& found) const;
    [[nodiscard]] bool isAsked(FaceId face) const { return m_asked[face] == m_question; }

    const SimplexMesh& m_mesh;
    const Progress* m_progress;
    WorldToIndex m_toIndex;
    std::vector<glm::ivec3> m_points; ///< by vertex
    std::vector<glm::ivec3> m_middles; ///< by face
    std::vector<FaceBox> m_boxes; ///< by face
    int m_cellBits = 0; ///< of the width of a cell
    /// A face in a cell, and the place of the next one there.
    struct Entry {
        FaceId face = noId;
        std::uint32_t next = noEntry;
    };
    static constexpr std::uint32_t noEntry = ~std::uint32_t(0);
    std::vector<Entry> m_entries;
    std::uint32_t m_free = noEntry; ///< the first that is not used
    std::size_t m_mostEntries = 0; ///< of more than these the cells are too narrow
    /// The first by a hash of the cell, so that entries of several cells may follow each other.
    std::vector<std::uint32_t> m_firsts;
    std::vector<std::uint64_t> m_asked; ///< by face: the last question that was about it
    std::uint64_t m_question = 0;
};

} // namespace core
