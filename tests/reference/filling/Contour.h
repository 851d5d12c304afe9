// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/contour/ContourRule.h"
#include "core/edits/kinds/filling/EvolveContour.h"
#include "core/volume/Volume.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace reference {

/// A contour that evolves over a whole volume, voxel by voxel, where core works in a box, on the
/// front, and class by class. All sums are taken anew from the rule (core/contour/ContourRule.h),
/// whose numbers are given; the kernel is found here.
struct Contour {
    const core::LoadedVolume* study = nullptr;
    core::ContourRule rule{};
    std::vector<bool> inside{};
    std::vector<bool> open{}; ///< may change
    std::vector<bool> absent{}; ///< counts for neither side; empty: none does
    int generation = 0; ///< how many there have been

    /// One generation more. @return how many voxels it changed
    std::size_t step();
    /// E of the rule. A generation that changes anything lowers it.
    [[nodiscard]] double energy() const;
    [[nodiscard]] bool isAbsent(std::size_t at) const { return !absent.empty() && absent[at]; }
};

/// The start of an edit. @param mayTake whether voxels of a label may become the segment's
[[nodiscard]] Contour contourOf(const core::EvolveContour& edit, const core::ContourRule& rule,
    const core::LoadedVolume& study, std::span<const std::uint8_t> labels,
    const std::function<bool(int label)>& mayTake);
/// Which voxels the segment has after the edit.
[[nodiscard]] std::vector<bool> evolvedContour(const core::EvolveContour& edit,
    const core::ContourRule& rule, const core::LoadedVolume& study,
    std::span<const std::uint8_t> labels, const std::function<bool(int label)>& mayTake);

} // namespace reference
