// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Piece.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/sculpt/LaserStroke.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "core/edits/kinds/sculpt/ToolMask.h"
#include "core/edits/schema/SchemaParts.h"

#include <algorithm>
#include <initializer_list>

namespace core::editSchema {

inline constexpr editFields::Number drillRadius{"mm", 0.01, 200.0, quantum::perMillimetre};
inline constexpr editFields::Number maskSide{"mm", 0.02, 400.0, quantum::perMillimetre};
inline constexpr editFields::Number maskSoftness{"mm", 0.0, 200.0, quantum::perMillimetre};
inline constexpr editFields::Outline maskOutline{
    editFields::Number{"mm", -200.0, 200.0, quantum::perMillimetre}};

template <class Visitor> void visitCarvedLayer(Visitor& visit, int& layer)
{
    visit.field("layer", Presence::Optional, layer, layerNumber,
        "the sculpt layer that is carved; not a muted one");
}

/// What a cut leaves as it is: what is not seen, and segments.
template <class Visitor, class Cut> void visitLeftAlone(Visitor& visit, Cut& edit)
{
    visitHidden(visit, edit.hidden);
    visitProtected(visit, edit.protectedSegments);
}

/// A curve that is drawn on the view, of peel and scissors.
template <class Visitor> void visitCurve(Visitor& visit, std::vector<glm::dvec2>& polygonMm)
{
    visit.field("polygonMm", Presence::Required, polygonMm, viewOutline,
        "a closed curve in the view plane, relative to the target: right, up; a recipe may write a "
        "drill's mask instead");
}

template <class Visitor> void visitSurface(Visitor& visit, double& threshold)
{
    visit.group("surface", "what is seen, hence where a cut starts", [&](auto& inside) {
        inside.field("threshold", Presence::Required, threshold, modalityValue,
            "values from here on are material");
    });
}

/// The mask that is pressed into the volume.
template <class Visitor> void visitMask(Visitor& visit, ToolMask& mask)
{
    using namespace editFields;
    using Kind = ToolMask::Kind;
    visit.group("mask", "what is pressed into the volume, parallel to the view", [&](auto& inside) {
        inside.maybe("polygonMm", mask.polygonMm, maskOutline,
            "a closed curve around the sample: right, up; no shape then", "a shape");
        inside.when(!mask.polygonMm, [&] {
            inside.field("shape", Presence::Required, mask.kind,
                Choice<Kind, 5>{{"circle", "ellipse", "square", "rectangle", "rounded"}},
                "what it looks like to the viewer");
        });
        const auto is = [&mask](std::initializer_list<Kind> kinds) {
            return !mask.polygonMm
                && std::find(kinds.begin(), kinds.end(), mask.kind) != kinds.end();
        };
        inside.when(is({Kind::Circle}), [&] {
            inside.field(
                "radiusMm", Presence::Required, mask.radiusMm, drillRadius, "radius (circle)");
        });
        inside.when(is({Kind::Square}), [&] {
            inside.field("sideMm", Presence::Required, mask.widthMm, maskSide, "its side (square)");
        });
        inside.when(is({Kind::Ellipse, Kind::Rectangle, Kind::Rounded}), [&] {
            inside.field("widthMm", Presence::Required, mask.widthMm, maskSide,
                "from left to right (ellipse, rectangle, rounded)");
            inside.field("heightMm", Presence::Required, mask.heightMm, maskSide,
                "from bottom to top (ellipse, rectangle, rounded)");
        });
        inside.when(is({Kind::Rounded}), [&] {
            inside.field("cornerMm", Presence::Required, mask.cornerMm, maskSide,
                "radius of its corners (rounded)");
        });
        inside.when(is({Kind::Ellipse, Kind::Square, Kind::Rectangle, Kind::Rounded}), [&] {
            inside.field("rotationDegrees", Presence::Optional, mask.rotationDegrees,
                Number{"degrees", -360.0, 360.0, 1024.0}, "counter-clockwise, not of a circle");
        });
        inside.field("softnessMm", Presence::Optional, mask.softnessMm, maskSoftness,
            "over so much from its edge inwards the depth rises to its full value; 0: a sharp "
            "edge");
    });
}

/// The depth of a stroke as a function of pressure, for drill and laser.
template <class Visitor, class Stroke>
void visitDepth(Visitor& visit, Stroke& edit, const char* depthMeaning)
{
    using namespace editFields;
    visit.field("mode", Presence::Optional, edit.mode, Choice<DrillMode, 2>{{"limit", "rate"}},
        "whether depthMm is the most that one stroke cuts, or what it cuts a second");
    visit.field("depthMm", Presence::Required, edit.depthMm, drillDepth, depthMeaning);
    visit.when(edit.mode == DrillMode::Rate, [&] {
        visit.field("floorMm", Presence::Optional, edit.floorMm, drillDepth,
            "no deeper than this below the surface (mode rate)");
    });
    visit.field("pressureExponent", Presence::Optional, edit.pressureExponent, WholeNumber{1, 3},
        "depth = depthMm · pressure to this power");
}

/// The path of the pen, for drill and laser.
template <class Visitor, class Stroke>
void visitSamples(Visitor& visit, Stroke& edit, const char* samplesMeaning)
{
    using namespace editFields;
    visit.field("byTime", Presence::Optional, edit.byTime, Flag{},
        "whether samples are points of a path in time, as a pen reports them, so that how often it "
        "reports does not matter, rather than its corners as they are; in mode rate they always "
        "are");
    visit.field("samples", Presence::Required, edit.samples, SampleList{}, samplesMeaning);
    visitLeftAlone(visit, edit);
}

template <> inline constexpr const char* editName<DrillStroke> = "drill";
template <>
inline constexpr const char* editMeaning<DrillStroke> =
    "Carves with a drill along the view direction, from the visible surface inward.";
template <class Visitor> void visitFields(Visitor& visit, DrillStroke& edit)
{
    using namespace editFields;
    visitCarvedLayer(visit, edit.layer);
    visitView(visit, edit.view);
    visitMask(visit, edit.mask);
    visitDepth(visit, edit, "depth below the surface at full pressure");
    visitSurface(visit, edit.surfaceThreshold);
    visit.field("throughGaps", Presence::Optional, edit.throughGaps, Flag{},
        "whether the drill goes on behind a gap in the material");
    visit.field("guardMm", Presence::Optional, edit.guardMm, drillDepth,
        "parts of the surface under the mask that lie more than the depth and this behind its "
        "middle are seen through a gap and left alone; 0: all are cut");
    visit.field("restore", Presence::Optional, edit.restore, Flag{},
        "whether it fills again what was carved, from the surface towards the viewer");
    visitSamples(visit, edit,
        "pen path in the view plane, relative to the target: right, up, pressure, time");
}

template <> inline constexpr const char* editName<LaserStroke> = "laser";
template <>
inline constexpr const char* editMeaning<LaserStroke> =
    "Carves with a mask that stands across the visible surface and goes in along its normal.";
template <class Visitor> void visitFields(Visitor& visit, LaserStroke& edit)
{
    using namespace editFields;
    visitCarvedLayer(visit, edit.layer);
    visitView(visit, edit.view);
    visitMask(visit, edit.mask);
    visitDepth(visit, edit, "depth along the surface's normal at full pressure");
    visitSurface(visit, edit.surfaceThreshold);
    visit.field("throughGaps", Presence::Optional, edit.throughGaps, Flag{},
        "whether it goes on behind a gap in the material");
    visit.field("restore", Presence::Optional, edit.restore, Flag{},
        "whether it fills again what was carved, from the surface outwards");
    visitSamples(visit, edit,
        "path of the mask's middle in the view plane, relative to the target: right, up, pressure, "
        "time");
}

template <> inline constexpr const char* editName<BrushStroke> = "brush";
template <>
inline constexpr const char* editMeaning<BrushStroke> =
    "Carves along a path, or restores what was carved there.";
template <class Visitor> void visitFields(Visitor& visit, BrushStroke& edit)
{
    visitCarvedLayer(visit, edit.layer);
    visitPath(visit, edit.path);
    visit.field("restore", Presence::Optional, edit.restore, editFields::Flag{},
        "whether carved voxels come back instead");
    visitLeftAlone(visit, edit);
}

template <> inline constexpr const char* editName<PeelCut> = "peel";
template <>
inline constexpr const char* editMeaning<PeelCut> =
    "Takes a shell of even thickness off the visible surface inside a closed curve.";
template <class Visitor> void visitFields(Visitor& visit, PeelCut& edit)
{
    using namespace editFields;
    visitCarvedLayer(visit, edit.layer);
    visitView(visit, edit.view);
    visitCurve(visit, edit.polygonMm);
    visit.field(
        "depthMm", Presence::Required, edit.depthMm, peelDepth, "thickness of what is taken off");
    visitSurface(visit, edit.surfaceThreshold);
    visit.field("throughGaps", Presence::Optional, edit.throughGaps, Flag{},
        "whether it goes on behind a gap in the material");
    visit.field("jumpMm", Presence::Optional, edit.jumpMm, drillDepth,
        "where the surface jumps by more than this it is another one, and only the largest is "
        "peeled; 0: all of them");
    visit.field("restore", Presence::Optional, edit.restore, Flag{},
        "whether it fills again what was carved, from the surface outwards");
    visitLeftAlone(visit, edit);
}

template <> inline constexpr const char* editName<ScissorsCut> = "scissors";
template <>
inline constexpr const char* editMeaning<ScissorsCut> =
    "Cuts out what lies inside a closed curve along the view, or restores what was carved there.";
template <class Visitor> void visitFields(Visitor& visit, ScissorsCut& edit)
{
    using namespace editFields;
    visitCarvedLayer(visit, edit.layer);
    visitView(visit, edit.view);
    visitCurve(visit, edit.polygonMm);
    visit.maybe(
        "depthMm", edit.depthMm, drillDepth, "depth below the surface", "through everything");
    visit.field("firstLayerOnly", Presence::Optional, edit.firstLayerOnly, Flag{},
        "whether it ends at the first gap in the material");
    visitSurface(visit, edit.surfaceThreshold);
    visit.field("restore", Presence::Optional, edit.restore, Flag{},
        "whether it fills again what was carved");
    visitLeftAlone(visit, edit);
}

} // namespace core::editSchema
