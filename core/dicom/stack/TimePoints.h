// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/stack/SlicePlaces.h"

#include <QString>

#include <vector>

namespace core {

/// One point in time: one of the images at each position.
struct TimePoint {
    Clause label; ///< what distinguishes it from the others; empty if nothing does
    std::vector<ImageHeader> slices{}; ///< in the order of positions
};

/// How the images that share their positions can be separated.
struct TimeAxis {
    std::vector<TimePoint> points{};
    /// Every position has one image of every point, at exactly the same position: a time axis.
    /// Otherwise the points are candidates, of which one must be chosen.
    bool complete = false;
    /// The points are distinguished by an attribute, or by instance numbers that run through all
    /// slices of one point before those of the next.
    bool certain = false;
};

/// Uses the first attribute, or the first two together, that distinguishes the images at each
/// position and has the same values at all positions; otherwise their instance numbers. Points
/// identified by a number or a time are ordered by it, others by their instance numbers.
/// @param places at least one with several images; none empty
[[nodiscard]] TimeAxis findTimeAxis(std::vector<SlicePlace> places);

} // namespace core
