// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/layers/ChangeLayer.h"
#include "core/edits/kinds/layers/MergeLayers.h"
#include "core/edits/kinds/layers/MoveLayer.h"
#include "core/edits/kinds/layers/RemoveLayer.h"
#include "core/edits/kinds/layers/SegmentToLayer.h"
#include "core/edits/schema/SchemaParts.h"

namespace core::editSchema {

template <> inline constexpr const char* editName<AddLayer> = "addLayer";
template <>
inline constexpr const char* editMeaning<AddLayer> =
    "Adds an empty sculpt layer. Layer 1 is there from the start; others are numbered 2, 3 … in "
    "the order they are added, and a number is never used again.";
template <class Visitor> void visitFields(Visitor& visit, AddLayer& edit)
{
    visitName(visit, edit.name);
}

template <> inline constexpr const char* editName<ChangeLayer> = "changeLayer";
template <>
inline constexpr const char* editMeaning<ChangeLayer> =
    "Renames or mutes a sculpt layer, or makes it solo; fields left out stay as they are.";
template <class Visitor> void visitFields(Visitor& visit, ChangeLayer& edit)
{
    visitLayer(visit, edit.layer);
    visit.maybe("name", edit.name, editFields::Text{}, "the new name");
    visit.maybe("muted", edit.muted, editFields::Flag{},
        "whether the layer hides nothing, as if it were not there");
    visit.maybe("solo", edit.solo, editFields::Flag{},
        "whether all layers that are not solo hide nothing, as if they were muted");
}

template <> inline constexpr const char* editName<MoveLayer> = "moveLayer";
template <>
inline constexpr const char* editMeaning<MoveLayer> =
    "Puts a sculpt layer at another place of the list.";
template <class Visitor> void visitFields(Visitor& visit, MoveLayer& edit)
{
    visitLayer(visit, edit.layer);
    visit.field("place", Presence::Required, edit.place, editFields::WholeNumber{1, 254},
        "its new place in the list, where 1 is the first");
}

template <> inline constexpr const char* editName<RemoveLayer> = "removeLayer";
template <>
inline constexpr const char* editMeaning<RemoveLayer> =
    "Deletes a sculpt layer with what it has carved; the only one cannot be deleted.";
template <class Visitor> void visitFields(Visitor& visit, RemoveLayer& edit)
{
    visitLayer(visit, edit.layer);
}

template <> inline constexpr const char* editName<MergeLayers> = "mergeLayers";
template <>
inline constexpr const char* editMeaning<MergeLayers> =
    "Adds what a sculpt layer has carved to another layer, and deletes it.";
template <class Visitor> void visitFields(Visitor& visit, MergeLayers& edit)
{
    visit.field("from", Presence::Required, edit.from, layerNumber,
        "the sculpt layer that is added to the other and deleted");
    visit.field("into", Presence::Required, edit.into, layerNumber,
        "the sculpt layer that stays; both must be muted, or neither");
}

template <> inline constexpr const char* editName<SegmentToLayer> = "segmentToLayer";
template <>
inline constexpr const char* editMeaning<SegmentToLayer> =
    "Carves a whole segment into a sculpt layer, or all that does not belong to it.";
template <class Visitor> void visitFields(Visitor& visit, SegmentToLayer& edit)
{
    visitSegment(visit, edit.segment);
    visit.field("layer", Presence::Required, edit.layer, layerNumber,
        "the sculpt layer that is carved; it must not be muted");
    visit.maybe("outside", edit.outside, editFields::Flag{},
        "whether all is carved that belongs neither to the segment nor to a protected one", "no");
}

} // namespace core::editSchema
