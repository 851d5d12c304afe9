// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/schema/SchemaParts.h"

namespace core::editSchema {

template <> inline constexpr const char* editName<SeedStroke> = "seed";
template <>
inline constexpr const char* editMeaning<SeedStroke> =
    "Marks the voxels nearest to some points as seeds of a segment; the next growth starts there.";
template <class Visitor> void visitFields(Visitor& visit, SeedStroke& edit)
{
    visit.field("segment", Presence::Required, edit.segment, segmentNumber, "which segment");
    visit.field("pointsLps", Presence::Required, edit.pointsLps, editFields::PointList{positionLps},
        "patient coordinates (LPS), inside the volume");
}

template <> inline constexpr const char* editName<GrowSteps> = "grow";
template <>
inline constexpr const char* editMeaning<GrowSteps> =
    "Grows all seeded segments breadth-first through voxels whose value lies in an interval.";
template <class Visitor> void visitFields(Visitor& visit, GrowSteps& edit)
{
    visit.field(
        "lower", Presence::Required, edit.lower, modalityValue, "smallest value, inclusive");
    visit.field(
        "upper", Presence::Required, edit.upper, modalityValue, "greatest value, inclusive");
    visit.field("connectivity", Presence::Optional, edit.connectivity, editFields::Connectivity{},
        "neighbours of a voxel: those that share a face, a face or an edge, or a corner too");
    visit.field("steps", Presence::Required, edit.steps, editFields::StepCount{},
        "rings to add after the seeds, or until nothing is left to add");
    visit.field("overwriteUnlocked", Presence::Optional, edit.overwriteUnlocked, editFields::Flag{},
        "whether growth takes voxels of other segments that are not locked");
}

template <> inline constexpr const char* editName<ShrinkSteps> = "shrink";
template <>
inline constexpr const char* editMeaning<ShrinkSteps> =
    "Takes back what growth added last, ring by ring; what was painted or there before stays.";
template <class Visitor> void visitFields(Visitor& visit, ShrinkSteps& edit)
{
    visit.field("steps", Presence::Required, edit.steps, editFields::StepCount{"toSeeds"},
        "rings to take back, or all but the accepted seeds");
}

template <> inline constexpr const char* editName<PaintStroke> = "paint";
template <>
inline constexpr const char* editMeaning<PaintStroke> =
    "Paints a segment along a path, or erases it there.";
template <class Visitor> void visitFields(Visitor& visit, PaintStroke& edit)
{
    visit.field("segment", Presence::Required, edit.segment, segmentNumber, "which segment");
    visitPath(visit, edit.path);
    visit.field("erase", Presence::Optional, edit.erase, editFields::Flag{},
        "whether voxels of the segment are taken away instead");
    visit.maybe(
        "lower", edit.lower, modalityValue, "only voxels from this value on, inclusive", "any");
    visit.maybe(
        "upper", edit.upper, modalityValue, "only voxels up to this value, inclusive", "any");
    visit.field("overwriteUnlocked", Presence::Optional, edit.overwriteUnlocked, editFields::Flag{},
        "whether voxels of other segments that are not locked are taken");
    visit.field("seeds", Presence::Optional, edit.seeds, editFields::Flag{},
        "whether what is painted takes part in growth: the next one goes on from there");
}

/// Which segment receives voxels.
template <class Visitor> void visitTarget(Visitor& visit, SegmentChoice& target)
{
    visit.maybe(
        "segment", target.segment, segmentNumber, "which segment; no name then", "a new one");
    visit.when(!target.segment, [&] {
        visit.field("name", Presence::Required, target.name, editFields::Text{},
            "of the new segment (no segment given)");
        visit.field("color", Presence::Required, target.rgb, editFields::Colour{},
            "of the new segment (no segment given)");
    });
}

template <> inline constexpr const char* editName<LayerToSegment> = "layerToSegment";
template <>
inline constexpr const char* editMeaning<LayerToSegment> =
    "Gives what a sculpt layer has carved (coverage of one half and more) to a segment; does "
    "nothing where it takes no voxel.";
template <class Visitor> void visitFields(Visitor& visit, LayerToSegment& edit)
{
    visit.field("layer", Presence::Required, edit.layer, layerNumber, "which sculpt layer");
    visitTarget(visit, edit.target);
    visit.field("overwriteUnlocked", Presence::Optional, edit.overwriteUnlocked, editFields::Flag{},
        "whether voxels of other segments that are not locked are taken");
}

template <> inline constexpr const char* editName<SegmentToLayer> = "segmentToLayer";
template <>
inline constexpr const char* editMeaning<SegmentToLayer> =
    "Carves what a segment holds, whole, into a sculpt layer.";
template <class Visitor> void visitFields(Visitor& visit, SegmentToLayer& edit)
{
    visit.field("segment", Presence::Required, edit.segment, segmentNumber, "which segment");
    visit.field("layer", Presence::Required, edit.layer, layerNumber,
        "the sculpt layer that is carved; not a muted one");
}

template <> inline constexpr const char* editName<SegmentSeen> = "segmentSeen";
template <>
inline constexpr const char* editMeaning<SegmentSeen> =
    "Gives what is seen, from wherever, to a segment: what no layer carves, inside the clip "
    "region, with values in an interval; does nothing where it takes no voxel.";
template <class Visitor> void visitFields(Visitor& visit, SegmentSeen& edit)
{
    visitTarget(visit, edit.target);
    visit.maybe(
        "lower", edit.lower, modalityValue, "only voxels from this value on, inclusive", "any");
    visit.maybe(
        "upper", edit.upper, modalityValue, "only voxels up to this value, inclusive", "any");
    visitHidden(visit, edit.hidden);
    visit.field("overwriteUnlocked", Presence::Optional, edit.overwriteUnlocked, editFields::Flag{},
        "whether voxels of other segments that are not locked are taken");
}

} // namespace core::editSchema
