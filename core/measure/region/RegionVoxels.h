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

/// Which voxels a region or a probe holds.
///
/// - A ball: those whose centres lie within its radius, at their true places.
/// - A region in a slice along the grid: those of the nearest slice whose centres lie in it, as
///   that slice is seen.
/// - A region in any other plane: samples of that plane, as far apart in two directions as voxels
///   are where they are closest, around the middle of the region. Each that lies in the region and
///   in the volume counts once, with the value of the nearest voxel. More than `mostSamples` would
///   lie less densely.
/// - A probe: the nearest voxel.
///
/// A centre on the border lies inside. What lies outside of the volume does not count.
class RegionVoxels {
public:
    static constexpr int mostSamples = 1 << 20;
    static constexpr int mostVoxelsOfBox = 1 << 20; ///< so that frames come between their reads

    /// @param measurement a region or a probe; any other holds no voxels
    RegionVoxels(const Measurement& measurement, const VolumeGeometry& geometry);

    /// Boxes to be read, without gaps from slice to slice; empty if there are samples or nothing.
    [[nodiscard]] const std::vector<VoxelBox>& boxes() const { return m_boxes; }
    /// Voxels to be read one by one; some may be there several times.
    [[nodiscard]] const std::vector<glm::ivec3>& samples() const { return m_samples; }
    /// Whether a voxel of a box belongs to it.
    [[nodiscard]] bool contains(const glm::ivec3& voxel) const;
    /// The codes of the voxels of one of the boxes that belong to it.
    [[nodiscard]] std::vector<std::uint16_t> codesInside(
        const VoxelBox& box, std::span<const std::uint16_t> codes) const;

private:
    void takeBall();
    void takeSlice(int axis, double place);
    void takeSamples();
    void takeBox(VoxelBox box);

    VolumeGeometry m_geometry;
    std::optional<PlaneShape> m_shape;
    int m_axis = -1; ///< of a region in a slice along the grid: the one across it
    double m_place = 0.0; ///< of that region along this axis, in voxels
    glm::dvec3 m_centreLps{0.0}; ///< of a ball, true
    double m_radiusMm = 0.0;
    std::vector<VoxelBox> m_boxes;
    std::vector<glm::ivec3> m_samples;
};

} // namespace core
