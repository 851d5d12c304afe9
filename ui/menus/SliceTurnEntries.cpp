// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/SliceTurnEntries.h"

#include <QCoreApplication>

namespace ui {

namespace {

QString turnText(const char* english)
{
    return QCoreApplication::translate("ui::SliceTurnEntries", english);
}

SliceTurn turnedLeft(const SliceTurn& before)
{
    return before.turnedClockwise().turnedClockwise().turnedClockwise();
}

} // namespace

const std::vector<SliceTurnEntry>& sliceTurnEntries()
{
    static const std::vector<SliceTurnEntry> entries{
        {"view.flipLeftRight", turnText("Flip left and right"),
            [](const SliceTurn& before) { return before.flippedLeftRight(); }},
        {"view.flipTopBottom", turnText("Flip top and bottom"),
            [](const SliceTurn& before) { return before.flippedTopBottom(); }},
        {"view.quarterRight", turnText("Turn right by 90°"),
            [](const SliceTurn& before) { return before.turnedClockwise(); }},
        {"view.quarterLeft", turnText("Turn left by 90°"), &turnedLeft},
        {"view.upright", turnText("Lay upright again"),
            [](const SliceTurn&) { return SliceTurn(); }},
    };
    return entries;
}

} // namespace ui
