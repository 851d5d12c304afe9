// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/contour/ContourTrack.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace core {

/// Bytes that a contour takes while it is watched: its ground and the copy that evolves, states
/// that are shown and worked out, and what all generations have changed.
[[nodiscard]] double watchedContourBytes(std::size_t voxelsOfBox, std::size_t changes);

/// What is wanted of a contour that is watched.
struct ContourWish {
    int generations = 0; ///< at most
    int silent = 0; ///< up to this one nothing is reported
    double bytes = 0.0; ///< no generation more when watchedContourBytes() is beyond
};

/// Why no further generation is worked out.
enum class ContourEnd { Rests, AllGenerations, OutOfMemory, Cancelled };

/// What whoever watches is told meanwhile.
struct ContourReports {
    /// Once: the track, and the state of the last generation that it knows, which it shows.
    std::function<void(std::shared_ptr<ContourTrack>, std::shared_ptr<const ContourState>)> begun;
    std::function<void(std::vector<ContourGeneration>)> further;
};

/// Evolves a contour up to a generation in silence, and then reports one by one, though not each by
/// itself where they come fast. What a generation changed is handed over and not kept.
[[nodiscard]] ContourEnd watchContour(ContourRule rule, const ContourGround& ground,
    const ContourWish& wish, const Progress& progress, const ContourReports& reports);

} // namespace core
