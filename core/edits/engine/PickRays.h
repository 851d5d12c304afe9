// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/OrthographicView.h"
#include "core/sculpt/PickRay.h"
#include "core/volume/ClipRegion.h"
#include "core/volume/VolumeGeometry.h"

#include <glm/glm.hpp>

#include <vector>

namespace core {

/// The rays of an orthographic view, in the integers of an engine.
struct PickRays {
    /// One per point, in their order; a ray that misses the volume has no samples.
    std::vector<PickRay> rays;
    double sampleMm = 0.0; ///< distance of neighbouring samples: half the finest spacing
};

/// Makes them. Each ray starts at its first sample inside the volume and the clip region and ends
/// at its last.
/// @param planeMm points in the view plane: right of and above the target, mm
[[nodiscard]] PickRays pickRays(const OrthographicView& view,
    const std::vector<glm::dvec2>& planeMm, const VolumeGeometry& geometry,
    const ClipRegion& clip = {});

} // namespace core
