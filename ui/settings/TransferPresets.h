// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"
#include "gpu/scene/Scene.h"

#include <QString>

#include <vector>

namespace ui {

/// A named transfer function.
struct TransferPreset {
    QString name;
    gpu::TransferFunction function;
};

/// The presets for a volume; the first is its initial one. For CT they show bone, skin and vessels
/// in HU; for everything else they are ramps over the values that most voxels beyond the air have,
/// so that they suit any scale, and a few voxels that are far brighter do not matter.
[[nodiscard]] std::vector<TransferPreset> transferPresets(const core::Volume& volume);

/// The value below which @p share (0 … 1) of the voxels lie, by the histogram.
[[nodiscard]] double quantile(const core::Histogram& histogram, double share);
/// The same, of the voxels with values from @p from on; at least @p from and the maximum if there
/// are none.
[[nodiscard]] double quantileAbove(const core::Histogram& histogram, double from, double share);

} // namespace ui
