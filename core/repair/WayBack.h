// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace core {

/// Transfers labels from a repaired volume back to the slices of its original images.
///
/// A voxel of a slice gets the label of the nearest voxel of the repaired volume. Since rows and
/// columns are the same, this is one offset in whole voxels for every slice
/// (LatticePlace::nearest()), at most half a voxel from the true position. Every voxel of every
/// slice gets a label; what was drawn on interpolated slices or outside the scanned region has no
/// place in any image.
class WayBack {
public:
    /// None if the voxels of @p volume lie on the slices of its images.
    [[nodiscard]] static std::optional<WayBack> of(const Volume& volume);

    /// The volume of the original slices: their grid, sources and identity, and as repair what of
    /// it moved voxels (repairMade()).
    [[nodiscard]] const Volume& slices() const { return m_slices; }

    /// Converts labels of the repaired volume (x fastest) to the grid of slices().
    [[nodiscard]] std::vector<std::uint8_t> labels(std::span<const std::uint8_t> repaired) const;

    /// Per slice of slices(): the voxel of the repaired volume that is nearest to its first voxel.
    [[nodiscard]] const std::vector<glm::ivec3>& firstVoxels() const { return m_firstVoxels; }

private:
    explicit WayBack(const Volume& volume);

    glm::ivec3 m_repairedSize{0};
    Volume m_slices;
    std::vector<glm::ivec3> m_firstVoxels;
};

} // namespace core
