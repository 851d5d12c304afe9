// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

namespace gpu {

class Program;

/// Sets the uniforms of surfaceColour.glsl.
void setMarkColours(Program& program, const SurfaceColours& colours);

} // namespace gpu
