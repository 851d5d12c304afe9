// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/volume/VolumeGeometry.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace core {

/// Where the pixels of a slice lie, and which voxels they show. In a slice along the grid the
/// pixels are its voxels. In an oblique slice they are spaced like voxels along the finest axis,
/// and each shows the nearest voxel; outside the volume, that is a voxel at its border.
///
/// It only helps a user to draw; which voxels an outline fills is decided by the edit alone.
struct SliceLattice {
    glm::ivec2 size{0}; ///< columns and rows; 0: the plane misses the volume
    glm::dvec3 originLps{0.0}; ///< centre of pixel (0, 0)
    glm::dvec3 columnLps{1.0, 0.0, 0.0}; ///< step from a pixel to the next one in its row
    glm::dvec3 rowLps{0.0, 1.0, 0.0}; ///< step from a pixel to the next one in its column
    /// The voxels in the order of the pixels; none: the slice is oblique (nearestVoxels()).
    std::optional<VoxelBox> box{};

    /// The greatest number of pixels of an oblique slice; if there would be more, they are spaced
    /// wider.
    static constexpr int mostObliquePixels = 1 << 20;

    [[nodiscard]] bool empty() const { return size.x <= 0 || size.y <= 0; }
    /// Whether both have the same pixels, which show the same voxels.
    [[nodiscard]] bool isAt(const SliceLattice& other) const;
    /// The place of a corner of pixels. Corner (x, y) lies half a pixel before the centre of pixel
    /// (x, y) in both directions.
    [[nodiscard]] glm::dvec3 cornerLps(const glm::ivec2& corner) const;
    /// The corner nearest to a place, 0 … size. The distance of the place from the slice does not
    /// matter.
    [[nodiscard]] glm::ivec2 cornerAt(const glm::dvec3& placeLps) const;
    /// The pixel that contains a place; none: it lies outside the slice.
    [[nodiscard]] std::optional<glm::ivec2> pixelAt(const glm::dvec3& placeLps) const;

private:
    /// The place in pixels; whole numbers are centres of pixels.
    [[nodiscard]] glm::dvec2 inPixels(const glm::dvec3& placeLps) const;
};

/// The slice through a point; slicePlane() (core/edits/engine/SlicePlane.h) decides whether it lies
/// along the grid.
/// @param rightLps, downLps unit vectors in the slice, perpendicular to each other
[[nodiscard]] SliceLattice sliceLattice(const VolumeGeometry& geometry,
    const glm::dvec3& throughLps, const glm::dvec3& rightLps, const glm::dvec3& downLps);

/// The voxel that each pixel of an oblique slice shows, in the order of the pixels.
[[nodiscard]] std::vector<glm::ivec3> nearestVoxels(
    const SliceLattice& lattice, const VolumeGeometry& geometry);

} // namespace core
