// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"
#include "core/volume/Volume.h"

#include <QImage>

#include <optional>
#include <span>

namespace ui {

/// A native slice of a volume in its default window, with what was added to a mask in green, what
/// was taken from it in red and what stayed in blue.
struct ChangePicture {
    int slice = 0; ///< 0-based
    QImage image;
};

/// Of the slice in which most voxels differ, the first of several, cut to the masks with 30 mm
/// around them. It is turned as views show it: of an axial slice the patient's front is above and
/// the right on the left; lengths are true. None if the masks are equal. Cost: one pass over the
/// runs, and one slice. Any thread.
/// @param codes of the volume, x fastest
/// @param now, before voxels of the volume
[[nodiscard]] std::optional<ChangePicture> changePicture(const core::Volume& volume,
    std::span<const std::uint16_t> codes, const core::VoxelRuns& now,
    const core::VoxelRuns& before);

} // namespace ui
