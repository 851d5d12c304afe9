// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"
#include "core/volume/VolumeGeometry.h"

#include <functional>

namespace test {

/// A volume in which no voxel knows of its neighbours, and what interpolation makes of it, worked
/// out from the voxels by the textbook.
class VoxelNoise {
public:
    explicit VoxelNoise(const core::VolumeGeometry& geometry, int highest = 4000)
        : m_geometry(geometry)
        , m_highest(highest)
    {
    }
    [[nodiscard]] const core::VolumeGeometry& geometry() const { return m_geometry; }
    /// Of a voxel; beyond the border of the outermost.
    [[nodiscard]] double codeAt(const glm::ivec3& voxel) const;
    /// For FrameFixture::open().
    [[nodiscard]] std::function<double(const glm::dvec3& lps)> codes() const;

    [[nodiscard]] double linearAt(const glm::dvec3& lps) const;
    /// Keys 1981, a = −1/2 (Catmull-Rom), as a sum over the kernel.
    [[nodiscard]] double cubicAt(const glm::dvec3& lps) const;
    [[nodiscard]] double at(const glm::dvec3& lps, bool cubic) const
    {
        return cubic ? cubicAt(lps) : linearAt(lps);
    }
    /// How far inside of the volume's border, in voxels; negative: outside.
    [[nodiscard]] double depthOf(const glm::dvec3& lps) const;

private:
    core::VolumeGeometry m_geometry;
    int m_highest;
};

/// Of DICOM PS3.3 C.11.2.1.2.1, LINEAR, to 0 … 255, not rounded.
[[nodiscard]] double greyOf(double value, const core::WindowLevel& window);

/// Anisotropic, with a tilted gantry and turned.
[[nodiscard]] core::VolumeGeometry tiltedGeometry(const glm::ivec3& size);

} // namespace test
