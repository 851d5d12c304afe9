// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMesh.h"

namespace core {

/// A vertex, as forces see it.
struct SurfacePoint {
    VertexId vertex = noId;
    glm::dvec3 positionLps{0.0};
    glm::dvec3 normalLps{0.0}; ///< outwards; 0 if its neighbours lie in a line
    SurfaceMark mark = SurfaceMark::Yellow;
    /// averaged as the settings say; positive where the surface bulges outwards
    double curvaturePerMm = 0.0;
    double distanceMm = 0.0; ///< mean distance to its neighbours
};

/// A force on the surface from outside it (seed B §6.3): the boundary of the mask, a tool.
class ExternalForce {
public:
    ExternalForce() = default;
    virtual ~ExternalForce() = default;
    ExternalForce(const ExternalForce&) = delete;
    ExternalForce& operator=(const ExternalForce&) = delete;

    /// The vector from a vertex to where it should be; 0: no force. Called by several threads at
    /// once, for vertices that are not green. The result depends on the point alone.
    [[nodiscard]] virtual glm::dvec3 forceMm(const SurfacePoint& point) const = 0;
};

/// Decides where a vertex finally goes, after all forces, so that what a tool holds is exactly
/// where the tool puts it.
class SurfaceGuide {
public:
    SurfaceGuide() = default;
    virtual ~SurfaceGuide() = default;
    SurfaceGuide(const SurfaceGuide&) = delete;
    SurfaceGuide& operator=(const SurfaceGuide&) = delete;

    /// Called by several threads at once, but only once per step for a vertex, and never for green
    /// ones.
    /// @param forceMm the force on it, which decides whether it rests and whether neighbours become
    /// active
    /// @param placeLps where the step would move it
    virtual void guide(const SurfacePoint& point, glm::dvec3& forceMm, glm::dvec3& placeLps) = 0;
};

} // namespace core
