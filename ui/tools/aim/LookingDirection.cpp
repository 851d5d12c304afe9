// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/aim/LookingDirection.h"

#include <algorithm>

namespace ui {

std::optional<glm::dvec3> lookingDirection(
    const gpu::VolumeScene& scene, int piece, const core::VolumeGeometry& geometry)
{
    if (scene.mode != gpu::RenderMode::Surface && scene.mode != gpu::RenderMode::Dvr)
        return std::nullopt;
    glm::dvec3 lps = scene.targetLps - scene.eyeLps;
    const auto shown = std::find_if(scene.pieces.begin(), scene.pieces.end(),
        [piece](const gpu::ScenePiece& each) { return piece != 0 && each.id == piece; });
    if (shown != scene.pieces.end())
        lps = glm::inverse(glm::dmat3(shown->shownFromTrue)) * lps;
    return geometry.toIndex(lps) - geometry.toIndex(glm::dvec3(0.0));
}

} // namespace ui
