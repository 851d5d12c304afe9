// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/document/OrthographicView.h"
#include "core/edits/fields/EditFields.h"
#include "core/edits/fields/Quantum.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "core/edits/kinds/parts/EditableRange.h"
#include "core/edits/kinds/parts/ProtectedSegments.h"
#include "core/edits/schema/EditLists.h"

namespace core::editSchema {

/// Whether a field may be left out; it then has the value of a default-constructed edit.
enum class Presence { Required, Optional };

// The fields of each edit are defined only here. visitFields() presents them to a visitor, which
// reads, writes, checks, rounds or documents them:
//
//   field(name, presence, value, kind, meaning)    kind: editFields
//   maybe(name, std::optional value, kind, meaning, absent)  may be left out; absent says what
//                                                  that means, by itself "unchanged"
//   constant(name, presence, json, meaning)        only this value is known
//   group(name, meaning, visitInside)              an object of its own
//   maybeGroup(name, std::optional value, meaning, absent, visitInside)  one that may be left out;
//                                                  visitInside(visitor, value)
//   when(condition, visitInside)                   fields that are there only then
//
// editName<E> is the value of "edit" in JSON, editMeaning<E> its line in the documentation.

template <class E> inline constexpr const char* editName = nullptr;
template <class E> inline constexpr const char* editMeaning = nullptr;

using Thing = editFields::ThingNumber::Thing;
inline constexpr editFields::ThingNumber segmentNumber{{1, 255}, Thing::Segment};
inline constexpr editFields::ThingNumber layerNumber{{1, 254}, Thing::Layer};
inline constexpr editFields::WholeNumber labelPlane{0, mostLabelPlanes - 1};
inline constexpr editFields::Number modalityValue{
    "modality units", -quantum::unbounded, quantum::unbounded, 0.0};
inline constexpr editFields::Number millimetres{
    "mm", -quantum::reachMm, quantum::reachMm, quantum::perMillimetre};
inline constexpr editFields::Point positionLps{millimetres};
inline constexpr editFields::Number brushRadius{"mm", 0.01, 200.0, quantum::perMillimetre};
inline constexpr editFields::Number drillDepth{"mm", 0.0, 500.0, quantum::perMillimetre};
/// A curve in the plane of a view.
inline constexpr editFields::Outline viewOutline{
    editFields::Number{"mm", -2000.0, 2000.0, quantum::perMillimetre}};
/// A line in the plane of a view that need not enclose anything.
inline constexpr editFields::Outline viewLine{viewOutline.component, 2};
inline constexpr editFields::Number peelDepth{"mm", 0.0, 60.0, quantum::perMillimetre};

/// The segment that an edit is about.
template <class Visitor> void visitSegment(Visitor& visit, int& segment)
{
    visit.field("segment", Presence::Required, segment, segmentNumber, "which segment");
}

/// The sculpt layer that an edit is about.
template <class Visitor> void visitLayer(Visitor& visit, int& layer)
{
    visit.field("layer", Presence::Required, layer, layerNumber, "which sculpt layer");
}

/// The name of what an edit makes.
template <class Visitor> void visitName(Visitor& visit, QString& name)
{
    visit.field(
        "name", Presence::Required, name, editFields::Text{}, "the name that the list shows");
}

/// Whether an edit that gives voxels to a segment may take them from other segments.
template <class Visitor> void visitOverwrite(Visitor& visit, bool& overwriteUnlocked)
{
    visit.field("overwriteUnlocked", Presence::Optional, overwriteUnlocked, editFields::Flag{},
        "whether voxels of other segments that are not locked are taken");
}

/// The interval of values to which an edit is limited.
template <class Visitor>
void visitOnlyValues(Visitor& visit, std::optional<double>& lower, std::optional<double>& upper)
{
    visit.maybe("lower", lower, modalityValue, "only voxels whose value is at least this", "any");
    visit.maybe("upper", upper, modalityValue, "only voxels whose value is at most this", "any");
}

/// The field "editable" of every edit of labels that has an editable range.
template <class Visitor> void visitEditable(Visitor& visit, std::optional<EditableRange>& editable)
{
    visit.maybeGroup("editable", editable,
        "which voxels may change at all; each condition that is given narrows the choice further",
        "any voxel", [](auto& inside, EditableRange& range) {
            constexpr editFields::SegmentList segments{.mayBeEmpty = true};
            visitOnlyValues(inside, range.lower, range.upper);
            inside.maybe("box", range.box, editFields::CornerPair{positionLps},
                "two opposite corners of a box; only voxels inside it may change",
                "the whole volume");
            inside.maybe("inside", range.inside, segments,
                "only voxels of one of these segments may change; with an empty list, none may",
                "any");
            inside.maybe("outside", range.outside, segments,
                "only voxels that belong to none of these segments may change", "any");
        });
}

/// A camera, in every edit that has one.
template <class Visitor> void visitView(Visitor& visit, OrthographicView& view)
{
    using namespace editFields;
    visit.group("view", "the camera that looks at the volume, with an orthographic projection",
        [&](auto& inside) {
            inside.field("eyeLps", Presence::Required, view.eyeLps, positionLps,
                "where the viewer stands, in patient coordinates (LPS); only the direction to the "
                "target counts, so the volume is always seen from outside");
            inside.field("targetLps", Presence::Required, view.targetLps, positionLps,
                "the middle of the view plane, in patient coordinates (LPS)");
            inside.field("up", Presence::Required, view.up,
                Point{Number{"", -1000.0, 1000.0, quantum::perDirection}},
                "a direction that points upwards in the view, in patient coordinates (LPS)");
            inside.field("heightMm", Presence::Required, view.heightMm,
                Number{
                    "mm", 1.0 / quantum::perMillimetre, quantum::reachMm, quantum::perMillimetre},
                "how much of the patient the height of the view shows; no voxel depends on it");
            inside.constant("orthographic", Presence::Optional, true,
                "always true, since perspective views are converted");
        });
}

/// What clip box and clip planes hid when the cut was made.
template <class Visitor> void visitHidden(Visitor& visit, ClipHalfSpaces& hidden)
{
    visit.maybe("hidden", hidden, editFields::ClipHalfSpaceList{},
        "what clipping hides, so that the cut neither starts nor cuts there: all places with "
        "normal · place > offset, in patient coordinates (LPS)",
        "nothing");
}

/// The segments that a cut leaves unchanged.
template <class Visitor> void visitProtected(Visitor& visit, ProtectedSegments& protectedSegments)
{
    visit.maybe("spared", protectedSegments, editFields::SegmentList{},
        "segments that are not carved; protected ones are added when the edit is carried out; an "
        "edit that restores has none",
        "the protected segments");
}

/// The field with pen pressures, of every edit whose radius may follow them.
template <class Visitor> void visitPressures(Visitor& visit, PenPressures& pressures)
{
    visit.maybe("pressures", pressures, editFields::PressureList{},
        "for each point of the path, the share of the radius that is used there",
        "the whole radius everywhere");
}

/// A brush and its path, in every edit that has one.
template <class Visitor> void visitPath(Visitor& visit, BrushPath& path)
{
    using namespace editFields;
    visit.field("radiusMm", Presence::Required, path.radiusMm, brushRadius,
        "the radius of the ball or disc, or half the side of the square or cube");
    visit.field("shape", Presence::Optional, path.shape,
        Choice<BrushPath::Shape, 4>{{"ball", "disc", "square", "cube"}},
        "a ball or a cube, or a disc or a square that lies in one plane and is one voxel thick");
    const Point direction{Number{"", -1000.0, 1000.0, quantum::perDirection}};
    visit.maybe("normalLps", path.normalLps, direction,
        "for a disc or square, a direction perpendicular to its plane, which holds the first "
        "point; for a cube, the direction of one of its sides",
        "a ball needs none");
    visit.maybe("sideLps", path.sideLps, direction,
        "for a square or cube, a direction along another side; any part of it that runs along "
        "normalLps is left out",
        "a ball or disc needs none");
    visit.field("pointsLps", Presence::Required, path.pointsLps, PointList{positionLps},
        "the path, which runs straight from point to point, in patient coordinates (LPS)");
    visit.field("lifts", Presence::Optional, path.lifts, PlaceList{},
        "the points, counted from 0, at which the path begins anew instead of running on to them");
    visitPressures(visit, path.pressures);
}

} // namespace core::editSchema
