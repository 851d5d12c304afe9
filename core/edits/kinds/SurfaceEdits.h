// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SurfaceMark.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace core {

// Edits of the surface that is being refined (seed B §4; core/refine). There is one at a time, of
// one segment; its voxels change by WriteBack alone.

/// Lay a surface around what a segment holds, all yellow; the one that was there goes.
struct LaySurface {
    int segment = 0; ///< label
    /// About so many; 0: as many as it takes for the surface to enclose what the segment holds
    /// (core/refine/fit/MeasuredFit.h).
    int vertices = 0;
};

/// Do without a surface. What was not written back is lost with it, until this is undone.
struct DropSurface { };

/// Have what is yellow follow the boundary of what the segment holds now. Red and green stay.
struct FollowMask { };

/// Where a tool of the surface went: the middle of the ball in which it works, from point to point.
struct SurfacePath {
    double radiusMm = 8.0;
    std::vector<glm::dvec3> pointsLps{};
};

/// Paint what is thought of the surface.
struct MarkSurface {
    SurfaceMark mark = SurfaceMark::Red;
    SurfacePath path{};
};

/// Change all that is marked so at once, or one region of it.
struct ChangeMarks {
    enum class Way {
        Grow, ///< by the vertices beside it
        Shrink,
        Invert, ///< what is marked so turns yellow, all that is yellow is marked so
        Clear, ///< what is marked so turns yellow
        Accept, ///< what is marked red turns green: it is signed off
    };
    SurfaceMark mark = SurfaceMark::Red; ///< not yellow
    Way way = Way::Grow;
    /// Of Clear and Accept: only the region that hangs together and lies nearest to it; none: all.
    std::optional<glm::dvec3> nearLps{};
};

/// A ball pushes the surface out from inside of it, and in from outside.
struct SpherePush {
    SurfacePath path{};
};

/// A plane takes off what stands beyond it.
struct PlaneScrape {
    SurfacePath path{};
    glm::dvec3 normalLps{0.0, 0.0, 1.0}; ///< outwards, about a unit vector
};

/// The vertex nearest to the first point is drawn along, and what is around it like a rubber sheet.
struct PointDrag {
    SurfacePath path{};
};

/// What is red takes the shape of contours that were drawn on planes.
struct ApplyTemplate {
    std::vector<std::vector<glm::dvec3>> contoursLps{};
};

/// Even the surface out.
struct SmoothSurface {
    SurfacePath path{};
};

/// Draw the surface to where values change most.
struct AttractSurface {
    SurfacePath path{};
};

/// The segment follows the surface to where it was moved since they last agreed: where a voxel's
/// centre has come inside the segment gets it, where it has come outside the segment loses it. All
/// other voxels stay as they are, whether or not the surface encloses them: one that nobody moved
/// changes none. What exactly that means, also at the rim of what was moved and where the mask was
/// changed meanwhile, stands in core/session/surface/SurfaceWriteBack.h.
struct WriteBack {
    bool overwriteUnlocked = false;
};

/// Shut the place of the surface to growth, or open it again: every voxel whose centre lies outside
/// and that has one with its centre inside among the 26 around it. No growth passes such a shell,
/// by 6, 18 or 26 neighbours, but where a place stays open by the rules of PaintBarrier. It lies
/// outside so that a growth within can fill all that the surface encloses.
struct SurfaceBarrier {
    bool erase = false; ///< barriers there are opened
};

} // namespace core
