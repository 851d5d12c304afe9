// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"
#include "core/volume/Volume.h"

#include <QImage>

#include <optional>
#include <span>

namespace ui {

/// A picture of a native slice of a volume in its default window. What was added to a mask is
/// green, what was taken from it red, and what stayed blue.
struct ChangePicture {
    int slice = 0; ///< index of the slice, counted from 0
    QImage image;
};

/// Draws the slice in which most voxels differ, the first of them if there are several, cropped to
/// the masks with a margin of 30 mm. It is oriented as views show slices (axial: anterior at the
/// top, the patient's right on the left), and its pixels are square. None if the masks are equal.
/// Cost: one pass over the runs, and one slice. Any thread.
/// @param codes of the volume, x fastest
/// @param now, before the voxels of the mask, as voxel numbers of the volume
[[nodiscard]] std::optional<ChangePicture> changePicture(const core::Volume& volume,
    std::span<const std::uint16_t> codes, const core::VoxelRuns& now,
    const core::VoxelRuns& before);

} // namespace ui
