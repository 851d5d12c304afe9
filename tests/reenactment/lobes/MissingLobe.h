// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/tools/SurfaceTool.h"
#include "core/volume/VolumeGeometry.h"
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

/// What a hand draws of the lobe's true outline: a closed contour where a plane passes the lobe
/// alone, otherwise the part in the lobe and a little beyond. It trembles slowly, by @p jitterMm
/// (root of the mean square) in each direction of the plane, alike over some millimetres.
[[nodiscard]] std::vector<core::TemplateContour> drawn(
    const MissingLobe& lobe, const LobeDrawing& drawing, double jitterMm, std::uint64_t seed);

} // namespace reenact
