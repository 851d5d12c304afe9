// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/edits/kinds/parts/HiddenSides.h"
#include "core/edits/kinds/parts/SparedSegments.h"
#include "core/sculpt/MaskFrame.h"

namespace core {

/// What a frame is made from, besides the volume.
struct MaskFrameOptions {
    OrthographicView view{};
    double surfaceThreshold = 0.0;
    double maskReachMm = 0.0; ///< from the middle to the farthest corner of the mask
    double maxDepthMm = 0.0;
    bool throughGaps = false;
    bool restore = false;
    HiddenSides hidden{};
    SparedSegments spared{};
};

/// Half the finest spacing resolves a mask; one that spans more than 512 elements needs no finer
/// ones. mm16.
[[nodiscard]] std::int32_t maskPitch(const VolumeGeometry& geometry, double maskReachMm);

/// Puts a mask plane before the first volume of a document. Doubles are used here and nowhere
/// after; the build forbids fused multiply-add, so every machine agrees.
/// @param edit name of the edit, for errors
/// Errors: InvalidField (no volume; a view without direction, or that looks far past the volume;
/// segments to spare while restoring).
[[nodiscard]] Result<MaskFrame> maskFrame(
    const MaskFrameOptions& options, const Document& document, const QString& edit);

/// Nearest multiple of 2⁻¹⁶ mm.
[[nodiscard]] std::int32_t mm16(double mm);

} // namespace core
