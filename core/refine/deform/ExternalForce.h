// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMesh.h"

namespace core {

/// A vertex, as forces see it.
struct SurfacePoint {
    VertexId vertex = noId;
    glm::dvec3 positionLps{0.0};
    glm::dvec3 normalLps{0.0}; ///< outwards; 0 where its neighbours lie in a line
    SurfaceMark mark = SurfaceMark::Yellow;
    double curvaturePerMm = 0.0; ///< as even as it is to be; positive where it bulges outwards
    double distanceMm = 0.0; ///< of its neighbours, in the mean
};

/// What pulls at the surface from without (seed B §6.3): the mask's boundary, a tool.
class ExternalForce {
public:
    ExternalForce() = default;
    virtual ~ExternalForce() = default;
    ExternalForce(const ExternalForce&) = delete;
    ExternalForce& operator=(const ExternalForce&) = delete;

    /// The way from a vertex to where it is wanted; 0: no matter. Called by several threads at
    /// once, with vertices that are not green. It depends on the point alone.
    [[nodiscard]] virtual glm::dvec3 forceMm(const SurfacePoint& point) const = 0;
};

/// Has the last word on where a vertex goes, after all forces: what a tool holds on to is exactly
/// where the tool has it.
class SurfaceGuide {
public:
    SurfaceGuide() = default;
    virtual ~SurfaceGuide() = default;
    SurfaceGuide(const SurfaceGuide&) = delete;
    SurfaceGuide& operator=(const SurfaceGuide&) = delete;

    /// Called by several threads at once, but once a step for a vertex, none of them green.
    /// @param forceMm what works on it: decides who rests and who wakes neighbours
    /// @param placeLps where the step would take it
    virtual void guide(const SurfacePoint& point, glm::dvec3& forceMm, glm::dvec3& placeLps) = 0;
};

} // namespace core
