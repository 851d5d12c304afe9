// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMesh.h"
#include "core/volume/VolumeGeometry.h"
#include "tests/reenactment/UserEye.h"

namespace reenact {

// What a user would do about a region with each tool, and about how much that would mend. Places in
// index space, lengths in voxels.

/// A plane that takes off what is too much.
struct ScrapePlan {
    glm::dvec3 place{0.0};
    glm::dvec3 normal{0.0, 0.0, 1.0};
    double radius = 0.0;
    int gain = 0;
};
[[nodiscard]] ScrapePlan bestScrape(const UserEye& eye, const UserEye::Region& region);

/// The middle of the wrong surface is drawn to where it belongs.
struct DragPlan {
    glm::dvec3 from{0.0};
    glm::dvec3 to{0.0};
    double radius = 0.0;
    int gain = 0;
};
[[nodiscard]] DragPlan bestDrag(const UserEye& eye, const UserEye::Region& region);

/// A brush goes over the wrong surface of a region and of what is wrong near it.
struct SweepPlan {
    std::vector<glm::dvec3> points;
    double radius = 0.0;
    int wrong = 0; ///< voxels there
    int deep = 0; ///< of these, more than a voxel off the organ's border
};
/// @param most how far the brush goes from the region's middle @param leastRadius of the brush
[[nodiscard]] SweepPlan sweepOver(const UserEye& eye, const UserEye::Region& region,
    const core::SimplexMesh& mesh, const core::VolumeGeometry& geometry, double most,
    double leastRadius);

/// The wrong surface is painted red, and contours are drawn where it belongs.
struct TemplatePlan {
    std::vector<glm::dvec3> paint; ///< a stroke of the brush, with this radius
    double paintRadius = 0.0;
    struct Contour {
        std::vector<glm::dvec3> points;
        glm::dvec3 normal{0.0}; ///< of the plane that it is drawn on
    };
    std::vector<Contour> contours;
    int gain = 0;
    [[nodiscard]] int actions() const { return 2 + int(contours.size()); }
};
[[nodiscard]] TemplatePlan templateFor(const UserEye& eye, const UserEye::Region& region,
    const core::SimplexMesh& mesh, const core::VolumeGeometry& geometry);

} // namespace reenact
