// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/edits/kinds/parts/DrawnPlane.h"
#include "core/morphology/planes/PlaneSketch.h"

#include <vector>

namespace core {

struct VolumeGeometry;

/// Converts planes to integers. A plane along the grid of the volume is moved to the middle of the
/// nearest slice, as for a brush (SlicePlane.h). Of planes that take the same slice, or nearly so,
/// only the first one remains. Errors: InvalidField below @p name (too few planes
/// or too many, no direction, a plane that misses the volume).
[[nodiscard]] Result<PlaneSketch> planeSketch(
    const std::vector<DrawnPlane>& planes, const VolumeGeometry& geometry, const QString& name);

/// Of planes that take the same slice, or nearly so, the first one; and none that misses the
/// volume.
/// @pre all normals are directions
[[nodiscard]] std::vector<DrawnPlane> distinctPlanes(
    const std::vector<DrawnPlane>& planes, const VolumeGeometry& geometry);

} // namespace core
