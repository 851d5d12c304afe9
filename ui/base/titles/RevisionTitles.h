// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/base/titles/TitleWords.h"

#include <QCoreApplication>

namespace ui {

/// Titles of steps that change older rows.
struct RevisionTitles {
    Q_DECLARE_TR_FUNCTIONS(ui::RowTitleText)

public:
    using Code = core::RowTitleCode;
    static constexpr TitleWords words[] = {
        {Code::UndoOnly, QT_TR_NOOP("Undo only '%1'")},
        {Code::UndoOnlySteps, QT_TR_N_NOOP("Undo only %1 steps"), QT_TR_NOOP("Undo only 1 step")},
        {Code::RemoveStroke, QT_TR_NOOP("Remove '%1'")},
        {Code::ReviseStroke, QT_TR_NOOP("Revise '%1': %2")},
        {Code::ReviseAsDrawn, QT_TR_NOOP("Revise '%1': as it was drawn")},
        {Code::Changes, "%1"},
        {Code::RadiusTo, QT_TR_NOOP("radius %1 → %2 mm")},
        {Code::SideTo, QT_TR_NOOP("side %1 → %2 mm")},
        {Code::WidthTo, QT_TR_NOOP("width %1 → %2 mm")},
        {Code::HeightTo, QT_TR_NOOP("height %1 → %2 mm")},
        {Code::OutlineTimes, QT_TR_NOOP("outline × %1")},
        {Code::DepthTo, QT_TR_NOOP("depth %1 → %2 mm")},
        {Code::SoftEdgeTo, QT_TR_NOOP("soft edge %1 → %2 mm")},
        {Code::LayerTo, QT_TR_NOOP("layer %1 → %2")},
        {Code::ThroughGaps, QT_TR_NOOP("through gaps")},
        {Code::StoppingAtGaps, QT_TR_NOOP("stopping at gaps")},
    };
};

} // namespace ui
