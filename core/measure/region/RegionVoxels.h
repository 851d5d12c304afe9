// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/document/Measurement.h"
#include "core/measure/PlaneShape.h"
#include "core/volume/VolumeGeometry.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace core {

/// Decides which voxels belong to a region or a probe.
///
/// - Ball: the voxels whose centres lie within its radius, at their true places.
/// - Region in a slice along the grid: the voxels of the nearest slice whose centres lie in the
///   region, as that slice is shown.
/// - Region in any other plane: samples of that plane, on a square grid around the middle of the
///   region, spaced like voxels along their finest axis. Each sample inside the region and the
///   volume counts once, with the value of the nearest voxel. If there would be more than
///   `mostSamples`, they are spaced wider.
/// - Probe: the nearest voxel.
///
/// A centre on the border is inside. Nothing outside the volume counts.
class RegionVoxels {
public:
    static constexpr int mostSamples = 1 << 20;
    /// Boxes are split, so that frames can be drawn between the reads.
    static constexpr int mostVoxelsOfBox = 1 << 20;

    /// @param measurement a region or a probe; any other holds no voxels
    RegionVoxels(const Measurement& measurement, const VolumeGeometry& geometry);

    /// Boxes to be read, in the order of slices; empty if there are samples or nothing to read.
    [[nodiscard]] const std::vector<VoxelBox>& boxes() const { return m_boxes; }
    /// Voxels to be read one by one; a voxel may occur several times.
    [[nodiscard]] const std::vector<glm::ivec3>& samples() const { return m_samples; }
    /// Whether a voxel of a box belongs to the region.
    [[nodiscard]] bool contains(const glm::ivec3& voxel) const;
    /// The codes of those voxels of a box that belong to the region.
    /// @param codes one for each voxel of the box, x fastest
    [[nodiscard]] std::vector<std::uint16_t> codesInside(
        const VoxelBox& box, std::span<const std::uint16_t> codes) const;

private:
    void takeBall();
    void takeSlice(int axis, double place);
    void takeSamples();
    void takeBox(VoxelBox box);

    VolumeGeometry m_geometry;
    std::optional<PlaneShape> m_shape;
    int m_axis = -1; ///< for a region in a slice along the grid, the index axis across that slice
    double m_place = 0.0; ///< position of that region along this axis, in voxels
    glm::dvec3 m_centreLps{0.0}; ///< true centre of a ball
    double m_radiusMm = 0.0;
    std::vector<VoxelBox> m_boxes;
    std::vector<glm::ivec3> m_samples;
};

} // namespace core
