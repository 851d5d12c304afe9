// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/tools/SurfaceTool.h"
#include "core/volume/VolumeGeometry.h"
#include "tests/reenactment/CounterRandom.h"
#include "tests/reenactment/MaskGrid.h"

namespace reenact {

/// An organ of which a mask has lost all that lies beyond a plane.
struct MissingLobe {
    core::VolumeGeometry geometry;
    Mask truth;
    Mask left; ///< the mask
    glm::dvec3 normalLps{0.0}; ///< of the plane, towards what is missing
    double atMm = 0.0; ///< the plane's place along it
};

/// @param share of the organ's voxels that is missing
[[nodiscard]] MissingLobe withoutLobe(const core::VolumeGeometry& geometry, const Mask& truth,
    const glm::dvec3& normalLps, double share);

/// How many contours are drawn on planes of each of three directions.
struct LobeDrawing {
    int across = 0; ///< along the cut, through the lobe: mostly closed ones
    int upright = 0; ///< on the cut: mostly open ones
    int beside = 0; ///< on the cut, across the others
};

/// A hand trembles slowly, by @p jitterMm (root of the mean square) in each direction of a plane,
/// alike over some millimetres.
/// @param stepMm between two points of the contour
void tremble(core::TemplateContour& contour, const glm::dvec3& normal, double stepMm,
    double jitterMm, CounterRandom& random);

/// What a hand draws of the lobe's true outline: a closed contour where a plane passes the lobe
/// alone, otherwise the part in the lobe and a little beyond. It trembles by @p jitterMm.
[[nodiscard]] std::vector<core::TemplateContour> drawn(
    const MissingLobe& lobe, const LobeDrawing& drawing, double jitterMm, std::uint64_t seed);

} // namespace reenact
