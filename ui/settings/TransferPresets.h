// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"
#include "gpu/scene/Scene.h"

#include <QString>

#include <vector>

namespace ui {

/// A way to see through a volume, with a name.
struct TransferPreset {
    QString name;
    gpu::TransferFunction function;
};

/// What a volume starts with comes first. Bone, skin and vessels in HU for CT; for everything else
/// ramps over the values that the bulk of the voxels hold, so that they suit any scale.
[[nodiscard]] std::vector<TransferPreset> transferPresets(const core::Volume& volume);

/// The value below which @p share of the voxels lie, after the histogram.
[[nodiscard]] double quantile(const core::Histogram& histogram, double share);

} // namespace ui
