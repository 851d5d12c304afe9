// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// A volume divided into cells of several voxels, each of which is represented by one voxel in its
/// middle. Cells are numbered x fastest, then y, then z, from the volume's first voxel on; the last
/// ones along an axis may be cut off by its end.
struct CoarseGrid {
    glm::ivec3 volumeSize{0}; ///< voxels
    glm::ivec3 cell{1}; ///< voxels of a cell along each axis

    /// The finest grid of at most @p mostCells cells, with cells about as long along all axes.
    [[nodiscard]] static CoarseGrid of(
        const glm::ivec3& volumeSize, const glm::dvec3& spacingMm, std::int64_t mostCells);

    [[nodiscard]] glm::ivec3 size() const { return (volumeSize + cell - 1) / cell; }
    [[nodiscard]] std::size_t cellCount() const;
    /// Whether every voxel is a cell of its own.
    [[nodiscard]] bool isExact() const { return cell == glm::ivec3(1); }
    [[nodiscard]] std::size_t numberOf(const glm::ivec3& place) const
    {
        const glm::ivec3 cells = size();
        return (std::size_t(place.z) * std::size_t(cells.y) + std::size_t(place.y))
            * std::size_t(cells.x)
            + std::size_t(place.x);
    }
    /// The voxel that represents a cell.
    [[nodiscard]] glm::ivec3 sampleOf(const glm::ivec3& place) const
    {
        return glm::min(place * cell + cell / 2, volumeSize - 1);
    }
    /// The number of voxels of the volume in a cell.
    [[nodiscard]] std::int64_t voxelsIn(const glm::ivec3& place) const;
};

/// The codes of the voxels that represent the cells of a volume.
class CoarseCodes {
public:
    explicit CoarseCodes(const CoarseGrid& grid);

    /// Takes a layer of cells from the slice of voxels that represents it (sampleOf().z).
    /// @param slice codes of the whole slice, x fastest
    void takeSlice(int layer, std::span<const std::uint16_t> slice);

    [[nodiscard]] const CoarseGrid& grid() const { return m_grid; }
    /// By cell; 0 in layers that were not taken.
    [[nodiscard]] const std::vector<std::uint16_t>& codes() const { return m_codes; }

private:
    CoarseGrid m_grid;
    std::vector<std::uint16_t> m_codes;
};

} // namespace core
