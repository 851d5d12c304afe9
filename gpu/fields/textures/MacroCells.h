// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "gpu/gl/Program.h"
#include "gpu/gl/Texture3D.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace gpu {

/// The codes that a picture shows, as inclusive ascending intervals. Voxels with other codes are
/// invisible.
struct VisibleCodes {
    struct Interval {
        int lowest = 0;
        int highest = 65535;
        bool operator==(const Interval&) const = default;
    };
    std::vector<Interval> intervals;
    bool operator==(const VisibleCodes&) const = default;
};

/// Cells of 8³ voxels with their range of codes and of derived fields, for empty-space skipping.
/// Cell c is valid for samples at index positions in [8c, 8c + 8) on each axis. It covers the
/// voxels 8c … 8c + 8, since interpolation reads one voxel further. Engine thread.
class MacroCells {
public:
    static constexpr int side = 8;
    // Bits of the second channel of the skip map; raycast.glsl uses the same values.
    /// Holds shown codes that are not all carved away.
    static constexpr std::uint8_t tissueFlag = 1;
    static constexpr std::uint8_t carvedFlag = 2; ///< radiation reaches 0.5
    static constexpr std::uint8_t segmentFlag = 4; ///< the segmentation map reaches 0.5
    static constexpr std::uint8_t shownFlag = 8; ///< holds shown codes, carved away or not

    MacroCells() = default;
    MacroCells(const glm::ivec3& volumeSize, std::span<const std::uint16_t> codes);

    [[nodiscard]] glm::ivec3 cells() const { return m_cells; }
    [[nodiscard]] int greatestCode() const { return m_greatestCode; } ///< in the whole volume
    /// Whether anything is carved away or a segment is shown anywhere.
    [[nodiscard]] bool isSculpted() const
    {
        return !m_carvedCells.empty() || !m_segmentCells.empty();
    }
    /// Cells in which something is carved away.
    [[nodiscard]] const std::vector<glm::ivec3>& carvedCells() const { return m_carvedCells; }
    /// Cells that hold a part of a shown segment.
    [[nodiscard]] const std::vector<glm::ivec3>& segmentCells() const { return m_segmentCells; }
    /// Whether a brick may hold a voxel with one of these codes, both ends included. It says no
    /// only if there is none; codes beyond the brick by one voxel count as its own.
    [[nodiscard]] bool mayHold(const glm::ivec3& brick, int lowest, int highest) const;
    /// RG16: least and greatest code of each cell.
    [[nodiscard]] const Texture3D& ranges() const { return m_ranges; }

    /// Updates the cells that depend on these voxels of radiation or segmentation map.
    /// @param kernel fields/textures/macroCells.comp
    /// Waits for the GPU if the box is not empty.
    void update(Program& kernel, const Texture3D& radiation, const Texture3D& segmentation,
        const core::VoxelBox& dirty);

    /// RG8UI: the Chebyshev distance, in cells, to the nearest cell with tissue or segments, and
    /// the flags. It is recomputed only when something has changed.
    [[nodiscard]] const Texture3D& skipMap(const VisibleCodes& visible);

    [[nodiscard]] static glm::ivec3 cellsFor(const glm::ivec3& volumeSize);
    [[nodiscard]] static std::size_t bytesFor(const glm::ivec3& volumeSize); ///< of GPU memory

private:
    struct Range {
        std::uint16_t lowest = 0xFFFF;
        std::uint16_t highest = 0;
    };
    /// What the kernel reports: least and greatest radiation, greatest segmentation.
    struct Sculpt {
        std::uint8_t leastRadiation = 0;
        std::uint8_t greatestRadiation = 0;
        std::uint8_t greatestSegmentation = 0;
    };
    void accumulateRow(std::span<const std::uint16_t> row, int y, int z);
    void widen(int x, int y, int z, const Range& range);

    glm::ivec3 m_cells{0};
    int m_greatestCode = 0;
    std::vector<Range> m_codes;
    std::vector<Sculpt> m_sculpt;
    Texture3D m_ranges;
    Texture3D m_skipMap;
    VisibleCodes m_visible; ///< the codes for which m_skipMap was computed
    bool m_skipMapValid = false;
    std::vector<glm::ivec3> m_carvedCells;
    std::vector<glm::ivec3> m_segmentCells;
};

} // namespace gpu
