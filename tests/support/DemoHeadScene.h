// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/SimplexMesh.h"
#include "gpu/frame/Scene.h"

namespace test {

class FrameFixture;

/// Opens the demonstration head.
void openDemoHead(FrameFixture& fixture);
/// The surface of its brain: 20 000 vertices, some of them marked.
[[nodiscard]] core::SimplexMesh demoBrain();
/// A look at it from above its right shoulder; a clip plane opens it.
[[nodiscard]] gpu::VolumeScene demoHeadScene();

} // namespace test
