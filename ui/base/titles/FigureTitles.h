// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/base/titles/TitleWords.h"

#include <QCoreApplication>

namespace ui {

/// Figures that say what a step changed, and titles that stand alone.
struct FigureTitles {
    Q_DECLARE_TR_FUNCTIONS(ui::RowTitleText)

public:
    using Code = core::RowTitleCode;
    static constexpr TitleWords words[] = {
        {Code::Nothing, ""},
        {Code::StoredName, "%1"},
        {Code::Bricks, QT_TR_N_NOOP("%1 bricks"), QT_TR_NOOP("1 brick")},
        {Code::Voxels, QT_TR_N_NOOP("%1 voxels"), QT_TR_NOOP("1 voxel")},
        {Code::VoxelsGained, QT_TR_N_NOOP("+%1 voxels"), QT_TR_NOOP("+1 voxel")},
        {Code::VoxelsLost, QT_TR_N_NOOP("−%1 voxels"), QT_TR_NOOP("−1 voxel")},
        {Code::VoxelsStay, QT_TR_N_NOOP("%1 voxels stay"), QT_TR_NOOP("1 voxel stays")},
        {Code::SeedVoxels, QT_TR_N_NOOP("%1 seed voxels"), QT_TR_NOOP("1 seed voxel")},
        {Code::SeedVoxelsGained, QT_TR_N_NOOP("+%1 seed voxels"), QT_TR_NOOP("+1 seed voxel")},
        {Code::SeedVoxelsLost, QT_TR_N_NOOP("−%1 seed voxels"), QT_TR_NOOP("−1 seed voxel")},
        {Code::FlowIn, QT_TR_NOOP("+%1 voxels")},
        {Code::FlowOut, QT_TR_NOOP("−%1 voxels")},
        {Code::FlowInAndOut, QT_TR_NOOP("+%1 −%2 voxels")},
        {Code::NoVoxel, QT_TR_NOOP("no voxel")},
        {Code::Empty, QT_TR_NOOP("empty")},
        {Code::Vertices, QT_TR_N_NOOP("%1 vertices"), QT_TR_NOOP("1 vertex")},
        {Code::PercentOff, QT_TR_NOOP("%1 % off")},
        {Code::Millilitres, QT_TR_NOOP("%1 mL")},
        {Code::Millimetres, QT_TR_NOOP("%1 mm")},
        {Code::MillimetresDeep, QT_TR_NOOP("%1 mm deep")},
        {Code::WithinLimits, QT_TR_NOOP("within limits")},
    };
};

} // namespace ui
