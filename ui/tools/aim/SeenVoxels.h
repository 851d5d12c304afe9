// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "gpu/scene/Scene.h"

#include <glm/glm.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace ui {

class Workspace;

struct SeenVoxel {
    glm::ivec3 voxel{0}; ///< at its true place
    int piece = 0; ///< id of what it was seen on; 0: what is left of the volume
};

/// One per point; none: nothing is seen there.
using SeenVoxels = std::vector<std::optional<SeenVoxel>>;

/// Asks which voxels the user sees at these points of a 3D view. What is seen of a piece means its
/// true place, wherever it is shown: its voxel is found along the ray that the pose takes there.
/// Answered by EditSession::poll(), unless the session closes.
/// @param planeMm points in the view plane, mm right of and above the target
void askWhatIsSeen(Workspace& workspace, const gpu::VolumeScene& scene,
    const std::vector<glm::dvec2>& planeMm,
    const std::function<void(const core::Result<SeenVoxels>&)>& then);

} // namespace ui
