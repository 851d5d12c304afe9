// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/parts/SurfaceColour.h"

#include "gpu/gl/Program.h"

namespace gpu {

namespace {

glm::vec3 colourOf(std::uint32_t rgb)
{
    return glm::vec3(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255) / 255.0f;
}

} // namespace

void setMarkColours(Program& program, const SurfaceColours& colours)
{
    std::array<glm::vec4, 3> marks;
    for (std::size_t mark = 0; mark < marks.size(); ++mark)
        marks[mark] =
            glm::vec4(colourOf(colours.markRgb[mark]), mark == 0 ? colours.yellowShare : 1.0f);
    program.set("ownColour", colourOf(colours.rgb))
        .set("markColours", std::span<const glm::vec4>(marks))
        .set("markOpacity", colours.markOpacity);
}

} // namespace gpu
