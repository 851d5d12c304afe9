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

/// The faces of a mesh in a spatial grid that is kept up to date face by face. It finds faces that
/// pass through each other, exactly as SelfIntersections.h does, at a cost ∝ the faces asked about.
class FaceGrid {
public:
    /// @param mesh, geometry must outlive this. Cost ∝ the faces.
    /// @param progress once it is cancelled, no pairs are searched; null: it is never cancelled;
    /// must outlive this
    FaceGrid(const SimplexMesh& mesh, const VolumeGeometry& geometry,
        const Progress* progress = nullptr);

    /// Must be called for faces whose vertices moved or changed, and for those that were added or
    /// removed.
    void refresh(std::span<const FaceId> faces);

    /// The pairs of faces that pass through each other, at least one of them in @p faces.
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
    /// Chooses the width of the cells for the present faces, and enters all of them.
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
    int m_cellBits = 0; ///< cells are 2 to the power of this wide
    /// A face in a cell, and the index of the next entry there.
    struct Entry {
        FaceId face = noId;
        std::uint32_t next = noEntry;
    };
    static constexpr std::uint32_t noEntry = ~std::uint32_t(0);
    std::vector<Entry> m_entries;
    std::uint32_t m_free = noEntry; ///< first entry that is not in use
    std::size_t m_mostEntries = 0; ///< with more entries than this, the cells are too narrow
    /// The first entry by a hash of the cell; entries of several cells may follow each other.
    std::vector<std::uint32_t> m_firsts;
    std::vector<std::uint64_t> m_asked; ///< for each face, the number of the last question about it
    std::uint64_t m_question = 0;
};

} // namespace core
