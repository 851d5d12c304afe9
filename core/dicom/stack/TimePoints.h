// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/stack/SlicePlaces.h"

#include <QString>

#include <vector>

namespace core {

/// One of the images at every place.
struct TimePoint {
    QString label; ///< what tells it from the others, in words; empty where nothing does
    std::vector<ImageHeader> slices{}; ///< in the order of the places
};

/// How the images that share their places with others come apart (DICOM.md 1.3).
struct TimeAxis {
    std::vector<TimePoint> points{};
    /// Whether every place has one image of every point, at the very same position: a time axis.
    /// Otherwise the points are candidates of which one must be chosen.
    bool complete = false;
    /// Whether an attribute tells the points apart, or instance numbers that run through all slices
    /// of one before they come to the next.
    bool certain = false;
};

/// Takes the first attribute, else the first two together, that tells the images of every place
/// apart and has the same values at all of them; else their instance numbers. Points that a number
/// or a time names are in its order, others in that of their instance numbers.
/// @param places at least one with several images; none empty
[[nodiscard]] TimeAxis findTimeAxis(std::vector<SlicePlace> places);

} // namespace core
