// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/surface/ApplyTemplate.h"
#include "core/edits/kinds/surface/AttractSurface.h"
#include "core/edits/kinds/surface/ChangeMarks.h"
#include "core/edits/kinds/surface/DropSurface.h"
#include "core/edits/kinds/surface/FollowMask.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/MarkSurface.h"
#include "core/edits/kinds/surface/PlaneScrape.h"
#include "core/edits/kinds/surface/PointDrag.h"
#include "core/edits/kinds/surface/SmoothSurface.h"
#include "core/edits/kinds/surface/SpherePush.h"
#include "core/edits/kinds/surface/SurfaceBarrier.h"
#include "core/edits/kinds/surface/WriteBack.h"
#include "core/edits/kinds/surface/parts/SurfacePath.h"
#include "core/edits/schema/SchemaParts.h"

namespace core::editSchema {

inline constexpr editFields::WholeNumber surfaceVertices{0, 400'000};

/// By which rules the surface is moved, in every edit that moves it or takes it as it is.
template <class Visitor> void visitRules(Visitor& visit, SurfaceRules& rules)
{
    visit.maybe("rules", rules, editFields::WholeNumber{1, newestSurfaceRules},
        "the version of the rules: from 2 on, the surface never passes through itself, and sphere "
        "and plane move only the sheet under the pen; from 3 on, a template may mix open and "
        "closed contours; from 4 on, as many vertices as it takes may be 400000",
        "1, the oldest rules");
}

template <> inline constexpr const char* editName<LaySurface> = "surface";
template <>
inline constexpr const char* editMeaning<LaySurface> =
    "Lays a surface around a segment, so that it can be refined; it replaces the present surface.";
template <class Visitor> void visitFields(Visitor& visit, LaySurface& edit)
{
    visitSegment(visit, edit.segment);
    visit.field("vertices", Presence::Optional, edit.vertices, surfaceVertices,
        "about how many vertices the surface has, at least 100; 0 means as many as are needed to "
        "enclose all but a thousandth of the segment's voxels, up to 400000 (200000 by rules "
        "before "
        "4)");
    visitRules(visit, edit.rules);
    visit.maybe("onlyCrossings", edit.onlyCrossings, editFields::Flag{},
        "whether the present surface stays, except for parts that pass through themselves or each "
        "other, which are laid anew around the voxels that they enclose",
        "all of it is laid anew");
}

template <> inline constexpr const char* editName<DropSurface> = "dropSurface";
template <>
inline constexpr const char* editMeaning<DropSurface> =
    "Removes the surface; what was not written back is lost with it.";
template <class Visitor> void visitFields(Visitor&, DropSurface&) { }

template <> inline constexpr const char* editName<FollowMask> = "followMask";
template <>
inline constexpr const char* editMeaning<FollowMask> =
    "Makes the yellow parts of the surface follow the boundary that the segment has now.";
template <class Visitor> void visitFields(Visitor& visit, FollowMask& edit)
{
    visitRules(visit, edit.rules);
}

/// The path of a tool of the surface, in every edit that has one.
template <class Visitor> void visitSurfacePath(Visitor& visit, SurfacePath& path)
{
    visit.field("radiusMm", Presence::Required, path.radiusMm, brushRadius,
        "the radius of the ball in which the tool works");
    visit.field("pointsLps", Presence::Required, path.pointsLps, editFields::PointList{positionLps},
        "the path of the ball's middle, which runs straight from point to point, in patient "
        "coordinates (LPS)");
    visitRules(visit, path.rules);
    visitPressures(visit, path.pressures);
}

template <> inline constexpr const char* editName<MarkSurface> = "mark";
template <>
inline constexpr const char* editMeaning<MarkSurface> =
    "Paints the surface: green is right and stays, yellow follows the mask, red is wrong and free "
    "for the tools.";
template <class Visitor> void visitFields(Visitor& visit, MarkSurface& edit)
{
    visit.field("mark", Presence::Required, edit.mark,
        editFields::Choice<SurfaceMark, 3>{{"yellow", "green", "red"}}, "the mark that is painted");
    visitSurfacePath(visit, edit.path);
}

template <> inline constexpr const char* editName<ChangeMarks> = "changeMarks";
template <>
inline constexpr const char* editMeaning<ChangeMarks> =
    "Changes all marks of one colour on the surface at once.";
template <class Visitor> void visitFields(Visitor& visit, ChangeMarks& edit)
{
    visit.field("mark", Presence::Required, edit.mark,
        editFields::Choice<SurfaceMark, 3>{{"yellow", "green", "red"}},
        "the marks that are changed, which are not yellow");
    visit.field("way", Presence::Required, edit.way,
        editFields::Choice<ChangeMarks::Way, 5>{{"grow", "shrink", "invert", "clear", "accept"}},
        "grow and shrink move their border by one ring of vertices; invert exchanges them with "
        "yellow; clear turns them yellow; accept turns red ones green");
    visit.maybe("nearLps", edit.nearLps, positionLps,
        "for clear and accept: a place, in patient coordinates (LPS); only the marked region "
        "nearest to it changes",
        "all regions");
}

template <> inline constexpr const char* editName<SpherePush> = "spherePush";
template <>
inline constexpr const char* editMeaning<SpherePush> =
    "Pushes the red and yellow parts of the surface with a ball: out where it is mostly inside, in "
    "where it is mostly outside.";
template <class Visitor> void visitFields(Visitor& visit, SpherePush& edit)
{
    visitSurfacePath(visit, edit.path);
}

template <> inline constexpr const char* editName<PlaneScrape> = "planeScrape";
template <>
inline constexpr const char* editMeaning<PlaneScrape> =
    "Scrapes off what stands out beyond a plane, within the ball that follows the pen.";
template <class Visitor> void visitFields(Visitor& visit, PlaneScrape& edit)
{
    visitSurfacePath(visit, edit.path);
    visit.field("normalLps", Presence::Required, edit.normalLps,
        editFields::Point{editFields::Number{"", -1000.0, 1000.0, quantum::perDirection}},
        "the direction perpendicular to the plane, outwards; the plane passes through the point "
        "where the pen is");
    visit.maybe("acrossLps", edit.acrossLps,
        editFields::Point{editFields::Number{"", -1000.0, 1000.0, quantum::perDirection}},
        "the normal of the slice on which the pen moves; the plane stands perpendicular to that "
        "slice and turns with the pen's path",
        "the plane keeps its normal");
}

template <> inline constexpr const char* editName<PointDrag> = "pointDrag";
template <>
inline constexpr const char* editMeaning<PointDrag> =
    "Pulls the vertex nearest to the first point along the path, and the surface around it like a "
    "rubber sheet; the vertex is green afterwards.";
template <class Visitor> void visitFields(Visitor& visit, PointDrag& edit)
{
    visitSurfacePath(visit, edit.path);
}

template <> inline constexpr const char* editName<ApplyTemplate> = "template";
template <>
inline constexpr const char* editMeaning<ApplyTemplate> =
    "Gives the red parts of the surface the shape that contours on any planes describe.";
template <class Visitor> void visitFields(Visitor& visit, ApplyTemplate& edit)
{
    visit.field("contoursLps", Presence::Required, edit.contoursLps,
        editFields::ContourList{positionLps}, "the contours, in patient coordinates (LPS)");
    visitRules(visit, edit.rules);
}

template <> inline constexpr const char* editName<SmoothSurface> = "smooth";
template <>
inline constexpr const char* editMeaning<SmoothSurface> =
    "Evens out the red and yellow parts of the surface.";
template <class Visitor> void visitFields(Visitor& visit, SmoothSurface& edit)
{
    visitSurfacePath(visit, edit.path);
}

template <> inline constexpr const char* editName<AttractSurface> = "attract";
template <>
inline constexpr const char* editMeaning<AttractSurface> =
    "Moves the red parts of the surface to where values change most.";
template <class Visitor> void visitFields(Visitor& visit, AttractSurface& edit)
{
    visitSurfacePath(visit, edit.path);
}

template <> inline constexpr const char* editName<WriteBack> = "writeBack";
template <>
inline constexpr const char* editMeaning<WriteBack> =
    "Gives the segment the voxels that the surface was moved over outwards since it was laid or "
    "written back, and takes from it those that it was moved over inwards; all others stay.";
template <class Visitor> void visitFields(Visitor& visit, WriteBack& edit)
{
    visitOverwrite(visit, edit.overwriteUnlocked);
    visitRules(visit, edit.rules);
    visitEditable(visit, edit.editable);
}

template <> inline constexpr const char* editName<SurfaceBarrier> = "surfaceBarrier";
template <>
inline constexpr const char* editMeaning<SurfaceBarrier> =
    "Shuts the voxels just outside the surface to growth, so that none passes through it, or opens "
    "them again.";
template <class Visitor> void visitFields(Visitor& visit, SurfaceBarrier& edit)
{
    visit.field("erase", Presence::Optional, edit.erase, editFields::Flag{},
        "whether barriers there are taken away instead, so that growth may pass");
}

} // namespace core::editSchema
