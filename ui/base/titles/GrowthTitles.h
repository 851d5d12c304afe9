// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/base/titles/TitleWords.h"

#include <QCoreApplication>

namespace ui {

/// Titles about seeds, about reasons why sketched voxels did not become seeds, and about growth.
struct GrowthTitles {
    Q_DECLARE_TR_FUNCTIONS(ui::RowTitleText)

public:
    using Code = core::RowTitleCode;
    static constexpr TitleWords words[] = {
        {Code::SeedStroke, QT_TR_NOOP("Seed stroke for '%1'")},
        {Code::MoveSeeds, QT_TR_N_NOOP("Move %1 seeds of '%2'"), QT_TR_NOOP("Move 1 seed of '%2'")},
        {Code::TakeSeedsAway, QT_TR_NOOP("Take seeds of '%1' away")},
        {Code::VoxelsBecause, QT_TR_N_NOOP("%1 voxels (%2)"), QT_TR_NOOP("1 voxel (%2)")},
        {Code::VoxelsOf, QT_TR_N_NOOP("%2 of %1 voxels"), QT_TR_NOOP("%2 of 1 voxel")},
        {Code::VoxelsOfBecause, QT_TR_N_NOOP("%2 of %1 voxels (%3)"),
            QT_TR_NOOP("%2 of 1 voxel (%3)")},
        {Code::Reasons, "%1"},
        {Code::BelongTo, QT_TR_N_NOOP("%1 belong to '%2'"), QT_TR_NOOP("1 belongs to '%2'")},
        {Code::BelongAlready, QT_TR_N_NOOP("%1 belong to '%2' already"),
            QT_TR_NOOP("1 belongs to '%2' already")},
        {Code::SeedsAlready, QT_TR_N_NOOP("%1 are seeds already"),
            QT_TR_NOOP("1 is a seed already")},
        {Code::SeedsOfAnother, QT_TR_N_NOOP("%1 are seeds of '%2'"),
            QT_TR_NOOP("1 is a seed of '%2'")},
        {Code::ShutByBarrier, QT_TR_N_NOOP("%1 are shut by a barrier"),
            QT_TR_NOOP("1 is shut by a barrier")},
        {Code::WereSeedsOf, QT_TR_N_NOOP("%1 were seeds of '%2'"),
            QT_TR_NOOP("1 was a seed of '%2'")},
        {Code::Range, QT_TR_NOOP("%1 … %2")},
        {Code::RangeInUnit, QT_TR_NOOP("%1 … %2 %3")},
        {Code::Interval, QT_TR_NOOP("Interval %1")},
        {Code::GrowInterval, QT_TR_NOOP("Grow %1")},
        {Code::GrowAnew, QT_TR_NOOP("Grow anew from seeds %1")},
        {Code::Recover, QT_TR_NOOP("Recover %1")},
        {Code::WithdrawTo, QT_TR_NOOP("Withdraw to %1")},
        {Code::RecoverAndWithdraw, QT_TR_NOOP("Recover and withdraw %1")},
        {Code::GrowSteps, QT_TR_N_NOOP("Grow %1 steps"), QT_TR_NOOP("Grow 1 step")},
        {Code::GrowSegmentSteps, QT_TR_N_NOOP("Grow '%2' %1 steps"),
            QT_TR_NOOP("Grow '%2' 1 step")},
        {Code::GrowSegmentsSteps, QT_TR_N_NOOP("Grow %2 segments %1 steps"),
            QT_TR_NOOP("Grow %2 segments 1 step")},
        {Code::GrowFromSeeds, QT_TR_NOOP("Grow from seeds")},
        {Code::GrowSegmentFromSeeds, QT_TR_NOOP("Grow '%1' from seeds")},
        {Code::GrowSegmentsFromSeeds, QT_TR_NOOP("Grow %1 segments from seeds")},
        {Code::ShrinkSteps, QT_TR_N_NOOP("Shrink %1 steps"), QT_TR_NOOP("Shrink 1 step")},
        {Code::ShrinkToSeeds, QT_TR_NOOP("Shrink to the seeds")},
        {Code::ShrinkHere, QT_TR_NOOP("Shrink here")},
        {Code::ShrinkHereSteps, QT_TR_N_NOOP("Shrink here %1 generations"),
            QT_TR_NOOP("Shrink here 1 generation")},
        {Code::ShrinkOnlyHere, QT_TR_NOOP("Shrink only here")},
        {Code::PlugLeak, QT_TR_NOOP("Plug leak")},
        {Code::Barrier, QT_TR_NOOP("Barrier %1 mm")},
        {Code::OpenBarrier, QT_TR_NOOP("Open barrier %1 mm")},
        {Code::BarrierAroundSurface, QT_TR_NOOP("Barrier around surface")},
        {Code::OpenBarrierAroundSurface, QT_TR_NOOP("Open barrier around surface")},
    };
};

} // namespace ui
