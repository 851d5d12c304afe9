// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SurfaceMirror.h"
#include "core/refine/mesh/SurfaceUpdate.h"
#include "core/volume/VolumeGeometry.h"

namespace core {

// A surface lies at the true places of the patient. Views show unevenly spaced slices as if they
// were evenly spaced, so there it is shown in another place; these functions take it there. The way
// back is truePlace() (core/measure/MeasuredSize.h) and trueNormal(). Where slices are evenly
// spaced both are the same to the bit.

/// Moves the vertices of an update to where views show them.
void moveToShown(SurfaceUpdate& update, const VolumeGeometry& geometry);

/// The same part of the surface where views show it; its area stays the true one.
[[nodiscard]] MarkedRegion shownRegion(const MarkedRegion& region, const VolumeGeometry& geometry);

/// The true direction, of length 1, of a normal that a view shows.
/// @param shownLps the place that it belongs to
[[nodiscard]] glm::dvec3 trueNormal(
    const VolumeGeometry& geometry, const glm::dvec3& shownLps, const glm::dvec3& normalLps);

} // namespace core
