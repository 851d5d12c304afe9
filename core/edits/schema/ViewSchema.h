// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/views/Bookmarks.h"
#include "core/edits/kinds/views/Measurements.h"
#include "core/edits/schema/SchemaParts.h"

namespace core::editSchema {

inline constexpr editFields::ThingNumber bookmarkNumber{{1, 1000000}, Thing::Bookmark};
inline constexpr editFields::ThingNumber measurementNumber{{1, 1000000}, Thing::Measurement};

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
    visit.maybe("piece", edit.piece, editFields::ThingNumber{{1, 1000000}, Thing::Piece},
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
