// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/views/Bookmarks.h"
#include "core/edits/kinds/views/Measurements.h"
#include "core/edits/schema/SchemaParts.h"

namespace core::editSchema {

inline constexpr editFields::ThingNumber bookmarkNumber{{1, 1000000}, Thing::Bookmark};
inline constexpr editFields::ThingNumber measurementNumber{{1, 1000000}, Thing::Measurement};

/// Whether what is measured was drawn over a picture without depth.
template <class Visitor> void visitProjected(Visitor& visit, std::optional<bool>& projected)
{
    visit.maybe("projected", projected, editFields::Flag{},
        "whether it was drawn over a thick slab or a projection, so that its lengths are those of "
        "the projection",
        "no");
}

template <> inline constexpr const char* editName<AddBookmark> = "addBookmark";
template <>
inline constexpr const char* editMeaning<AddBookmark> =
    "Keeps a view of the patient by name. Bookmarks are numbered 1, 2, 3 … in the order they are "
    "added.";
template <class Visitor> void visitFields(Visitor& visit, AddBookmark& edit)
{
    visit.field(
        "name", Presence::Required, edit.name, editFields::Text{}, "the name that the menu shows");
    visitView(visit, edit.view);
    visit.field("crosshairLps", Presence::Required, edit.crosshairLps, positionLps,
        "where the slices cross, in patient coordinates (LPS)");
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
        "one end, at its true place, in patient coordinates (LPS)");
    visit.field("toLps", Presence::Required, edit.toLps, positionLps,
        "the other end, at its true place, in patient coordinates (LPS)");
    visit.maybe("piece", edit.piece, editFields::ThingNumber{{1, 1000000}, Thing::Piece},
        "the piece that it is shown on in 3D", "none");
    visitProjected(visit, edit.projected);
}

template <> inline constexpr const char* editName<Annotate> = "annotate";
template <>
inline constexpr const char* editMeaning<Annotate> =
    "Keeps an angle, a region, a place whose value is read, an arrow or a text. They are numbered "
    "with the distances, in the order in which they are added.";
template <class Visitor> void visitFields(Visitor& visit, Annotate& edit)
{
    visit.field("kind", Presence::Required, edit.kind,
        editFields::Choice<Measurement::Kind, measurementWords.size()>{measurementWords},
        "what is kept; addMeasurement keeps distances");
    visit.field("pointsLps", Presence::Required, edit.pointsLps, editFields::PointList{positionLps},
        "for an angle one end, the vertex and the other end; for an ellipse the centre and the "
        "ends of two half axes; for a rectangle a corner and the two beside it; for an outline 3 "
        "to 512 corners in one plane; for a ball the centre and a point of its surface; for a "
        "probe or a text the place; for an arrow the tip and the other end; all at their true "
        "places, in patient coordinates (LPS)");
    visit.maybe("text", edit.text, editFields::Text{}, "what an arrow or a text says", "nothing");
    visit.maybe("piece", edit.piece, editFields::ThingNumber{{1, 1000000}, Thing::Piece},
        "the piece that it is shown on in 3D", "none");
    visitProjected(visit, edit.projected);
}

template <> inline constexpr const char* editName<MoveMeasurement> = "moveMeasurement";
template <>
inline constexpr const char* editMeaning<MoveMeasurement> =
    "Gives what was measured or noted other points; it keeps its number.";
template <class Visitor> void visitFields(Visitor& visit, MoveMeasurement& edit)
{
    visit.field("measurement", Presence::Required, edit.measurement, measurementNumber,
        "which measurement");
    visit.field("pointsLps", Presence::Required, edit.pointsLps, editFields::PointList{positionLps},
        "the points that its kind has, for a distance both ends, at their true places, in patient "
        "coordinates (LPS)");
}

template <> inline constexpr const char* editName<RemoveMeasurement> = "removeMeasurement";
template <>
inline constexpr const char* editMeaning<RemoveMeasurement> = "Forgets what was measured or noted.";
template <class Visitor> void visitFields(Visitor& visit, RemoveMeasurement& edit)
{
    visit.field("measurement", Presence::Required, edit.measurement, measurementNumber,
        "which measurement");
}

} // namespace core::editSchema
