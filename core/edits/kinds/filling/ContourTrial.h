// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <cstdint>
#include <set>
#include <span>

namespace core {

struct ContourGround;
struct Document;
struct EvolveContour;

// An EvolveContour that is watched before it is an edit. What it comes to is found by the functions
// of the edit itself; here is what an engine does when it writes: it leaves voxels as they are that
// may not be edited.

/// The labels of one plane, of the whole volume, x fastest.
struct ContourPlane {
    std::uint8_t plane = 0;
    std::span<const std::uint8_t> labels{};
};

/// The planes that a trial reads: that of the segment, and those of the editable range. Errors:
/// those of check().
[[nodiscard]] Result<std::set<std::uint8_t>> contourPlanes(
    const EvolveContour& edit, const Document& document);

/// contourGround(), with these planes.
/// @param planes those of contourPlanes()
[[nodiscard]] Result<ContourGround> trialGround(
    const EvolveContour& edit, const Document& document, std::span<const ContourPlane> planes);

/// Marks the voxels that the editable range leaves as they are (ContourGround::held).
/// @param ground of trialGround(), with its codes. Errors: those of editableVoxels().
[[nodiscard]] Result<void> holdUneditable(const EvolveContour& edit, const Document& document,
    std::span<const ContourPlane> planes, ContourGround& ground);

} // namespace core
