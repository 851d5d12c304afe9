// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"
#include "tests/reenactment/MaskGrid.h"
#include "tests/reenactment/sighted/SeenPlane.h"

#include <map>

namespace reenact {

/// The organ as somebody imagines it who has scrolled through slices: their readings, and between
/// slices that were not opened what lies between the two readings beside them. Made of seen planes
/// alone.
class Belief {
public:
    explicit Belief(const core::VolumeGeometry& geometry);

    /// @param view along a slice of the volume, through the centres of voxels
    void take(int slice, const SeenPlane& view);
    [[nodiscard]] bool has(int slice) const { return m_slices.contains(slice); }

    /// Beyond the first and the last slice that were opened there is nothing.
    [[nodiscard]] Mask organ() const;

private:
    struct Slice {
        bool isEmpty = true;
        /// Of each voxel, how far it lies from the reading, negative inside; no farther than is of
        /// interest.
        std::vector<float> offMm;
    };
    core::VolumeGeometry m_geometry;
    std::map<int, Slice> m_slices;
};

/// What a user means to have: the mask, as it is where they have no quarrel with it, and as it was
/// read where they have. Readings are unsteady, so nobody quarrels with a mask that lies a little
/// beside them: there is a quarrel where both are apart by more than leastQuarrelMm, and then it is
/// about all between them that lies near.
constexpr double leastQuarrelMm = 3.0;
/// A smaller one is not seen when scrolling. Of the organ's voxels.
constexpr double leastQuarrelShare = 0.002;
[[nodiscard]] Mask meantOf(
    const Mask& seen, const Mask& organ, const core::VolumeGeometry& geometry);

} // namespace reenact
