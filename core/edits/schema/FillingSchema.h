// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/filling/EvolveContour.h"
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/edits/kinds/filling/FloodFill.h"
#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/edits/kinds/filling/SegmentScissors.h"
#include "core/edits/schema/EditPlanes.h"
#include "core/edits/schema/SchemaParts.h"

namespace core::editSchema {

/// The JSON names of the axes, in the order of SliceAxis.
inline constexpr editFields::Choice<SliceAxis, 3> sliceAxisNames{{"i", "j", "k"}};

template <> inline constexpr const char* editName<FillBetweenSlices> = "fillBetweenSlices";
template <>
inline constexpr const char* editMeaning<FillBetweenSlices> =
    "Fills a segment that is not locked and was drawn on some slices, or on planes of several "
    "directions, between these, by shape-based interpolation. Takes only voxels that no segment "
    "has; does nothing if no slice between drawn ones is empty.";
template <class Visitor> void visitFields(Visitor& visit, FillBetweenSlices& edit)
{
    visitSegment(visit, edit.segment);
    visit.maybe("planes", edit.planes,
        editFields::DrawnPlaneList{positionLps,
            editFields::Point{editFields::Number{"", -1000.0, 1000.0, quantum::perDirection}}},
        "planes of any directions on which the segment was drawn, each one voxel thick, as a place "
        "in it and a direction perpendicular to it, in patient coordinates (LPS); those on which "
        "nothing of the segment lies are left out",
        "the slices across one axis");
    visit.when(!edit.planes, [&] {
        visit.maybe("axis", edit.axis, sliceAxisNames,
            "the index axis across the slices: i for columns, j for rows, k for the acquired "
            "slices; not given with planes",
            "the one across which the smallest share of slices has voxels of the segment");
    });
    visitEditable(visit, edit.editable);
}

template <> inline constexpr const char* editName<FloodFill> = "floodFill";
template <>
inline constexpr const char* editMeaning<FloodFill> =
    "Gives a segment the voxels that are connected with a place and differ in value from it by no "
    "more than a tolerance, or takes away the connected part of the segment there; within a slice "
    "or in all directions.";
template <class Visitor> void visitFields(Visitor& visit, FloodFill& edit)
{
    visitSegment(visit, edit.segment);
    visit.field("placeLps", Presence::Required, edit.placeLps, positionLps,
        "a place in the voxel with which filling begins, in patient coordinates (LPS)");
    visit.maybe("within", edit.within, sliceAxisNames,
        "only in the slice across this index axis: i for columns, j for rows, k for the acquired "
        "slices",
        "in all directions");
    visit.when(!edit.within, [&] {
        visit.maybe("normalLps", edit.normalLps,
            editFields::Point{editFields::Number{"", -1000.0, 1000.0, quantum::perDirection}},
            "only in the slice through the place that is perpendicular to this direction, which "
            "may lie along any plane and is one voxel thick; not given with within",
            "in all directions");
    });
    visit.field("corners", Presence::Optional, edit.corners, editFields::Flag{},
        "whether voxels that share only an edge or a corner are connected too");
    visit.field("erase", Presence::Optional, edit.erase, editFields::Flag{},
        "whether the connected part of the segment is taken away instead");
    visit.when(!edit.erase, [&] {
        visit.field("tolerance", Presence::Required, edit.tolerance,
            editFields::Number{"modality units", 0.0, quantum::unbounded},
            "how far values may differ from the one at the place; not given with erase");
        visitOverwrite(visit, edit.overwriteUnlocked);
    });
    visitEditable(visit, edit.editable);
}

template <> inline constexpr const char* editName<SegmentScissors> = "segmentScissors";
template <>
inline constexpr const char* editMeaning<SegmentScissors> =
    "Gives a segment what lies under a closed curve along the view, or takes it away there; or the "
    "same with all that does not lie under it.";
template <class Visitor> void visitFields(Visitor& visit, SegmentScissors& edit)
{
    visitSegment(visit, edit.segment);
    visitView(visit, edit.view);
    visit.field("polygonMm", Presence::Required, edit.polygonMm, viewOutline,
        "a closed curve in the view plane, as points to the right and up from the target");
    visit.field("erase", Presence::Optional, edit.erase, editFields::Flag{},
        "whether voxels of the segment are taken away instead");
    visit.field("outside", Presence::Optional, edit.outside, editFields::Flag{},
        "whether the edit is about what does not lie under the curve");
    visit.when(!edit.outside, [&] {
        visit.maybe("depthMm", edit.depthMm, drillDepth,
            "how far the edit reaches behind what each line of sight meets first: the segments "
            "while erasing, otherwise voxels of the given values; not given with outside",
            "through everything");
    });
    visit.when(edit.erase, [&] {
        visit.maybe("others", edit.others, editFields::SegmentList{},
            "further segments that are erased too, none of them locked; only given with erase",
            "none");
    });
    visitOnlyValues(visit, edit.lower, edit.upper);
    visit.when(!edit.erase, [&] { visitOverwrite(visit, edit.overwriteUnlocked); });
    visitHidden(visit, edit.hidden);
    visitEditable(visit, edit.editable);
}

template <> inline constexpr const char* editName<MirrorSegment> = "mirrorSegment";
template <>
inline constexpr const char* editMeaning<MirrorSegment> =
    "Mirrors a segment that is not locked about a plane across the grid's axis that is nearest to "
    "a "
    "direction of the patient. Takes only voxels that no segment has.";
template <class Visitor> void visitFields(Visitor& visit, MirrorSegment& edit)
{
    visitSegment(visit, edit.segment);
    visit.field("sides", Presence::Required, edit.sides,
        editFields::Choice<MirroredSides, 3>{
            {"rightLeft", "anteriorPosterior", "inferiorSuperior"}},
        "which sides of the patient change places");
    visit.maybe("placeLps", edit.placeLps, positionLps,
        "a place in the plane, in patient coordinates (LPS); the plane goes through the nearest "
        "voxel's centre or halfway between two",
        "the middle of the volume");
    visit.field("keep", Presence::Optional, edit.keep, editFields::Flag{},
        "whether the segment keeps what it has, beside its mirror image");
    visitEditable(visit, edit.editable);
}

template <> inline constexpr const char* editName<EvolveContour> = "evolveContour";
template <>
inline constexpr const char* editMeaning<EvolveContour> =
    "Lets the contour of a segment that is not locked evolve generation by generation, from the "
    "segment as it stands or from bubbles: outwards where values lie in an interval, inwards "
    "where they do not, kept at edges and kept smooth. Evolving again goes on where it stopped.";
template <class Visitor> void visitFields(Visitor& visit, EvolveContour& edit)
{
    using namespace editFields;
    constexpr WholeNumber share{0, 100};
    visitSegment(visit, edit.segment);
    visit.maybe("lower", edit.lower, modalityValue, "the least value of the interval, inclusive",
        "no least value");
    visit.maybe("upper", edit.upper, modalityValue, "the greatest value of the interval, inclusive",
        "no greatest value");
    visit.field("softness", Presence::Optional, edit.softness,
        Number{"modality units", 0.0, quantum::unbounded},
        "how far inside or outside the interval a value must lie to count in full");
    visit.field(
        "region", Presence::Optional, edit.region, share, "how much the values of voxels count");
    visit.field("edge", Presence::Optional, edit.edge, share,
        "how much shorter a contour counts along edges");
    visit.when(edit.edge > 0, [&] {
        visit.field("edgeGradient", Presence::Required, edit.edgeGradient,
            Number{"modality units/mm", 0.0, quantum::unbounded},
            "the gradient of an edge that counts half; only given if edge is greater than 0");
    });
    visit.field("smoothness", Presence::Optional, edit.smoothness, share,
        "how much it counts that the contour is short, and so smooth");
    visit.maybe("bubbleLps", edit.bubbleLps, positionLps,
        "a place around which the segment first receives a ball, in patient coordinates (LPS)",
        "the contour begins with the segment as it stands");
    visit.when(edit.bubbleLps.has_value(), [&] {
        visit.field("bubbleMm", Presence::Required, edit.bubbleMm, brushRadius,
            "the radius of that ball; only given with bubbleLps");
        visit.maybe("furtherBubblesLps", edit.furtherBubblesLps, PointList{positionLps},
            "further places, around each of which the segment receives such a ball; only given "
            "with bubbleLps",
            "there is one ball");
    });
    visit.field("generations", Presence::Optional, edit.generations,
        WholeNumber{1, mostContourGenerations},
        "how many voxels the contour moves at most; it stops earlier where nothing changes");
    visit.maybe("round", edit.round, Flag{},
        "whether a contour that nothing stops grows round, since it crosses edges of voxels too in "
        "every second generation",
        "false, so that it becomes an octahedron");
    visit.maybe("erase", edit.erase, Flag{},
        "whether a part of the segment evolves instead, which is taken away from it: outwards "
        "where "
        "values lie in the interval, within the segment, from the bubble, or from all around the "
        "segment without one",
        "false");
    visit.when(!edit.erase.value_or(false), [&] { visitOverwrite(visit, edit.overwriteUnlocked); });
    visitEditable(visit, edit.editable);
}

} // namespace core::editSchema
