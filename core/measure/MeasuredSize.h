// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Measurement.h"
#include "core/volume/Volume.h"

#include <optional>

namespace core {

/// What a measurement comes to by its points alone, in closed form.
struct MeasuredSize {
    /// Lengths, areas and volumes are in voxels, because the source does not say how far apart
    /// they are: "12.5 voxels", not millimetres that were assumed.
    bool inVoxels = false;
    std::optional<double> length{}; ///< of a distance, mm
    std::optional<double> angleDegrees{}; ///< 0 … 180
    std::optional<double> area{}; ///< of a region of a plane, mm²
    std::optional<double> volume{}; ///< of a ball, mm³
    /// Of an ellipse its axes, of a rectangle its sides, of a ball its diameter: the longer first.
    std::optional<double> longAxis{};
    std::optional<double> shortAxis{};
};

/// What of a volume's spacing is not known.
enum class UnknownSpacing { Nothing, BetweenSlices, Everything };
[[nodiscard]] UnknownSpacing unknownSpacing(const Volume& volume);

/// The sizes of a measurement in a volume. Views show slices that are unevenly spaced as if they
/// were even; a size is what lies between the true places, so on such a volume an area is added up
/// from slice to slice. If only the distance of slices is unknown, what lies in one slice has
/// millimetres.
[[nodiscard]] MeasuredSize measuredSize(const Measurement& measurement, const Volume& volume);

/// Where a place that a view shows lies in the patient; it differs only between uneven slices.
[[nodiscard]] glm::dvec3 truePlace(const VolumeGeometry& geometry, const glm::dvec3& shownLps);

} // namespace core
