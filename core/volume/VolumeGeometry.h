// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace core {

/// The position of a volume's voxels in the patient.
///
/// Index space: voxel integers (i = column, j = row, k = slice), whole numbers at voxel centres.
/// World space: DICOM patient coordinates, LPS (x to the left, y to posterior, z to superior), mm.
/// The affine is general: gantry tilt makes it sheared. Slices are sorted so that k grows along
/// row × column direction (DICOM PS3.3 C.7.6.2.1), hence the determinant is positive for DICOM.
struct VolumeGeometry {
    glm::ivec3 size{0}; ///< columns, rows, slices
    glm::dmat4 indexToWorld{1.0}; ///< voxel centres, index → LPS mm
    /// LPS position of voxel (0, 0, k) of every slice if the affine does not fit all of them
    /// (irregular spacing); otherwise empty.
    std::vector<glm::dvec3> slicePositions;

    [[nodiscard]] glm::dmat4 worldToIndex() const;
    [[nodiscard]] glm::dvec3 toWorld(const glm::dvec3& index) const;
    [[nodiscard]] glm::dvec3 toIndex(const glm::dvec3& worldLps) const;

    /// Distance in mm between neighbours along columns (i), rows (j) and slices (k).
    [[nodiscard]] glm::dvec3 spacingMm() const;
    /// Unit vectors of the index axes in LPS, as matrix columns.
    [[nodiscard]] glm::dmat3 direction() const;
    [[nodiscard]] glm::dvec3 originLps() const { return glm::dvec3(indexToWorld[3]); }
    [[nodiscard]] double voxelVolumeMm3() const;
    /// Angle between the slice step and the slice normal (gantry tilt); 0 for a box.
    [[nodiscard]] double shearAngleDegrees() const;

    [[nodiscard]] std::size_t voxelCount() const;
    [[nodiscard]] bool contains(const glm::ivec3& index) const;
    /// LPS bounds of the voxel cells (half a voxel beyond the outermost centres): eight corners.
    [[nodiscard]] std::vector<glm::dvec3> cornersLps() const;
};

/// The deviation from equal steps of this length up to which slices count as evenly spaced.
[[nodiscard]] double evenSlicesToleranceMm(double stepMm);

} // namespace core
