// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "core/edits/kinds/parts/ProtectedSegments.h"
#include "core/sculpt/CutFrame.h"

namespace core {

/// The values from which a frame is made, in addition to the volume.
struct CutFrameOptions {
    OrthographicView view{};
    double surfaceThreshold = 0.0;
    double maskReachMm = 0.0; ///< from the middle to the farthest corner of the mask
    double maxDepthMm = 0.0;
    bool throughGaps = false;
    bool restore = false;
    ClipHalfSpaces hidden{};
    ProtectedSegments protectedSegments{};
};

/// The side of a mask element, mm16. Half the finest spacing resolves a mask; a mask that would
/// span more than 512 elements gets larger ones.
[[nodiscard]] std::int32_t elementPitch(const VolumeGeometry& geometry, double maskReachMm);

/// Places a mask plane in front of the first volume of a document. Doubles are used here and
/// nowhere later. The build forbids fused multiply-add, so the results are the same on every
/// machine.
/// @param edit name of the edit, for errors Errors: InvalidField (no volume; a view without
/// direction, or one that looks far past the volume; protected segments in an edit that restores).
[[nodiscard]] Result<CutFrame> cutFrame(
    const CutFrameOptions& options, const Document& document, const QString& edit);

/// Nearest multiple of 2⁻¹⁶ mm.
[[nodiscard]] std::int32_t mm16(double mm);
/// Nearest multiples of 2⁻³⁰.
[[nodiscard]] Fixed3 toFixed30(const glm::dvec3& v);

} // namespace core
