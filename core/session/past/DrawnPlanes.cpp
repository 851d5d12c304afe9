// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/DrawnPlanes.h"

#include "core/edits/engine/SlicePlane.h"
#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/kinds/filling/SketchPlanes.h"
#include "core/volume/VolumeGeometry.h"

#include <algorithm>
#include <optional>

namespace core {

namespace {

/// The plane on which an edit gave a segment voxels; none: on no plane.
struct PlaneOfEdit {
    using Found = std::optional<DrawnPlane>;

    int segment;
    const VolumeGeometry& geometry;

    Found operator()(const PaintStroke& painted) const
    {
        const BrushPath& path = painted.path;
        const bool isDrawn = painted.segment == segment && !painted.erase && isFlat(path.shape)
            && path.normalLps && !path.pointsLps.empty();
        return isDrawn ? Found({.placeLps = path.pointsLps.front(), .normalLps = *path.normalLps})
                       : std::nullopt;
    }
    Found operator()(const FillOutline& outline) const
    {
        return outline.segment == segment && !outline.erase ? Found({.placeLps = outline.originLps,
                   .normalLps = glm::cross(outline.rightLps, outline.upLps)})
                                                            : std::nullopt;
    }
    Found operator()(const FloodFill& flood) const
    {
        if (flood.segment != segment || flood.erase || !isInSlice(flood))
            return std::nullopt;
        if (flood.normalLps)
            return DrawnPlane{.placeLps = flood.placeLps, .normalLps = *flood.normalLps};
        const glm::dmat3 steps(geometry.indexToWorld);
        return DrawnPlane{.placeLps = flood.placeLps,
            .normalLps = glm::cross(glm::normalize(steps[acrossOf(*flood.within)]),
                glm::normalize(steps[downOf(*flood.within)]))};
    }
    template <class E> Found operator()(const E&) const { return std::nullopt; }
};

} // namespace

std::vector<DrawnPlane> drawnPlanes(
    int segment, const History& history, const VolumeGeometry& geometry)
{
    std::vector<DrawnPlane> planes;
    for (const RowId row : history.standing()) {
        const PlaneOfEdit planeOf{.segment = segment, .geometry = geometry};
        const std::optional<DrawnPlane> plane = visitEdit(planeOf, history.row(row).edit);
        constexpr double shortest = 1e-3;
        if (plane && glm::length(plane->normalLps) > shortest)
            planes.push_back(*plane);
    }
    planes = distinctPlanes(planes, geometry);
    if (planes.size() > PlaneSketch::mostPlanes)
        planes.erase(planes.begin(), planes.end() - std::ptrdiff_t(PlaneSketch::mostPlanes));
    return planes;
}

bool areAcrossOneAxis(const std::vector<DrawnPlane>& planes, const VolumeGeometry& geometry)
{
    const auto axisOf = [&](const DrawnPlane& plane) {
        const std::optional<SlicePlane::OnGrid> onGrid =
            slicePlane(geometry, glm::normalize(plane.normalLps), plane.placeLps).onGrid;
        return onGrid ? std::optional(onGrid->axis) : std::nullopt;
    };
    return planes.size() < 2
        || std::all_of(planes.begin(), planes.end(), [&](const DrawnPlane& each) {
               return axisOf(each) && axisOf(each) == axisOf(planes.front());
           });
}

} // namespace core
