// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <glm/vec2.hpp>

namespace gpu {

/// The scene in which segments alone are drawn: they look alike in all modes.
[[nodiscard]] VolumeScene segmentsAlone(const VolumeScene& scene);

/// How much of the volume around segments counts, from 0 to 1: x on rays that meet neither a
/// segment nor the refined surface, y on the others (context.glsl).
[[nodiscard]] glm::vec2 contextOpacity(const VolumeScene& scene);

/// The value of CONTEXT in the shaders of the ray caster (context.glsl): 0 if the volume is drawn
/// as it is, 1 if it is translucent or cut away in front of segments, 2 if it is not drawn.
[[nodiscard]] int contextVariant(const VolumeScene& scene);

} // namespace gpu
