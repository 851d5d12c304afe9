// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/contour/ContourTrack.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace core {

/// The memory that watching a contour takes, in bytes: its ground, the copy that evolves, the
/// states that are shown and prepared, and the changes of all generations.
[[nodiscard]] double watchedContourBytes(std::size_t voxelsOfBox, std::size_t changes);

/// What the caller asks of watchContour().
struct ContourWish {
    int generations = 0; ///< greatest number of generations
    int silent = 0; ///< generations that are computed before the first report
    double bytes = 0.0; ///< the evolution ends when watchedContourBytes() exceeds this
};

/// Why the evolution has ended.
enum class ContourEnd { Rests, AllGenerations, OutOfMemory, Cancelled };

/// Callbacks of watchContour(). They are called on its thread.
struct ContourReports {
    /// Called once, unless it is cancelled before: the track, and the state of its last generation,
    /// which is the one that it shows.
    std::function<void(std::shared_ptr<ContourTrack>, std::shared_ptr<const ContourState>)> begun;
    std::function<void(std::vector<ContourGeneration>)> further;
};

/// Evolves a contour. The first `silent` generations are computed without reports; then
/// reports.begun is called. Later generations go to reports.further, several in one call if they
/// come faster than about one in 15 ms. They are handed over and not kept here. Blocks until the
/// end; any thread.
[[nodiscard]] ContourEnd watchContour(ContourRule rule, const ContourGround& ground,
    const ContourWish& wish, const Progress& progress, const ContourReports& reports);

} // namespace core
