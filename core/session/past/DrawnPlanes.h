// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/DrawnPlane.h"
#include "core/history/History.h"

#include <vector>

namespace core {

struct VolumeGeometry;

/// The planes of the slices on which strokes in effect gave a segment voxels (of a flat brush, a
/// filled outline, or a flood in one slice), each once, oldest first; if there are more than
/// FillBetweenSlices can name, the newest ones. Whether anything of these strokes is left is not
/// checked.
[[nodiscard]] std::vector<DrawnPlane> drawnPlanes(
    int segment, const History& history, const VolumeGeometry& geometry);

/// Whether they are slices across one axis of the grid, or too few for anything to lie between.
[[nodiscard]] bool areAcrossOneAxis(
    const std::vector<DrawnPlane>& planes, const VolumeGeometry& geometry);

} // namespace core
