// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/growth/GrowthCommands.h"
#include "core/volume/Volume.h"

namespace core {

struct GrowBox;
struct GrowCriteria;

/// How many codes two values may lie apart that differ by at most @p bound, by search; −1 if that
/// is below 0.
[[nodiscard]] int greatestDifference(const VoxelEncoding& encoding, double bound);

/// How gradients of a volume are counted in whole numbers: fine where its values span little, and
/// never so fine that one overflows.
struct GradientScale {
    glm::ivec3 weights{0}; ///< GrowLimits::gradientWeights
    double perUnit = 0.0; ///< magnitude of one modality unit a millimetre
};
[[nodiscard]] GradientScale gradientScale(const Volume& volume);

/// The voxels of a box, inclusive. Errors: InvalidField (@p field: no part of it lies in the
/// volume).
struct VoxelSpan {
    glm::ivec3 from{0};
    glm::ivec3 to{0};
};
[[nodiscard]] Result<VoxelSpan> voxelsOf(
    const GrowBox& box, const VolumeGeometry& geometry, const QString& field);

/// The widest passage that can be asked for in a volume, mm.
[[nodiscard]] double greatestPassageMm(const VolumeGeometry& geometry);
/// The least that asks for anything: narrower balls hold only their centre.
[[nodiscard]] double leastPassageMm(const VolumeGeometry& geometry);
/// A passage width in whole numbers: units are sixteenths of the finest spacing. Asks nothing where
/// a ball holds only its centre. @param widthMm not above greatestPassageMm()
[[nodiscard]] Passage passageOf(double widthMm, const VolumeGeometry& geometry);

/// All criteria but interval, neighbours and labels. @param edit its name, for messages. Errors:
/// those of voxelsOf(), InvalidField (a passage that is too wide).
[[nodiscard]] Result<GrowLimits> growLimits(
    const GrowCriteria& criteria, const Volume& volume, const QString& edit);

} // namespace core
