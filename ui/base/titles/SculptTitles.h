// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/base/titles/TitleWords.h"

#include <QCoreApplication>

namespace ui {

/// Titles about sculpt layers and tools that cut.
struct SculptTitles {
    Q_DECLARE_TR_FUNCTIONS(ui::RowTitleText)

public:
    using Code = core::RowTitleCode;
    static constexpr TitleWords words[] = {
        {Code::AddLayer, QT_TR_NOOP("Add layer '%1'")},
        {Code::DeleteLayer, QT_TR_NOOP("Delete layer '%1'")},
        {Code::MoveLayer, QT_TR_NOOP("Move layer '%1' to place %2")},
        {Code::MergeLayers, QT_TR_NOOP("Merge layer '%1' into '%2'")},
        {Code::SegmentToLayer, QT_TR_NOOP("Segment '%1' to layer '%2'")},
        {Code::OutsideToLayer, QT_TR_NOOP("All but segment '%1' to layer '%2'")},
        {Code::RenameLayer, QT_TR_NOOP("Rename layer '%1' to '%2'")},
        {Code::SoloLayer, QT_TR_NOOP("Solo layer '%1'")},
        {Code::SoloIt, QT_TR_NOOP("solo it")},
        {Code::EndSolo, QT_TR_NOOP("End solo of layer '%1'")},
        {Code::EndItsSolo, QT_TR_NOOP("end its solo")},
        {Code::MuteLayer, QT_TR_NOOP("Mute layer '%1'")},
        {Code::MuteIt, QT_TR_NOOP("mute it")},
        {Code::UnmuteLayer, QT_TR_NOOP("Unmute layer '%1'")},
        {Code::UnmuteIt, QT_TR_NOOP("unmute it")},
        {Code::Drill, QT_TR_NOOP("Drill %1 mm")},
        {Code::DrillRate, QT_TR_NOOP("Drill %1 mm/s")},
        {Code::RestoreDrill, QT_TR_NOOP("Restore %1 mm")},
        {Code::RestoreDrillRate, QT_TR_NOOP("Restore %1 mm/s")},
        {Code::Laser, QT_TR_NOOP("Laser %1 mm")},
        {Code::LaserRate, QT_TR_NOOP("Laser %1 mm/s")},
        {Code::RestoreLaser, QT_TR_NOOP("Restore laser %1 mm")},
        {Code::RestoreLaserRate, QT_TR_NOOP("Restore laser %1 mm/s")},
        {Code::Peel, QT_TR_NOOP("Peel %1 mm")},
        {Code::RestorePeel, QT_TR_NOOP("Restore peel %1 mm")},
        {Code::CarveBrush, QT_TR_NOOP("Carve brush %1 mm")},
        {Code::RestoreBrush, QT_TR_NOOP("Restore brush %1 mm")},
        {Code::CarveScissors, QT_TR_NOOP("Carve scissors")},
        {Code::CarveScissorsDeep, QT_TR_NOOP("Carve scissors %1 mm deep")},
        {Code::CarveScissorsFirst, QT_TR_NOOP("Carve scissors through the first layer")},
        {Code::CarveScissorsDeepFirst,
            QT_TR_NOOP("Carve scissors %1 mm deep through the first layer")},
        {Code::RestoreScissors, QT_TR_NOOP("Restore scissors")},
        {Code::RestoreScissorsDeep, QT_TR_NOOP("Restore scissors %1 mm deep")},
        {Code::RestoreScissorsFirst, QT_TR_NOOP("Restore scissors through the first layer")},
        {Code::RestoreScissorsDeepFirst,
            QT_TR_NOOP("Restore scissors %1 mm deep through the first layer")},
    };
};

} // namespace ui
