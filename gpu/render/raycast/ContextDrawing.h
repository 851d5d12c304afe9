// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <glm/vec2.hpp>

namespace gpu {

/// Returns the scene in which only segments are drawn. They look the same in all render modes.
[[nodiscard]] VolumeScene segmentsAlone(const VolumeScene& scene);

/// Returns how much the volume around segments counts, from 0 to 1: x on rays that meet neither a
/// segment nor the refined surface, y on all other rays (context.glsl).
[[nodiscard]] glm::vec2 contextOpacity(const VolumeScene& scene);

/// Returns the value of CONTEXT in the shaders of the ray caster (context.glsl). 0: the volume is
/// drawn as it is; 1: it is translucent, or cut away in front of segments; 2: it is not drawn.
[[nodiscard]] int contextVariant(const VolumeScene& scene);

} // namespace gpu
