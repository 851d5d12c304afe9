// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/edits/kinds/history/RevertRows.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "tests/support/cases/strokes/StrokeFamilies.h"

namespace test {

namespace {

/// A disc of segment 1 on one of the acquired slices.
core::Edit discAt(const core::VolumeGeometry& geometry, const glm::dvec3& voxel, double radiusMm)
{
    core::PaintStroke stroke{.segment = 1};
    stroke.path.shape = core::BrushPath::Shape::Disc;
    stroke.path.normalLps = geometry.direction()[2];
    stroke.path.radiusMm = radiusMm;
    stroke.path.pointsLps = {geometry.toWorld(voxel)};
    return stroke;
}

} // namespace

void addFillingStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene)
{
    const core::LoadedVolume& volume = scene.volume;
    const core::VolumeGeometry& geometry = volume.volume.geometry;
    const core::Edit& first = scene.first;
    const core::Edit& second = scene.second;
    const core::Edit low = discAt(geometry, {14.0, 12.0, 4.0}, 6.0);
    const core::Edit high = discAt(geometry, {18.0, 15.0, 9.0}, 3.0);
    const core::Edit apart = discAt(geometry, {33.0, 26.0, 15.0}, 4.0);
    const core::FillBetweenSlices between{.segment = 1};
    const core::FillBetweenSlices acquired{.segment = 1, .axis = core::SliceAxis::K};
    cases.push_back({"fill between slices", volume, {first, low, high}, between});
    cases.push_back(
        {"fill between slices that do not overlap", volume, {first, low, high, apart}, acquired});
    cases.push_back({"fill between slices beside another", volume,
        {first, second, scene.others, scene.some, low, high}, acquired});
    cases.push_back({"fill between slices of a solid segment", volume, {first, low}, between});
    cases.push_back({"fill between slices of an empty segment", volume, {first}, between});
    cases.push_back({"growth after filling between slices", volume,
        {first, low, high, between, scene.seeds}, scene.all});
    cases.push_back({"undo only a fill between slices", volume,
        {first, low, high, between, scene.drill}, core::RevertRows{{4}}});
}

} // namespace test
