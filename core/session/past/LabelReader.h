// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"
#include "core/growth/coarse/CoarseGrid.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

struct EngineResult;
struct ReadBricks;

/// Where the voxels of a label lie.
struct LabelPlace {
    VoxelBox box; ///< smallest box that contains all of them
    /// The voxel of the label that is nearest to the middle of the box, measured in voxels.
    glm::ivec3 middle{0};
};

/// Reads one label plane, or the coverage of one layer, from the engine in portions, so that other
/// work can be done in between. A portion has 4 MiB; where little was in the ones before, it covers
/// more bricks, because each of them waits for its turn (32 MiB if it then meets a full region).
/// Send next() to the engine and pass the result to take() until next() returns none; then let a
/// worker assemble the bricks with takeLabels().
class LabelReader {
public:
    /// @param field Labels or Coverage
    LabelReader(const glm::ivec3& size, std::uint8_t plane, Field field = Field::Labels);

    [[nodiscard]] std::optional<ReadBricks> next();
    /// Keeps the bricks without reading their voxels.
    [[nodiscard]] Result<void> take(const EngineResult& answer);

    [[nodiscard]] int bricksRead() const { return m_next; }
    [[nodiscard]] int bricks() const { return m_grid.brickCount(); }
    [[nodiscard]] std::uint8_t plane() const { return m_plane; }
    /// Where a label (1 or more) lies, in what was read so far; none: it has no voxels. Any thread.
    /// Cost ∝ the bricks that are not empty.
    [[nodiscard]] std::optional<LabelPlace> placeOf(std::uint8_t label) const;
    /// How many voxels have a label from 1 on, in what was read. Any thread. Cost as of placeOf().
    [[nodiscard]] std::int64_t voxelsOf(std::uint8_t label) const;
    /// The labels of the voxels that represent the cells of a grid of the same volume, in what was
    /// read; empty: all 0. Any thread. Cost ∝ the cells in bricks that are not empty.
    [[nodiscard]] std::vector<std::uint8_t> sampled(const CoarseGrid& grid) const;
    /// The labels, x fastest; the reader is empty afterwards. Any thread. Cost ∝ the volume.
    [[nodiscard]] std::vector<std::uint8_t> takeLabels();

private:
    void place(const BrickImage& brick, std::vector<std::uint8_t>& labels) const;

    BrickGrid m_grid;
    std::uint8_t m_plane;
    Field m_field;
    int m_next = 0;
    int m_portion; ///< bricks
    std::vector<BrickImage> m_bricks; ///< those that are not empty
};

} // namespace core
