// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <glm/glm.hpp>

namespace test {

// Scenes with a slab of matter, seen along +y.

[[nodiscard]] inline double noMatter(const glm::dvec3&)
{
    return 0.0;
}

/// Returns a volume's code by place: 2000 between two y coordinates (LPS mm), 0 elsewhere.
[[nodiscard]] inline auto slabBetween(double fromY, double toY)
{
    return [=](const glm::dvec3& lps) { return lps.y >= fromY && lps.y <= toY ? 2000.0 : 0.0; };
}

[[nodiscard]] inline gpu::VolumeScene sceneAlongY(gpu::RenderMode mode)
{
    gpu::VolumeScene result;
    result.mode = mode;
    result.eyeLps = {0.0, -230.0, 0.0};
    result.heightMm = 80.0;
    result.surfaceThreshold = 1000.0;
    result.mipWindow = {2000.0, 4001.0};
    result.xrayWindow = {2000.0, 4001.0};
    result.transferFunction.points = {{1000.0, 0xFFFFFF, 0.0}, {1900.0, 0xFFFFFF, 0.9}};
    return result;
}

/// Returns the look of a surface whose appearance depends on light only, not on its place.
[[nodiscard]] inline gpu::SceneSurface plainLook()
{
    gpu::SceneSurface look;
    look.colours.rgb = 0x4080E0;
    look.colours.markOpacity = 0.0f;
    look.behindOpacity = 0.0f;
    return look;
}

} // namespace test
