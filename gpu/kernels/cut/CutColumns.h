// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/sculpt/CutFrame.h"
#include "gpu/fields/bricks/PlaneBricks.h"
#include "gpu/gl/Buffer.h"

#include <map>
#include <set>
#include <vector>

namespace gpu {

/// The columns of a mask plane: what each of its elements cuts (core::CutColumn). Stored in tiles
/// of 16 × 16 elements on the processor and mirrored on the GPU. Only elements over the volume are
/// stored, since the others meet no voxel. Engine thread only.
class CutColumns {
public:
    static constexpr int tileSide = 16;

    CutColumns(const core::CutFrame& frame, const core::BrickGrid& grid);

    /// The box of elements that can be stored.
    [[nodiscard]] const core::ElementBox& room() const { return m_room; }
    [[nodiscard]] glm::ivec2 firstTile() const { return m_firstTile; }
    [[nodiscard]] glm::ivec2 tileCount() const { return m_tileCount; }

    /// Sets a column; the element lies within room().
    void set(const glm::ivec2& element, const core::CutColumn& column);
    /// Forgets every column.
    void clear();
    /// The places where columns were set since the last call, one box per tile: voxels there may
    /// change.
    [[nodiscard]] std::vector<PlaneBox> takeChanged();

    /// Binds the tile slots and the columns as storage buffers, after bringing them up to date.
    void bind(unsigned slotsBinding, unsigned columnsBinding);

private:
    using TileKey = std::pair<int, int>;
    struct Tile {
        std::vector<core::CutColumn> columns;
        std::uint32_t slot = 0;
    };
    void mirror();

    std::int32_t m_pitch = 0;
    std::int32_t m_rampHalfWidth = 0;
    core::ElementBox m_room;
    glm::ivec2 m_firstTile{0};
    glm::ivec2 m_tileCount{0};
    std::map<TileKey, Tile> m_tiles;
    std::map<TileKey, PlaneBox> m_changed;
    std::set<TileKey> m_stale;
    Buffer m_tileSlots;
    Buffer m_columns;
    std::uint32_t m_slots = 0;
};

} // namespace gpu
