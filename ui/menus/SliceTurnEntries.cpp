// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/SliceTurnEntries.h"

#include <QObject>

namespace ui {

namespace {

SliceTurn turnedLeft(const SliceTurn& before)
{
    return before.turnedClockwise().turnedClockwise().turnedClockwise();
}

} // namespace

const std::vector<SliceTurnEntry>& sliceTurnEntries()
{
    static const std::vector<SliceTurnEntry> entries{
        {"view.flipLeftRight", QObject::tr("Flip left and right"),
            [](const SliceTurn& before) { return before.flippedLeftRight(); }},
        {"view.flipTopBottom", QObject::tr("Flip top and bottom"),
            [](const SliceTurn& before) { return before.flippedTopBottom(); }},
        {"view.quarterRight", QObject::tr("Turn right by 90°"),
            [](const SliceTurn& before) { return before.turnedClockwise(); }},
        {"view.quarterLeft", QObject::tr("Turn left by 90°"), &turnedLeft},
        {"view.upright", QObject::tr("Lay upright again"),
            [](const SliceTurn&) { return SliceTurn(); }},
    };
    return entries;
}

} // namespace ui
