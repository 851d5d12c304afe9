// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/layers/ChangeLayer.h"
#include "core/edits/kinds/layers/MergeLayers.h"
#include "core/edits/kinds/layers/MoveLayer.h"
#include "core/edits/kinds/layers/RemoveLayer.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/edits/kinds/segments/MoveSegment.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/edits/kinds/views/Bookmarks.h"
#include "core/edits/kinds/views/Measurements.h"
#include "core/edits/schema/SchemaParts.h"

namespace core::editSchema {

inline constexpr editFields::WholeNumber bookmarkNumber{1, 1000000};
inline constexpr editFields::WholeNumber measurementNumber{1, 1000000};

template <> inline constexpr const char* editName<AddSegment> = "addSegment";
template <>
inline constexpr const char* editMeaning<AddSegment> =
    "Adds an empty segment. Segments are numbered 1, 2, 3 … in the order they are added, and a "
    "number is never used again.";
template <class Visitor> void visitFields(Visitor& visit, AddSegment& edit)
{
    visit.field("name", Presence::Required, edit.name, editFields::Text{}, "shown in the list");
    visit.field("color", Presence::Required, edit.rgb, editFields::Colour{}, "display colour");
    visit.field("code", Presence::Optional, edit.code, editFields::Code{},
        "what it is, e.g. [\"SCT\", \"89546000\", \"Skull\"]; [] is \"not coded yet\"");
}

template <> inline constexpr const char* editName<ChangeSegment> = "changeSegment";
template <>
inline constexpr const char* editMeaning<ChangeSegment> =
    "Renames, recolours, codes or locks a segment, or protects it from sculpting; fields left out "
    "stay as they are.";
template <class Visitor> void visitFields(Visitor& visit, ChangeSegment& edit)
{
    visit.field("segment", Presence::Required, edit.segment, segmentNumber, "which segment");
    visit.maybe("name", edit.name, editFields::Text{}, "new name");
    visit.maybe("color", edit.rgb, editFields::Colour{}, "new display colour");
    visit.maybe("code", edit.code, editFields::Code{}, "what it is; [] takes the code away");
    visit.maybe("locked", edit.locked, editFields::Flag{},
        "whether its voxels are kept from every tool and growth");
    visit.maybe("protected", edit.uncarvable, editFields::Flag{},
        "whether no sculpting tool carves where it is");
}

template <> inline constexpr const char* editName<MoveSegment> = "moveSegment";
template <>
inline constexpr const char* editMeaning<MoveSegment> =
    "Puts a segment at another place of the list.";
template <class Visitor> void visitFields(Visitor& visit, MoveSegment& edit)
{
    visit.field("segment", Presence::Required, edit.segment, segmentNumber, "which segment");
    visit.field("place", Presence::Required, edit.place, segmentNumber,
        "its new place in the list, 1 is the first");
}

template <> inline constexpr const char* editName<RemoveSegment> = "removeSegment";
template <>
inline constexpr const char* editMeaning<RemoveSegment> =
    "Deletes a segment that is not locked, with its voxels and seeds.";
template <class Visitor> void visitFields(Visitor& visit, RemoveSegment& edit)
{
    visit.field("segment", Presence::Required, edit.segment, segmentNumber, "which segment");
}

template <> inline constexpr const char* editName<AddLayer> = "addLayer";
template <>
inline constexpr const char* editMeaning<AddLayer> =
    "Adds an empty sculpt layer. Layer 1 is there from the start; others are numbered 2, 3 … in "
    "the order they are added, and a number is never used again.";
template <class Visitor> void visitFields(Visitor& visit, AddLayer& edit)
{
    visit.field("name", Presence::Required, edit.name, editFields::Text{}, "shown in the list");
}

template <> inline constexpr const char* editName<ChangeLayer> = "changeLayer";
template <>
inline constexpr const char* editMeaning<ChangeLayer> =
    "Renames or mutes a sculpt layer, or has it count alone; fields left out stay as they are.";
template <class Visitor> void visitFields(Visitor& visit, ChangeLayer& edit)
{
    visit.field("layer", Presence::Required, edit.layer, layerNumber, "which sculpt layer");
    visit.maybe("name", edit.name, editFields::Text{}, "new name");
    visit.maybe("muted", edit.muted, editFields::Flag{},
        "whether it hides nothing, as if it were not there");
    visit.maybe("solo", edit.solo, editFields::Flag{},
        "whether all layers that are not solo hide nothing, as if muted");
}

template <> inline constexpr const char* editName<MoveLayer> = "moveLayer";
template <>
inline constexpr const char* editMeaning<MoveLayer> =
    "Puts a sculpt layer at another place of the list.";
template <class Visitor> void visitFields(Visitor& visit, MoveLayer& edit)
{
    visit.field("layer", Presence::Required, edit.layer, layerNumber, "which sculpt layer");
    visit.field("place", Presence::Required, edit.place, layerNumber,
        "its new place in the list, 1 is the first");
}

template <> inline constexpr const char* editName<RemoveLayer> = "removeLayer";
template <>
inline constexpr const char* editMeaning<RemoveLayer> =
    "Deletes a sculpt layer with what it has carved; not the only one.";
template <class Visitor> void visitFields(Visitor& visit, RemoveLayer& edit)
{
    visit.field("layer", Presence::Required, edit.layer, layerNumber, "which sculpt layer");
}

template <> inline constexpr const char* editName<MergeLayers> = "mergeLayers";
template <>
inline constexpr const char* editMeaning<MergeLayers> =
    "Lays what a sculpt layer has carved into another one, and deletes it.";
template <class Visitor> void visitFields(Visitor& visit, MergeLayers& edit)
{
    visit.field("from", Presence::Required, edit.from, layerNumber,
        "the sculpt layer that is laid into the other and deleted");
    visit.field("into", Presence::Required, edit.into, layerNumber,
        "the sculpt layer that stays; muted if the other is, and not if it is not");
}

template <> inline constexpr const char* editName<AddBookmark> = "addBookmark";
template <>
inline constexpr const char* editMeaning<AddBookmark> =
    "Keeps a view of the patient by name. Bookmarks are numbered 1, 2, 3 … in the order they are "
    "added.";
template <class Visitor> void visitFields(Visitor& visit, AddBookmark& edit)
{
    visit.field("name", Presence::Required, edit.name, editFields::Text{}, "shown in the menu");
    visitView(visit, edit.view);
    visit.field("crosshairLps", Presence::Required, edit.crosshairLps, positionLps,
        "where the slices cross, patient coordinates (LPS)");
}

template <> inline constexpr const char* editName<RemoveBookmark> = "removeBookmark";
template <>
inline constexpr const char* editMeaning<RemoveBookmark> = "Forgets a view that was kept.";
template <class Visitor> void visitFields(Visitor& visit, RemoveBookmark& edit)
{
    visit.field("bookmark", Presence::Required, edit.bookmark, bookmarkNumber, "which bookmark");
}

template <> inline constexpr const char* editName<AddMeasurement> = "addMeasurement";
template <>
inline constexpr const char* editMeaning<AddMeasurement> =
    "Keeps the distance between two points. Measurements are numbered 1, 2, 3 … in the order they "
    "are added.";
template <class Visitor> void visitFields(Visitor& visit, AddMeasurement& edit)
{
    visit.field("fromLps", Presence::Required, edit.fromLps, positionLps,
        "one end, at its true place, patient coordinates (LPS)");
    visit.field("toLps", Presence::Required, edit.toLps, positionLps,
        "the other end, at its true place, patient coordinates (LPS)");
    visit.maybe("piece", edit.piece, editFields::WholeNumber{1, 1000000},
        "the piece that it is shown on in 3D", "none");
}

template <> inline constexpr const char* editName<RemoveMeasurement> = "removeMeasurement";
template <>
inline constexpr const char* editMeaning<RemoveMeasurement> = "Forgets a distance that was kept.";
template <class Visitor> void visitFields(Visitor& visit, RemoveMeasurement& edit)
{
    visit.field("measurement", Presence::Required, edit.measurement, measurementNumber,
        "which measurement");
}

} // namespace core::editSchema
