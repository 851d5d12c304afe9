// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/base/titles/TitleWords.h"

#include <QCoreApplication>

namespace ui {

/// Titles about the surface that is refined, and about chunks.
struct SurfaceTitles {
    Q_DECLARE_TR_FUNCTIONS(ui::RowTitleText)

public:
    using Code = core::RowTitleCode;
    static constexpr TitleWords words[] = {
        {Code::SurfaceOf, QT_TR_NOOP("Surface of '%1'")},
        {Code::LayCrossingsAnew, QT_TR_NOOP("Lay crossing parts of the surface anew")},
        {Code::RemoveSurface, QT_TR_NOOP("Remove surface")},
        {Code::FollowMask, QT_TR_NOOP("Surface follows the mask")},
        {Code::WriteBack, QT_TR_NOOP("Write surface back to '%1'")},
        {Code::SpherePush, QT_TR_NOOP("Sphere push %1 mm")},
        {Code::Scrape, QT_TR_NOOP("Scrape %1 mm")},
        {Code::DragPoint, QT_TR_NOOP("Drag point %1 mm")},
        {Code::SmoothSurface, QT_TR_NOOP("Smooth surface %1 mm")},
        {Code::AttractToEdge, QT_TR_NOOP("Attract to edge %1 mm")},
        {Code::TemplateOf, QT_TR_N_NOOP("Template of %1 contours"),
            QT_TR_NOOP("Template of 1 contour")},
        {Code::Mark, QT_TR_NOOP("Mark %1")},
        {Code::MarkBrush, QT_TR_NOOP("brush %1 mm")},
        {Code::Green, QT_TR_NOOP("green")},
        {Code::Red, QT_TR_NOOP("red")},
        {Code::Yellow, QT_TR_NOOP("yellow")},
        {Code::GrowMarks, QT_TR_NOOP("Grow %1 marks")},
        {Code::ShrinkMarks, QT_TR_NOOP("Shrink %1 marks")},
        {Code::InvertMarks, QT_TR_NOOP("Invert %1 marks")},
        {Code::SignOffMarks, QT_TR_NOOP("Sign off %1 marks")},
        {Code::SignOffRegion, QT_TR_NOOP("Sign off %1 region")},
        {Code::ClearMarks, QT_TR_NOOP("Clear %1 marks")},
        {Code::ClearRegion, QT_TR_NOOP("Clear %1 region")},
        {Code::DivideAround, QT_TR_NOOP("Divide around '%1' into chunks")},
        {Code::DivideByMap, QT_TR_NOOP("Divide around '%1' into chunks by a probability map")},
        {Code::ToggleChunks, QT_TR_NOOP("Toggle chunks of '%1'")},
        {Code::AddChunks, QT_TR_NOOP("Add chunks to '%1'")},
        {Code::TakeChunks, QT_TR_NOOP("Take chunks from '%1'")},
    };
};

} // namespace ui
