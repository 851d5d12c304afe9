// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Measurement.h"
#include "core/volume/Volume.h"

#include <optional>

namespace core {

/// The size of a measurement, computed from its points alone, in closed form.
struct MeasuredSize {
    /// Lengths, areas and volumes are in voxels because the source does not state the spacing:
    /// "12.5 voxels" instead of millimetres that would only be assumed.
    bool inVoxels = false;
    std::optional<double> length{}; ///< length of a distance, mm
    std::optional<double> angleDegrees{}; ///< 0 … 180
    std::optional<double> area{}; ///< area of a region of a plane, mm²
    std::optional<double> volume{}; ///< volume of a ball, mm³
    /// The axes of an ellipse, the sides of a rectangle, or the diameter of a ball (longAxis
    /// alone), mm; the longer one first.
    std::optional<double> longAxis{};
    std::optional<double> shortAxis{};
};

/// Which part of a volume's spacing is unknown.
enum class UnknownSpacing { Nothing, BetweenSlices, Everything };
[[nodiscard]] UnknownSpacing unknownSpacing(const Volume& volume);

/// The size of a measurement in a volume. Views show unevenly spaced slices as if they were evenly
/// spaced; sizes are those between the true places (truePlace()), so on such a volume an area is
/// summed from slice to slice. If only the distance between slices is unknown, measurements within
/// one slice still have millimetres.
[[nodiscard]] MeasuredSize measuredSize(const Measurement& measurement, const Volume& volume);

/// Where a place that a view shows really lies in the patient, LPS mm. It differs from the shown
/// place only if slices are unevenly spaced.
[[nodiscard]] glm::dvec3 truePlace(const VolumeGeometry& geometry, const glm::dvec3& shownLps);

} // namespace core
