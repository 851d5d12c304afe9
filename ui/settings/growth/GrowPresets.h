// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/settings/growth/GrowSettings.h"

#include <QString>

#include <vector>

namespace ui {

/// The steps of "Smooth": how many of the 27 voxels of a 3 × 3 × 3 neighbourhood must lie in the
/// interval (GrowSettings::majority). If all voxels of a structure lie in it, the count is 3 in a
/// thread one voxel thick, 9 in a sheet, 12 in a bar two voxels thick, and 18 at a flat border. So
/// at a flat border the strongest step tolerates two noisy voxels.
inline constexpr int smoothALittle = 10;
inline constexpr int smoothMore = 14;
inline constexpr int smoothStrong = 16;

/// Settings of growth that suit a kind of structure, apart from the interval.
struct GrowPreset {
    QString name;
    QString tip;
    int smooth = 0; ///< 0: off
    bool smoothing = false; ///< GrowSettings::smoothing
    int connectivity = 6; ///< GrowSettings::connectivity
};

/// All presets, from thick to thin structures. None of them stops at necks, because the right width
/// depends on the leak.
[[nodiscard]] const std::vector<GrowPreset>& growPresets();

/// Applies a preset: sets *Smooth*, *Smooth noise* and connectivity, and switches the stop at necks
/// off. The width of necks and all other settings stay.
void takePreset(const GrowPreset& preset, GrowSettings& settings);
/// Whether applying the preset would change nothing.
[[nodiscard]] bool areOf(const GrowSettings& settings, const GrowPreset& preset);

} // namespace ui
