// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/parts/GrowBox.h"
#include "core/volume/ClipRegion.h"
#include "core/volume/Volume.h"

#include <QJsonObject>

#include <optional>

namespace core {
struct GrowCriteria;
}

namespace ui {

/// The settings of the next growth. They are kept with the session's display state.
struct GrowSettings {
    /// A limit with a value that is kept while the limit is off.
    struct Limit {
        bool on = false;
        double value = 0.0; ///< 0 if none was ever chosen
        bool operator==(const Limit&) const = default;
    };
    double lower = 0.0; ///< modality units
    double upper = 0.0;
    bool overwriteUnlocked = false;
    int connectivity = 6; ///< 6, 18 or 26
    double generationsPerSecond = 0.0; ///< 0: as fast as it goes
    Limit sigmas{.on = false, .value = 2.5};
    Limit difference{}; ///< modality units
    Limit gradient{}; ///< modality units per millimetre
    Limit gradientDifference{};
    Limit majority{.on = false, .value = 14};
    /// Medians are compared with the interval (GrowCriteria::smoothing).
    bool smoothing = false;
    Limit passage{}; ///< mm
    /// The leak guard: growth stops when its front becomes wider than a narrow place by this factor
    /// …
    Limit guard{.on = true, .value = 2.0};
    double guardAreaMm2 = 60.0; ///< … and by at least this area
    bool onlyVisible = false;
    bool boxed = false;
    std::optional<core::GrowBox> box{}; ///< none if none was ever chosen
    bool operator==(const GrowSettings&) const = default;
};

[[nodiscard]] core::GrowCriteria criteriaOf(const GrowSettings& settings);
/// Sets the settings from criteria. Limits that the criteria lack keep their values, but are off.
void takeCriteria(const core::GrowCriteria& criteria, GrowSettings& settings);
/// The edit that grows to closure with the criteria and the guard.
[[nodiscard]] core::GrowSteps growthOf(const GrowSettings& settings);

/// How many limits are on; the guard does not count as one.
[[nodiscard]] int limitsOn(const GrowSettings& settings);

/// Gives values to limits that never had one: a tenth of the value range that a window shows of the
/// volume, and four voxels. A passage width is adjusted to one that is possible in the volume.
void chooseLimits(GrowSettings& settings, const core::Volume& volume);

/// The box of the growth in index space, from border to border of its voxels; none if growth is not
/// limited by a box, or the box lies outside the volume.
[[nodiscard]] std::optional<core::ClipRegion::Box> growBoxOf(
    const GrowSettings& settings, const core::VolumeGeometry& geometry);
/// The inverse: the box of all voxels whose centres lie in @p box.
[[nodiscard]] core::GrowBox growBoxFrom(
    const core::ClipRegion::Box& box, const core::VolumeGeometry& geometry);

/// Bounds of the guard's factor and area.
inline constexpr double leastGuard = 1.2;
inline constexpr double greatestGuard = 10.0;
inline constexpr double leastGuardAreaMm2 = 0.1;
inline constexpr double greatestGuardAreaMm2 = 10000.0;

[[nodiscard]] QJsonObject growSettingsJson(const GrowSettings& settings);
/// Fields that are missing or invalid leave the settings unchanged.
void readGrowSettings(const QJsonObject& json, GrowSettings& settings);

} // namespace ui
