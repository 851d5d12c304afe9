// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace core {

/// From the voxels of a repaired volume back to the slices of its images.
///
/// A voxel of a slice takes what the nearest voxel of the repaired volume holds: since rows and
/// columns are the same this is one step in whole voxels for every slice (LatticePlace::nearest()),
/// at most half a voxel from the true place. Every voxel of every slice has one; what was drawn on
/// slices that were filled in, or beside what was scanned, has no place in any image.
class WayBack {
public:
    /// None where the voxels of @p volume lie on the slices of its images.
    [[nodiscard]] static std::optional<WayBack> of(const Volume& volume);

    /// The volume of the images' slices: their grid and sources, whose they are, and still by name
    /// how the series was repaired.
    [[nodiscard]] const Volume& slices() const { return m_slices; }

    /// Labels of the repaired volume (x fastest) on the grid of slices().
    [[nodiscard]] std::vector<std::uint8_t> labels(std::span<const std::uint8_t> repaired) const;

    /// Per slice of slices(): which voxel of the repaired volume is nearest to its first voxel.
    [[nodiscard]] const std::vector<glm::ivec3>& firstVoxels() const { return m_firstVoxels; }

private:
    explicit WayBack(const Volume& volume);

    glm::ivec3 m_repairedSize{0};
    Volume m_slices;
    std::vector<glm::ivec3> m_firstVoxels;
};

} // namespace core
