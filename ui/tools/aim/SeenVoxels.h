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

/// A voxel that the user sees.
struct SeenVoxel {
    glm::ivec3 voxel{0}; ///< at its true place
    int piece = 0; ///< id of the piece on which it was seen; 0: on the rest of the volume
};

/// One for each point; none if nothing is seen there.
using SeenVoxels = std::vector<std::optional<SeenVoxel>>;

/// Asks which voxels the user sees at these points of a 3D view. On a piece the answer is the voxel
/// at its true place, wherever the piece is shown: the ray is transformed by the piece's pose. The
/// answer arrives in EditSession::poll(), unless the session closes.
/// @param planeMm points in the view plane, mm right of and above the target
void askWhatIsSeen(Workspace& workspace, const gpu::VolumeScene& scene,
    const std::vector<glm::dvec2>& planeMm,
    const std::function<void(const core::Result<SeenVoxels>&)>& then);

/// Asks what the user points at there. It differs from what is seen where the volume steps back for
/// segments (translucent or cut away): there a ray that meets a shown segment means segments and
/// pieces alone, whatever tissue lies in front of them. Tools that work on tissue ask for what is
/// seen.
void askWhatIsPointedAt(Workspace& workspace, const gpu::VolumeScene& scene,
    const std::vector<glm::dvec2>& planeMm,
    const std::function<void(const core::Result<SeenVoxels>&)>& then);

} // namespace ui
