// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

namespace bench {

/// An abdomen made of formulas, as large as studies get: 512 × 512 × 600 voxels of 0.75 × 0.75 ×
/// 1 mm with a scanner's noise. In it a bumpy liver of about 1.5 L with vessels, in a sheath of
/// fat. The same voxels on every call.
struct TorsoVolume {
    static constexpr glm::ivec3 size{512, 512, 600};
    static constexpr double liverHu = 110.0;
    static constexpr double noiseHu = 18.0; ///< standard deviation

    /// The interval a radiologist would grow the liver with: mean ± 2.5 σ.
    static constexpr double lowerHu = liverHu - 2.5 * noiseHu;
    static constexpr double upperHu = liverHu + 2.5 * noiseHu;

    /// @param slices so many around the middle
    [[nodiscard]] static core::LoadedVolume make(int slices = size.z);
    [[nodiscard]] static glm::dvec3 liverLps();
    /// Half-axes of the body, an ellipse around the z axis.
    static constexpr glm::dvec2 bodyMm{175.0, 120.0};
};

} // namespace bench
