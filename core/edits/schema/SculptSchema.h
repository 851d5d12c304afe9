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
        "the sculpt layer that is carved; it must not be muted");
}

/// What a cut leaves unchanged: hidden places and protected segments.
template <class Visitor, class Cut> void visitLeftAlone(Visitor& visit, Cut& edit)
{
    visitHidden(visit, edit.hidden);
    visitProtected(visit, edit.protectedSegments);
}

/// A curve that is drawn on the view, of peel and scissors.
template <class Visitor> void visitCurve(Visitor& visit, std::vector<glm::dvec2>& polygonMm)
{
    visit.field("polygonMm", Presence::Required, polygonMm, viewOutline,
        "a closed curve in the view plane, as points to the right and up from the target; a recipe "
        "may give a drill's mask instead");
}

template <class Visitor> void visitSurface(Visitor& visit, double& threshold)
{
    visit.group(
        "surface", "what counts as the visible surface, at which a cut starts", [&](auto& inside) {
            inside.field("threshold", Presence::Required, threshold, modalityValue,
                "the least value that counts as material");
        });
}

/// The mask that is pressed into the volume.
template <class Visitor> void visitMask(Visitor& visit, ToolMask& mask)
{
    using namespace editFields;
    using Kind = ToolMask::Kind;
    visit.group("mask", "the shape that is pressed into the volume, parallel to the view",
        [&](auto& inside) {
            inside.maybe("polygonMm", mask.polygonMm, maskOutline,
                "a closed curve around the sample, as points to the right and up; no shape is "
                "given then",
                "the shape");
            inside.when(!mask.polygonMm, [&] {
                inside.field("shape", Presence::Required, mask.kind,
                    Choice<Kind, 5>{{"circle", "ellipse", "square", "rectangle", "rounded"}},
                    "the outline of the mask as the viewer sees it");
            });
            const auto is = [&mask](std::initializer_list<Kind> kinds) {
                return !mask.polygonMm
                    && std::find(kinds.begin(), kinds.end(), mask.kind) != kinds.end();
            };
            inside.when(is({Kind::Circle}), [&] {
                inside.field("radiusMm", Presence::Required, mask.radiusMm, drillRadius,
                    "the radius of a circle");
            });
            inside.when(is({Kind::Square}), [&] {
                inside.field(
                    "sideMm", Presence::Required, mask.widthMm, maskSide, "the side of a square");
            });
            inside.when(is({Kind::Ellipse, Kind::Rectangle, Kind::Rounded}), [&] {
                inside.field("widthMm", Presence::Required, mask.widthMm, maskSide,
                    "the width of an ellipse, a rectangle or a rounded rectangle");
                inside.field("heightMm", Presence::Required, mask.heightMm, maskSide,
                    "the height of an ellipse, a rectangle or a rounded rectangle");
            });
            inside.when(is({Kind::Rounded}), [&] {
                inside.field("cornerMm", Presence::Required, mask.cornerMm, maskSide,
                    "the radius of the corners of a rounded rectangle");
            });
            inside.when(is({Kind::Ellipse, Kind::Square, Kind::Rectangle, Kind::Rounded}), [&] {
                inside.field("rotationDegrees", Presence::Optional, mask.rotationDegrees,
                    Number{"degrees", -360.0, 360.0, 1024.0},
                    "how far the mask is turned counter-clockwise; not for a circle");
            });
            inside.field("softnessMm", Presence::Optional, mask.softnessMm, maskSoftness,
                "how far from the mask's edge inwards the depth takes to rise to its full value; 0 "
                "makes a sharp edge");
        });
}

/// The depth of a stroke as a function of pressure, for drill and laser.
template <class Visitor, class Stroke>
void visitDepth(Visitor& visit, Stroke& edit, const char* depthMeaning)
{
    using namespace editFields;
    visit.field("mode", Presence::Optional, edit.mode, Choice<DrillMode, 2>{{"limit", "rate"}},
        "with limit, depthMm is the most that one stroke cuts; with rate, it is what a stroke cuts "
        "per second");
    visit.field("depthMm", Presence::Required, edit.depthMm, drillDepth, depthMeaning);
    visit.when(edit.mode == DrillMode::Rate, [&] {
        visit.field("floorMm", Presence::Optional, edit.floorMm, drillDepth,
            "for mode rate, the greatest depth below the surface");
    });
    visit.field("pressureExponent", Presence::Optional, edit.pressureExponent, WholeNumber{1, 3},
        "the depth is depthMm times the pressure raised to this power");
}

/// The path of the pen, for drill and laser.
template <class Visitor, class Stroke>
void visitSamples(Visitor& visit, Stroke& edit, const char* samplesMeaning)
{
    using namespace editFields;
    visit.field("byTime", Presence::Optional, edit.byTime, Flag{},
        "whether the path is sampled anew by time, so that it does not matter how often the pen "
        "reports; otherwise samples are its corners as they are; mode rate always does this");
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
    visitDepth(visit, edit, "the depth below the surface at full pressure");
    visitSurface(visit, edit.surfaceThreshold);
    visit.field("throughGaps", Presence::Optional, edit.throughGaps, Flag{},
        "whether the drill goes on behind a gap in the material");
    visit.field("guardMm", Presence::Optional, edit.guardMm, drillDepth,
        "parts of the surface under the mask that lie behind its middle by more than the depth "
        "plus this count as seen through a gap and are left alone; 0 cuts all of them");
    visit.field("restore", Presence::Optional, edit.restore, Flag{},
        "whether it fills again what was carved, from the surface towards the viewer");
    visitSamples(visit, edit,
        "the pen's path in the view plane; each point says how far right and up from the target it "
        "is, the pressure and the time");
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
    visitDepth(visit, edit, "the depth along the surface's normal at full pressure");
    visitSurface(visit, edit.surfaceThreshold);
    visit.field("throughGaps", Presence::Optional, edit.throughGaps, Flag{},
        "whether it goes on behind a gap in the material");
    visit.field("restore", Presence::Optional, edit.restore, Flag{},
        "whether it fills again what was carved, from the surface outwards");
    visitSamples(visit, edit,
        "the path of the mask's middle in the view plane; each point says how far right and up "
        "from the target it is, the pressure and the time");
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
    visit.field("depthMm", Presence::Required, edit.depthMm, peelDepth,
        "the thickness of what is taken off");
    visitSurface(visit, edit.surfaceThreshold);
    visit.field("throughGaps", Presence::Optional, edit.throughGaps, Flag{},
        "whether it goes on behind a gap in the material");
    visit.field("jumpMm", Presence::Optional, edit.jumpMm, drillDepth,
        "a jump by more than this separates one surface from the next, and only the largest is "
        "peeled; 0 peels all of them");
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
        "depthMm", edit.depthMm, drillDepth, "the depth below the surface", "through everything");
    visit.field("firstLayerOnly", Presence::Optional, edit.firstLayerOnly, Flag{},
        "whether it ends at the first gap in the material");
    visitSurface(visit, edit.surfaceThreshold);
    visit.field("restore", Presence::Optional, edit.restore, Flag{},
        "whether it fills again what was carved");
    visitLeftAlone(visit, edit);
}

} // namespace core::editSchema
