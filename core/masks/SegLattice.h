// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/dicom/objects/SegReader.h"
#include "core/masks/LatticeMap.h"
#include "core/volume/Volume.h"

#include <glm/glm.hpp>

namespace core {

// Where the frames of a DICOM SEG (PS3.3 A.51) lie on the grid of a volume. Used by SegMask.cpp.

/// The lattice that the frames span: columns and rows of the first frame, and its normal.
struct FrameLattice {
    glm::dvec3 normal{0.0};
    glm::dmat4 world{1.0}; ///< lattice to world (LPS mm), where one step along the normal is 1 mm
    double planeMm = 1.0; ///< thickness of a plane; it reaches half of this to either side
    /// Whether every plane coincides with a slice of the volume and is as thick as one.
    bool onSlices = false;

    [[nodiscard]] glm::dmat4 toLattice() const
    {
        glm::dmat4 matrix = world;
        matrix[2] *= planeMm;
        return glm::inverse(matrix);
    }
};

/// The lattice of the frames, and how a volume's voxels map onto it.
struct PlacedFrames {
    FrameLattice lattice;
    glm::dmat4 toLattice;
    LatticeMap map;
};
/// Places the frames on a volume. Planes of thicker slices that coincide with slices reach half of
/// their distance to either side (SegLattice.cpp says when they are such). Errors: InvalidGeometry
/// (of the first frame), UnsupportedFormat (frames of several orientations or spacings, or out of
/// all proportion to the volume). All name the file.
[[nodiscard]] Result<PlacedFrames> placedFrames(
    const SegFile& seg, const Volume& volume, const QString& path);

} // namespace core
