// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/growth/GrowBox.h"
#include "core/volume/ClipRegion.h"
#include "core/volume/Volume.h"

#include <QJsonObject>

#include <optional>

namespace core {
struct GrowCriteria;
}

namespace ui {

/// How the next growth is to go. Kept with the session's display.
struct GrowSettings {
    /// A limit that keeps its value while it is off.
    struct Limit {
        bool on = false;
        double value = 0.0; ///< 0: none was ever chosen
        bool operator==(const Limit&) const = default;
    };
    double lower = 0.0; ///< modality units
    double upper = 0.0;
    bool overwriteUnlocked = false;
    int connectivity = 6; ///< 6, 18 or 26
    double generationsPerSecond = 0.0; ///< 0: as fast as it goes
    Limit sigmas{.on = false, .value = 2.5};
    Limit difference{}; ///< modality units
    Limit gradient{}; ///< modality units a millimetre
    Limit gradientDifference{};
    Limit majority{.on = false, .value = 14};
    Limit passage{}; ///< mm
    /// Stops at leaks: the value is how many times as wide as a narrow place a front may get.
    Limit guard{.on = true, .value = 2.0};
    double guardAreaMm2 = 60.0; ///< and how much wider
    bool onlyVisible = false;
    bool boxed = false;
    std::optional<core::GrowBox> box{}; ///< none was ever chosen
    bool operator==(const GrowSettings&) const = default;
};

[[nodiscard]] core::GrowCriteria criteriaOf(const GrowSettings& settings);
/// The other way round; limits that are not asked for keep their values, but are off.
void takeCriteria(const core::GrowCriteria& criteria, GrowSettings& settings);
/// To closure, with the criteria and the guard.
[[nodiscard]] core::GrowSteps growthOf(const GrowSettings& settings);

/// How many limits are on; the guard is none.
[[nodiscard]] int limitsOn(const GrowSettings& settings);

/// Gives values to limits that never had one: tenths of what a window shows of the volume, and four
/// voxels. A passage width becomes one that can be asked for in the volume.
void chooseLimits(GrowSettings& settings, const core::Volume& volume);

/// The box in index positions, from border to border of its voxels; none where growth is not bound
/// by one, or by one that misses the volume.
[[nodiscard]] std::optional<core::ClipRegion::Box> growBoxOf(
    const GrowSettings& settings, const core::VolumeGeometry& geometry);
/// The other way round: all voxels whose centres lie in it.
[[nodiscard]] core::GrowBox growBoxFrom(
    const core::ClipRegion::Box& box, const core::VolumeGeometry& geometry);

/// Between which the guard's value and its area lie.
inline constexpr double leastGuard = 1.2;
inline constexpr double greatestGuard = 10.0;
inline constexpr double leastGuardAreaMm2 = 0.1;
inline constexpr double greatestGuardAreaMm2 = 10000.0;

[[nodiscard]] QJsonObject growSettingsJson(const GrowSettings& settings);
/// Fields that are missing or make no sense are passed over.
void readGrowSettings(const QJsonObject& json, GrowSettings& settings);

} // namespace ui
