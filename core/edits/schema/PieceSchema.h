// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/pieces/ChangePiece.h"
#include "core/edits/kinds/pieces/CutPiece.h"
#include "core/edits/kinds/pieces/PastePiece.h"
#include "core/edits/kinds/pieces/RemovePiece.h"
#include "core/edits/kinds/pieces/SendPiecesHome.h"
#include "core/edits/schema/SchemaParts.h"

namespace core::editSchema {

inline constexpr editFields::ThingNumber pieceNumber{{1, 1000000}, Thing::Piece};
inline constexpr editFields::Number pieceTurn{"degrees", -360.0, 360.0, quantum::perDegree};
inline constexpr editFields::Number pieceZoom{"", 0.125, 16.0, quantum::perZoom};

template <class Visitor> void visitPivot(Visitor& visit, std::optional<glm::dvec3>& pivotLps)
{
    visit.maybe("pivotLps", pivotLps, positionLps,
        "the point about which the piece turns and is zoomed, at its true place, in patient "
        "coordinates (LPS)",
        "the middle of the volume");
}

template <> inline constexpr const char* editName<CutPiece> = "cutPiece";
template <>
inline constexpr const char* editMeaning<CutPiece> =
    "Makes what a sculpt layer has cut out a piece, which can be shown elsewhere. Pieces are "
    "numbered 1, 2, 3 … in the order they are made, and a number is never used again.";
template <class Visitor> void visitFields(Visitor& visit, CutPiece& edit)
{
    visit.field("layer", Presence::Optional, edit.layer, layerNumber,
        "the sculpt layer that cut it out; it must not belong to another piece");
    visitName(visit, edit.name);
    visitPivot(visit, edit.pivotLps);
}

template <> inline constexpr const char* editName<PastePiece> = "pastePiece";
template <>
inline constexpr const char* editMeaning<PastePiece> =
    "Shows a segment as a piece of its own, in addition to its true place.";
template <class Visitor> void visitFields(Visitor& visit, PastePiece& edit)
{
    visitSegment(visit, edit.segment);
    visitName(visit, edit.name);
    visitPivot(visit, edit.pivotLps);
    visit.field("offsetMm", Presence::Optional, edit.pose.offsetMm, positionLps,
        "how far the piece is moved from its true place, along the patient's axes (LPS)");
    visit.field("rotationDegrees", Presence::Optional, edit.pose.rotationDegrees,
        editFields::Point{pieceTurn},
        "a vector whose direction is the axis (LPS) and whose length is the angle: [0, 0, 90] "
        "turns about S");
    visit.field("zoom", Presence::Optional, edit.pose.zoom, pieceZoom,
        "how many times as large as its true size the piece is shown");
}

template <> inline constexpr const char* editName<ChangePiece> = "changePiece";
template <>
inline constexpr const char* editMeaning<ChangePiece> =
    "Renames, moves, turns or zooms a piece; fields left out stay as they are.";
template <class Visitor> void visitFields(Visitor& visit, ChangePiece& edit)
{
    visit.field("piece", Presence::Required, edit.piece, pieceNumber, "which piece");
    visit.maybe("name", edit.name, editFields::Text{}, "the new name");
    visit.maybe("offsetMm", edit.offsetMm, positionLps,
        "how far the piece is moved from its true place, along the patient's axes (LPS)");
    visit.maybe("rotationDegrees", edit.rotationDegrees, editFields::Point{pieceTurn},
        "a vector whose direction is the axis (LPS) and whose length is the angle: [0, 0, 90] "
        "turns about S");
    visit.maybe("zoom", edit.zoom, pieceZoom,
        "how many times as large as its true size the piece is shown");
}

template <> inline constexpr const char* editName<SendPiecesHome> = "sendPiecesHome";
template <>
inline constexpr const char* editMeaning<SendPiecesHome> =
    "Shows every piece at its true place and in its true size.";
template <class Visitor> void visitFields(Visitor&, SendPiecesHome&) { }

template <> inline constexpr const char* editName<RemovePiece> = "removePiece";
template <>
inline constexpr const char* editMeaning<RemovePiece> =
    "Makes a piece a piece no longer; what was cut out stays cut.";
template <class Visitor> void visitFields(Visitor& visit, RemovePiece& edit)
{
    visit.field("piece", Presence::Required, edit.piece, pieceNumber, "which piece");
}

} // namespace core::editSchema
