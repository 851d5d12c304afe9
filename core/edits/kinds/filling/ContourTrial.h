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
struct LabelPlane;

// Lets a user watch an EvolveContour before it becomes an edit. The result of the contour is
// computed by the functions of the edit itself; the functions here add what the engine does when it
// writes: it leaves voxels unchanged that are not editable.

/// The numbers of the label planes that must be read for a trial: that of the segment, and those
/// that the editable range refers to. Errors: those of check().
[[nodiscard]] Result<std::set<std::uint8_t>> contourPlanes(
    const EvolveContour& edit, const Document& document);

/// contourGround(), with the labels from these planes.
/// @param planes those of contourPlanes()
[[nodiscard]] Result<ContourGround> trialGround(
    const EvolveContour& edit, const Document& document, std::span<const LabelPlane> planes);

/// Sets the flag ContourGround::held at voxels that the editable range excludes.
/// @param ground that of trialGround(), with its codes filled in
/// Errors: those of editableVoxels().
[[nodiscard]] Result<void> holdUneditable(const EvolveContour& edit, const Document& document,
    std::span<const LabelPlane> planes, ContourGround& ground);

} // namespace core
