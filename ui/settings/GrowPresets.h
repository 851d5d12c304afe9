// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/settings/GrowSettings.h"

#include <QString>

#include <vector>

namespace ui {

/// The steps of *Smooth*: how many of the 27 voxels around and at a voxel must lie in the interval
/// (GrowSettings::majority). Where all of a thing qualifies, a thread one voxel thick has 3 of 27
/// around it, a sheet 9, a bar two voxels thick 12, a flat border 18. At a flat border in noise
/// the strongest step still allows two voxels that fail.
inline constexpr int smoothALittle = 10;
inline constexpr int smoothMore = 14;
inline constexpr int smoothStrong = 16;

/// How a kind of structure is best grown, besides its interval.
struct GrowPreset {
    QString name;
    QString tip;
    int smooth = 0; ///< 0: off
    bool smoothing = false; ///< GrowSettings::smoothing
    int connectivity = 6; ///< GrowSettings::connectivity
};

/// From thick to thin. None of them stops at necks: which width does depends on the leak.
[[nodiscard]] const std::vector<GrowPreset>& growPresets();

/// Sets what a preset is of: *Smooth*, *Smooth noise*, necks and connectivity. All else stays, also
/// the width of necks, which are switched off.
void takePreset(const GrowPreset& preset, GrowSettings& settings);
/// Whether the settings are those of a preset.
[[nodiscard]] bool areOf(const GrowSettings& settings, const GrowPreset& preset);

} // namespace ui
