// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/SlicePass.h"

#include "gpu/edit/BrickField.h"
#include "gpu/render/WindowMapping.h"
#include "gpu/textures/VolumeTextures.h"

namespace gpu {

SlicePass::SlicePass(const ShaderLibrary& library)
{
    for (int variant = 0; variant < variants; ++variant) {
        m_programs[std::size_t(variant)] = Program(library,
            {.label = "slice",
                .fragmentPath = "render/slice.frag",
                .defines = {{"LABELED", variant & 1}, {"CARVED", variant >> 1 & 1},
                    {"BARRIERS", variant >> 2 & 1}, {"WARNED", variant >> 3}}});
    }
}

void SlicePass::prepare(VolumeTextures& volume, const SliceScene& scene,
    const SegmentDisplay& segments, const Palette& palette, const PassTarget& target)
{
    const glm::dmat4 worldToIndex = volume.geometry().worldToIndex();
    const glm::dmat3 directions(worldToIndex);
    const glm::dvec3 perX = directions * (scene.rightLps * scene.mmPerPixel);
    const glm::dvec3 perY = directions * (scene.downLps * scene.mmPerPixel);
    const glm::dvec2 middle = glm::dvec2(target.frameSize) * 0.5;
    const glm::dvec3 base = glm::dvec3(worldToIndex * glm::dvec4(scene.centreLps, 1.0))
        - perX * middle.x - perY * middle.y;

    volume.intensity().bindUnit(0);
    volume.radiation().bindUnit(1);
    volume.labels().bindUnit(3);
    palette.texture().bindUnit(7);
    BrickField* words = volume.seedWords();
    Program& program = m_programs[(volume.touched(VolumeField::Labels) ? 1u : 0u)
        + (volume.touched(VolumeField::Radiation) ? 2u : 0u)
        + (words && volume.touched(VolumeField::Barriers) ? 4u : 0u)
        + (words && palette.warns() ? 8u : 0u)];
    if (words) {
        words->atlas().bindUnit(14);
        words->pageTable().bindUnit(15);
    }
    program.set("base", glm::vec3(base))
        .set("perX", glm::vec3(perX))
        .set("perY", glm::vec3(perY))
        .set("pixelScale", target.pixelScale)
        .set("window", glm::vec2(greyOfTexel(volume.encoding(), scene.window)))
        .set("inverted", scene.inverted)
        .set("interpolated", scene.interpolated)
        .set("showCarved", scene.showCarved)
        .set("carvedAsHole", scene.carvedAsHole)
        .set("warnAfter", segments.warnAfterGeneration)
        .set("fillOpacity", segments.fillOpacity)
        .set("outlineWidth", segments.outlineWidthPixels);
    program.use();
}

} // namespace gpu
