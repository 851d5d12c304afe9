// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/layers/SegmentToLayer.h"
#include "core/edits/kinds/parts/SegmentChoice.h"
#include "core/edits/kinds/segments/LayerToSegment.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/edits/kinds/segments/SegmentSeen.h"
#include "core/edits/schema/SchemaParts.h"

namespace core::editSchema {

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
