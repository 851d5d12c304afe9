// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/SliceAxis.h"
#include "core/volume/VolumeGeometry.h"

#include <glm/glm.hpp>

namespace ui {

enum class SliceOrientation { Axial, Sagittal, Coronal };

/// The axes of a standard plane of the patient (LPS), independent of how the volume was acquired,
/// in radiological convention: the patient's right is on the left of axial and coronal pictures,
/// the front on the left of sagittal ones.
struct SliceAxes {
    glm::dvec3 rightLps;
    glm::dvec3 downLps;
    /// Right × down. Slice numbers grow in this direction, as k does in a volume acquired in this
    /// plane.
    glm::dvec3 normalLps;
};
[[nodiscard]] SliceAxes sliceAxes(SliceOrientation orientation);

/// The voxel axis that is nearest to a direction: who looks along it sees, at least about, slices
/// across that axis.
[[nodiscard]] core::SliceAxis axisAlong(
    const core::VolumeGeometry& geometry, const glm::dvec3& normalLps);

/// The stack of slices through which the user scrolls: as many as cover the volume, with the
/// spacing of the voxel axis that is nearest to the normal. For a volume acquired in this plane
/// they are the acquired slices.
struct SliceStack {
    glm::dvec3 normalLps;
    double firstMm = 0.0; ///< position of slice 0 along the normal
    double stepMm = 1.0;
    int count = 0;

    /// The slice nearest to a point, 0 … count − 1.
    [[nodiscard]] int numberAt(const glm::dvec3& lps) const;
    /// The point moved along the normal into slice @p number, which is clamped to the stack.
    [[nodiscard]] glm::dvec3 movedTo(const glm::dvec3& lps, int number) const;
};
/// @param normalLps unit
[[nodiscard]] SliceStack sliceStack(
    const core::VolumeGeometry& geometry, const glm::dvec3& normalLps);
/// How many samples of a slab belong to each of its slices; an odd number, so that one of them lies
/// in the middle of the slice. 1 where the normal is an axis of the voxels, since the slices hold
/// all there is. In oblique slabs so many that two neighbours are at most half a voxel apart along
/// every axis: wider gaps would show as stripes.
[[nodiscard]] int samplesPerSlice(const core::VolumeGeometry& geometry, const SliceStack& stack);

} // namespace ui
