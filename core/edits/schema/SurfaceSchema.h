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
#include "core/edits/kinds/surface/SurfacePath.h"
#include "core/edits/kinds/surface/WriteBack.h"
#include "core/edits/schema/SchemaParts.h"

namespace core::editSchema {

inline constexpr editFields::WholeNumber surfaceVertices{0, 400'000};

/// By which rules the surface is moved, in every edit that moves it or takes it as it is.
template <class Visitor> void visitRules(Visitor& visit, SurfaceRules& rules)
{
    visit.maybe("rules", rules, editFields::WholeNumber{1, newestSurfaceRules},
        "by which rules; 2: the surface never passes through itself, and sphere and plane hold "
        "only the sheet under the pen; 3: open and closed contours of a template go together",
        "1: those of before");
}

template <> inline constexpr const char* editName<LaySurface> = "surface";
template <>
inline constexpr const char* editMeaning<LaySurface> =
    "Lays a surface around what a segment holds, to be refined; the one that was there goes.";
template <class Visitor> void visitFields(Visitor& visit, LaySurface& edit)
{
    visitSegment(visit, edit.segment);
    visit.field("vertices", Presence::Optional, edit.vertices, surfaceVertices,
        "about how many vertices the surface has, from 100; 0: as many as it takes to enclose what "
        "the segment holds, but for a thousandth of its voxels, or 200000");
    visitRules(visit, edit.rules);
    visit.maybe("onlyCrossings", edit.onlyCrossings, editFields::Flag{},
        "whether the surface that is there stays, but for the parts that pass through themselves "
        "or each other, which are laid anew around the voxels that they enclose",
        "all of it is laid anew");
}

template <> inline constexpr const char* editName<DropSurface> = "dropSurface";
template <>
inline constexpr const char* editMeaning<DropSurface> =
    "Does without a surface; what was not written back goes with it.";
template <class Visitor> void visitFields(Visitor&, DropSurface&) { }

template <> inline constexpr const char* editName<FollowMask> = "followMask";
template <>
inline constexpr const char* editMeaning<FollowMask> =
    "Has the yellow parts of the surface follow the boundary of what the segment holds now.";
template <class Visitor> void visitFields(Visitor& visit, FollowMask& edit)
{
    visitRules(visit, edit.rules);
}

/// The path of a tool of the surface, in every edit that has one.
template <class Visitor> void visitSurfacePath(Visitor& visit, SurfacePath& path)
{
    visit.field("radiusMm", Presence::Required, path.radiusMm, brushRadius,
        "of the ball in which the tool works");
    visit.field("pointsLps", Presence::Required, path.pointsLps, editFields::PointList{positionLps},
        "the middle of the ball, straight from point to point, patient coordinates (LPS)");
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
        editFields::Choice<SurfaceMark, 3>{{"yellow", "green", "red"}}, "what is painted");
    visitSurfacePath(visit, edit.path);
}

template <> inline constexpr const char* editName<ChangeMarks> = "changeMarks";
template <>
inline constexpr const char* editMeaning<ChangeMarks> =
    "Changes all marks of one colour on the surface at once.";
template <class Visitor> void visitFields(Visitor& visit, ChangeMarks& edit)
{
    visit.field("mark", Presence::Required, edit.mark,
        editFields::Choice<SurfaceMark, 3>{{"yellow", "green", "red"}}, "which; not yellow");
    visit.field("way", Presence::Required, edit.way,
        editFields::Choice<ChangeMarks::Way, 5>{{"grow", "shrink", "invert", "clear", "accept"}},
        "they grow or shrink by one ring of vertices, change places with yellow, turn yellow, or, "
        "of red ones, turn green");
    visit.maybe("nearLps", edit.nearLps, positionLps,
        "of clear and accept: only the region nearest to it, patient coordinates (LPS)",
        "all of them");
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
    "Takes down what stands beyond a plane, within the ball around the pen's way.";
template <class Visitor> void visitFields(Visitor& visit, PlaneScrape& edit)
{
    visitSurfacePath(visit, edit.path);
    visit.field("normalLps", Presence::Required, edit.normalLps,
        editFields::Point{editFields::Number{"", -1000.0, 1000.0, quantum::perDirection}},
        "across the plane, outwards; the plane holds the point that the pen is at");
    visit.maybe("acrossLps", edit.acrossLps,
        editFields::Point{editFields::Number{"", -1000.0, 1000.0, quantum::perDirection}},
        "the normal of the slice on which the pen is moved; the plane stands across it and turns "
        "with the pen's way",
        "the plane keeps its normal");
}

template <> inline constexpr const char* editName<PointDrag> = "pointDrag";
template <>
inline constexpr const char* editMeaning<PointDrag> =
    "Draws the vertex nearest to the first point along, and the surface around it like a rubber "
    "sheet; the vertex is green afterwards.";
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
        editFields::ContourList{positionLps}, "the contours, patient coordinates (LPS)");
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
    "Draws the red parts of the surface to where values change most.";
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
}

template <> inline constexpr const char* editName<SurfaceBarrier> = "surfaceBarrier";
template <>
inline constexpr const char* editMeaning<SurfaceBarrier> =
    "Shuts the voxels just outside the surface to growth, so that none passes through it, or opens "
    "them again.";
template <class Visitor> void visitFields(Visitor& visit, SurfaceBarrier& edit)
{
    visit.field("erase", Presence::Optional, edit.erase, editFields::Flag{},
        "barriers there are taken away instead: the place is open to growth");
}

} // namespace core::editSchema
