// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <glm/glm.hpp>

namespace test {

// What is looked at along +y, through or past a slab.

[[nodiscard]] inline double noMatter(const glm::dvec3&)
{
    return 0.0;
}

/// Matter of code 2000 between two coordinates along y.
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

/// Of a surface that looks the same wherever it is, but for its light.
[[nodiscard]] inline gpu::SceneSurface plainLook()
{
    gpu::SceneSurface look;
    look.colours.rgb = 0x4080E0;
    look.colours.markOpacity = 0.0f;
    look.behindOpacity = 0.0f;
    return look;
}

} // namespace test
