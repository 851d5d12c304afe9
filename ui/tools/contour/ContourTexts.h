// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/contour/ContourSettings.h"

#include <QString>

namespace core {
class ContourTrack;
struct Segment;
struct Volume;
} // namespace core

namespace ui {

struct GrowSettings;

/// What the contour tool expects next, for the status line.
[[nodiscard]] QString contourHint(ContourSettings::Start start);
/// What a click would do to the active segment, or without one (null).
[[nodiscard]] QString contourTarget(const core::Segment* segment, bool erases, bool fromBubbles);
/// Why there is nothing that could evolve.
[[nodiscard]] QString nothingToEvolveText(bool erases, bool fromBubbles);
/// "generation 12 · +3.2 mL, −0.1 mL", or "generation 12 · erases 3.2 mL".
[[nodiscard]] QString contourText(
    const core::ContourTrack& track, const core::Volume& volume, bool erases);
/// The interval of growth, with the volume's unit: "−50 … 20 HU".
[[nodiscard]] QString contourInterval(const GrowSettings& growth, const core::Volume& volume);

} // namespace ui
