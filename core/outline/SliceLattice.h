// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/volume/VolumeGeometry.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace core {

/// Where the pixels of a slice lie, and which voxels they show. In a slice along the grid they are
/// its voxels. In an oblique one they lie as densely as voxels do where they are densest, and each
/// shows the nearest voxel; beside the volume that is one at its border.
///
/// It helps a hand to draw; which voxels an outline fills is a matter of the edit alone.
struct SliceLattice {
    glm::ivec2 size{0}; ///< columns, rows; 0: the plane misses the volume
    glm::dvec3 originLps{0.0}; ///< centre of pixel (0, 0)
    glm::dvec3 columnLps{1.0, 0.0, 0.0}; ///< from a pixel to the next one of its row
    glm::dvec3 rowLps{0.0, 1.0, 0.0}; ///< from a pixel to the next one of its column
    /// The voxels, in the order of the pixels; none: the slice is oblique (nearestVoxels()).
    std::optional<VoxelBox> box{};

    /// An oblique slice has no more pixels than this; they lie less densely if need be.
    static constexpr int mostObliquePixels = 1 << 20;

    [[nodiscard]] bool empty() const { return size.x <= 0 || size.y <= 0; }
    /// Whether the pixels of both show the same voxels.
    [[nodiscard]] bool isAt(const SliceLattice& other) const;
    /// A corner of pixels: half a pixel before the centre of pixel (x, y) in both directions.
    [[nodiscard]] glm::dvec3 cornerLps(const glm::ivec2& corner) const;
    /// The nearest corner, 0 … size. What a place has across the slice does not count.
    [[nodiscard]] glm::ivec2 cornerAt(const glm::dvec3& placeLps) const;
    /// The pixel that covers the place; none: it lies beside them.
    [[nodiscard]] std::optional<glm::ivec2> pixelAt(const glm::dvec3& placeLps) const;

private:
    /// In pixels; whole numbers at centres.
    [[nodiscard]] glm::dvec2 inPixels(const glm::dvec3& placeLps) const;
};

/// The slice through a point, with the rule of core/edits/engine/SlicePlane.h for those that lie
/// along the grid.
/// @param rightLps, downLps unit vectors in the slice, perpendicular to each other
[[nodiscard]] SliceLattice sliceLattice(const VolumeGeometry& geometry,
    const glm::dvec3& throughLps, const glm::dvec3& rightLps, const glm::dvec3& downLps);

/// The voxels of the pixels of an oblique slice, in their order.
[[nodiscard]] std::vector<glm::ivec3> nearestVoxels(
    const SliceLattice& lattice, const VolumeGeometry& geometry);

} // namespace core
