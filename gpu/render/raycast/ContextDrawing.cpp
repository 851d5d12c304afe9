// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/raycast/ContextDrawing.h"

namespace gpu {

VolumeScene segmentsAlone(const VolumeScene& scene)
{
    VolumeScene alone = scene;
    alone.mode = RenderMode::Surface;
    return alone;
}

glm::vec2 contextOpacity(const VolumeScene& scene)
{
    if (scene.context == Context::CutAway)
        return {1.0f, 0.0f};
    return glm::vec2(scene.context == Context::Translucent ? scene.contextOpacity : 1.0f);
}

int contextVariant(const VolumeScene& scene)
{
    switch (scene.context) {
    case Context::Opaque:
        return 0;
    case Context::Translucent:
        return scene.contextOpacity >= 1.0f ? 0 : 1;
    case Context::CutAway:
        return 1;
    case Context::Hidden:
        break;
    }
    return 2;
}

} // namespace gpu
