// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/RaycastPass.h"

#include "gpu/render/ViewFrame.h"
#include "gpu/render/WindowMapping.h"
#include "gpu/textures/VolumeTextures.h"

#include <algorithm>
#include <cmath>

namespace gpu {

namespace {

/// Steps in units of the finest spacing. Surfaces are refined by bisection, so the step only has to
/// find them; the other modes refine by accumulated, jittered pictures.
double stepMm(RenderMode mode, const core::VolumeGeometry& geometry)
{
    const glm::dvec3 spacing = geometry.spacingMm();
    const double finest = std::min({spacing.x, spacing.y, spacing.z});
    switch (mode) {
    case RenderMode::Surface:
        return 0.8 * finest;
    case RenderMode::Dvr:
        return 0.8 * finest;
    case RenderMode::Mip:
        return 0.8 * finest;
    case RenderMode::Xray:
        break; // a mean: every voxel once
    }
    return finest;
}

} // namespace

RaycastPass::RaycastPass(const ShaderLibrary& library)
{
    static constexpr std::array<const char*, renderModes> labels{
        "surface", "volume rendering", "MIP", "X-ray"};
    for (std::size_t mode = 0; mode < labels.size(); ++mode) {
        for (int sculpted = 0; sculpted < 2; ++sculpted) {
            m_programs[2 * mode + std::size_t(sculpted)] = Program(library,
                {.label = labels[mode],
                    .fragmentPath = "render/raycast.frag",
                    .defines = {{"MODE", int(mode)}, {"SCULPTED", sculpted}}});
        }
    }
}

void RaycastPass::prepare(VolumeTextures& volume, const VolumeScene& scene, const Palette& palette,
    const PassTarget& target)
{
    const auto mode = std::size_t(scene.mode);
    const bool sculpted = volume.cells().isSculpted();
    m_warm[mode] = m_warm[mode] || sculpted;
    prepare(m_programs[2 * mode + (sculpted ? 1 : 0)], volume, scene, palette, target);
}

bool RaycastPass::prepareWarmUp(VolumeTextures& volume, const VolumeScene& scene,
    const Palette& palette, const PassTarget& target)
{
    const auto mode = std::size_t(scene.mode);
    if (m_warm[mode])
        return false;
    m_warm[mode] = true;
    prepare(m_programs[2 * mode + 1], volume, scene, palette, target);
    return true;
}

void RaycastPass::prepare(Program& active, VolumeTextures& volume, const VolumeScene& scene,
    const Palette& palette, const PassTarget& target)
{
    setRays(active, volume, scene, ViewFrame::of(scene, target.frameSize), target);
    const VisibleCodes visible = setMode(active, volume, scene);
    volume.intensity().bindUnit(0);
    volume.radiation().bindUnit(1);
    volume.segmentation().bindUnit(2);
    volume.labels().bindUnit(3);
    volume.cells().skipMap(visible).bindUnit(4);
    volume.cells().ranges().bindUnit(5);
    m_transfer.texture().bindUnit(6);
    palette.texture().bindUnit(7);
    volume.maximumCells().texture().bindUnit(8);
    active.use();
}

void RaycastPass::setRays(Program& program, const VolumeTextures& volume, const VolumeScene& scene,
    const ViewFrame& view, const PassTarget& target)
{
    const glm::dmat4 worldToIndex = volume.geometry().worldToIndex();
    const glm::dvec3 voxel = 1.0 / glm::dvec3(volume.size());
    const glm::dmat3 indexToTexture(
        glm::dvec3(voxel.x, 0, 0), glm::dvec3(0, voxel.y, 0), glm::dvec3(0, 0, voxel.z));
    const glm::dmat3 worldToTexture = indexToTexture * glm::dmat3(worldToIndex);
    const auto toTexture = [&](const glm::dvec3& lps) {
        return (glm::dvec3(worldToIndex * glm::dvec4(lps, 1.0)) + 0.5) * voxel;
    };
    const glm::dvec2 middle = glm::dvec2(target.frameSize) * 0.5;
    const glm::dvec3 perX = worldToTexture * (view.right * view.mmPerPixel);
    const glm::dvec3 perY = worldToTexture * (view.down * view.mmPerPixel);
    const glm::dvec3 forward = worldToTexture * view.forward;

    glm::dvec3 originBase = toTexture(scene.eyeLps);
    glm::dvec3 originPerX{0.0};
    glm::dvec3 originPerY{0.0};
    glm::dvec3 directionBase = forward;
    glm::dvec3 directionPerX{0.0};
    glm::dvec3 directionPerY{0.0};
    double planePerPixel = 0.0;
    double nearest = 0.0;
    if (scene.orthographic) {
        originBase = toTexture(scene.targetLps) - perX * middle.x - perY * middle.y;
        originPerX = perX;
        originPerY = perY;
        nearest = -1e6; // the whole volume, wherever the eye is said to be
    } else {
        const double distance = std::max(view.distanceMm, 1e-6);
        directionPerX = perX / distance;
        directionPerY = perY / distance;
        directionBase = forward - directionPerX * middle.x - directionPerY * middle.y;
        planePerPixel = view.mmPerPixel / distance;
    }
    const glm::dvec3 up = -view.down;
    const glm::dvec3 toLight = glm::normalize(-view.forward * 0.80 + up * 0.48 - view.right * 0.36);
    // The golden ratio spreads the phases of any number of pictures evenly.
    const double phase = std::fmod(target.sample * 0.6180339887498949, 1.0);
    program.set("originBase", glm::vec3(originBase))
        .set("originPerX", glm::vec3(originPerX))
        .set("originPerY", glm::vec3(originPerY))
        .set("directionBase", glm::vec3(directionBase))
        .set("directionPerX", glm::vec3(directionPerX))
        .set("directionPerY", glm::vec3(directionPerY))
        .set("planeCentre", glm::vec2(middle))
        .set("planePerPixel", float(planePerPixel))
        .set("nearest", float(nearest))
        .set("stepMm", float(stepMm(scene.mode, volume.geometry())))
        .set("jitterPhase", float(phase))
        .set("pixelScale", target.pixelScale)
        .set("pixelJitter", target.pixelJitter)
        .set("voxel", glm::vec3(voxel))
        .set("gradientToWorld", glm::mat3(glm::transpose(glm::dmat3(worldToIndex))))
        .set("worldToTexture", glm::mat3(worldToTexture))
        .set("textureToWorld", glm::mat3(glm::inverse(worldToTexture)))
        .set("toLight", glm::vec3(toLight))
        .set("viewUp", glm::vec3(up))
        .set("aoTilt", target.sample == 0 ? 0.0f : 0.9f);
}

VisibleCodes RaycastPass::setMode(
    Program& program, VolumeTextures& volume, const VolumeScene& scene)
{
    constexpr int lastCode = core::VoxelEncoding::codeCount - 1;
    const core::VoxelEncoding& encoding = volume.encoding();
    switch (scene.mode) {
    case RenderMode::Surface: {
        const int code = encoding.lowestCodeAtLeast(scene.surfaceThreshold);
        const double solid = std::max((volume.cells().greatestCode() - code) * 0.35, 4.0);
        program.set("threshold", float(code / 65535.0))
            .set("denseSpan", float(solid / 65535.0))
            .set("aoRadius", 14.0f);
        return {{{code, lastCode}}};
    }
    case RenderMode::Dvr: {
        m_transfer.set(scene.transferFunction, stepMm(scene.mode, volume.geometry()));
        const glm::dvec2 value = valueOfTexel(encoding);
        program.set("lookup", glm::vec2(m_transfer.entryOfTexel(encoding)))
            .set("gradientFull", float(0.08 * m_transfer.span() / value.x));
        return TransferLookup::visibleCodes(scene.transferFunction, encoding);
    }
    case RenderMode::Mip: {
        const glm::dvec2 grey = greyOfTexel(encoding, scene.mipWindow);
        std::array<float, MaximumCells::levelCount> levels{};
        for (std::size_t k = 0; k < levels.size(); ++k)
            levels[k] = float(volume.maximumCells().levels()[k] / 65535.0);
        program.set("window", glm::vec2(grey))
            .set("saturated", float((1.0 - grey.y) / grey.x))
            .set("black", float(-grey.y / grey.x))
            .set("levels", std::span<const float>(levels));
        // What is black anyway need not be looked at.
        const double black = -grey.y / grey.x * 65535.0;
        return {{{int(std::clamp(std::floor(black), 0.0, double(lastCode))), lastCode}}};
    }
    case RenderMode::Xray:
        program.set("window", glm::vec2(greyOfTexel(encoding, scene.xrayWindow)));
        return {{{0, lastCode}}}; // all that is not carved away counts
    }
    return {};
}

} // namespace gpu
