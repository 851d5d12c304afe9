// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/base/titles/TitleWords.h"

#include <QCoreApplication>

namespace ui {

/// Titles about measurements, bookmarks and pieces.
struct PlacedTitles {
    Q_DECLARE_TR_FUNCTIONS(ui::RowTitleText)

public:
    using Code = core::RowTitleCode;
    static constexpr TitleWords words[] = {
        {Code::Measure, QT_TR_NOOP("Measure %1 mm")},
        {Code::RemoveMeasurement, QT_TR_NOOP("Remove measurement %1 mm")},
        {Code::RemoveUnknownMeasurement, QT_TR_NOOP("Remove measurement %1")},
        {Code::MeasureThat, QT_TR_NOOP("Measure %1")},
        {Code::AddNote, QT_TR_NOOP("Add %1")},
        {Code::RemoveNote, QT_TR_NOOP("Remove %1")},
        {Code::MoveNote, QT_TR_NOOP("Move %1")},
        {Code::MoveUnknownMeasurement, QT_TR_NOOP("Move measurement %1")},
        {Code::DistanceOf, QT_TR_NOOP("distance %1 mm")},
        {Code::DistanceOfVoxels, QT_TR_NOOP("distance %1 voxels")},
        {Code::AngleOf, QT_TR_NOOP("angle %1°")},
        {Code::EllipseOf, QT_TR_NOOP("ellipse %1")},
        {Code::RectangleOf, QT_TR_NOOP("rectangle %1")},
        {Code::OutlineOf, QT_TR_NOOP("outline %1")},
        {Code::BallOf, QT_TR_NOOP("ball %1")},
        {Code::Probe, QT_TR_NOOP("probe")},
        {Code::Arrow, QT_TR_NOOP("arrow")},
        {Code::ArrowTo, QT_TR_NOOP("arrow '%1'")},
        {Code::TextThat, QT_TR_NOOP("text '%1'")},
        {Code::SquareMillimetres, QT_TR_NOOP("%1 mm²")},
        {Code::SquareVoxels, QT_TR_NOOP("%1 voxels²")},
        {Code::OfVoxels, QT_TR_NOOP("%1 voxels")},
        {Code::Bookmark, QT_TR_NOOP("Bookmark '%1'")},
        {Code::RemoveBookmark, QT_TR_NOOP("Remove bookmark '%1'")},
        {Code::LiftPiece, QT_TR_NOOP("Lift '%1' off layer '%2'")},
        {Code::PastePiece, QT_TR_NOOP("Paste segment '%1' as piece '%2'")},
        {Code::RemovePiece, QT_TR_NOOP("Remove piece '%1'")},
        {Code::SendPiecesHome, QT_TR_NOOP("Send all pieces home")},
        {Code::RenamePiece, QT_TR_NOOP("Rename piece '%1' to '%2'")},
        {Code::SendPieceHome, QT_TR_NOOP("Send piece '%1' home")},
        {Code::SendItHome, QT_TR_NOOP("send it home")},
        {Code::MovePiece, QT_TR_NOOP("Move piece '%1' %2 mm")},
        {Code::MoveIt, QT_TR_NOOP("move it %1 mm")},
        {Code::TurnPiece, QT_TR_NOOP("Turn piece '%1' %2°")},
        {Code::TurnIt, QT_TR_NOOP("turn it %1°")},
        {Code::ZoomPiece, QT_TR_NOOP("Zoom piece '%1' %2×")},
        {Code::ZoomIt, QT_TR_NOOP("zoom it %1×")},
    };
};

} // namespace ui
