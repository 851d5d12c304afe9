// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/edits/engine/BoxVoxels.h"
#include "core/growth/GrowthCommands.h"
#include "core/volume/Volume.h"

namespace core {

struct GrowCriteria;

/// The greatest difference of two codes whose values differ by at most @p bound, found by search;
/// −1 if @p bound is negative.
[[nodiscard]] int greatestDifference(const VoxelEncoding& encoding, double bound);

/// How gradients of a volume are expressed in integers: finer for a smaller range of values, but
/// never so fine that a number overflows.
struct GradientScale {
    glm::ivec3 weights{0}; ///< GrowLimits::gradientWeights
    double perUnit = 0.0; ///< magnitude for one modality unit per millimetre
};
[[nodiscard]] GradientScale gradientScale(const Volume& volume);

/// The greatest passage width that a volume allows, mm.
[[nodiscard]] double greatestPassageMm(const VolumeGeometry& geometry);
/// The least width that has an effect, mm: narrower balls contain only their centre.
[[nodiscard]] double leastPassageMm(const VolumeGeometry& geometry);
/// A passage width in integers; units are sixteenths of the finest spacing. It has no effect if a
/// ball contains only its centre.
/// @param widthMm not above greatestPassageMm()
[[nodiscard]] Passage passageOf(double widthMm, const VolumeGeometry& geometry);

/// Converts all criteria except interval, connectivity and labels.
/// @param edit its name, for messages
/// Errors: those of voxelsOf(), InvalidField (a passage that is too wide).
[[nodiscard]] Result<GrowLimits> growLimits(
    const GrowCriteria& criteria, const Volume& volume, const QString& edit);

} // namespace core
