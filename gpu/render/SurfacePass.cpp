// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/SurfacePass.h"

#include "gpu/fields/textures/VolumeTextures.h"
#include "gpu/render/parts/RayBlocks.h"
#include "gpu/render/parts/SurfaceBuffers.h"
#include "gpu/render/parts/SurfaceColour.h"
#include "gpu/scene/ViewFrame.h"
#include "gpu/scene/WindowMapping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace gpu {

namespace {

constexpr float wireWidth = 1.3f; // frame pixels

void resize(SurfacePicture& picture, const glm::ivec2& size)
{
    if (picture.colours && picture.colours.size() == size)
        return;
    picture.colours = Texture2D({.label = "surface's colours", .size = size});
    picture.ways = Texture2D({.label = "ways to the surface", .size = size, .format = GL_R32F});
    picture.depth =
        Texture2D({.label = "surface's depth", .size = size, .format = GL_DEPTH_COMPONENT32F});
    picture.frame = Framebuffer({.label = "surface",
        .colours = {&picture.colours, &picture.ways},
        .depth = &picture.depth});
}

/// Depths that a box lies between, from a plane across the view.
std::array<double, 2> depthsOf(
    const WorldBox& box, const glm::dvec3& fromLps, const glm::dvec3& forward)
{
    std::array<double, 2> depths{1e300, -1e300};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::bvec3 upper(corner & 1, corner & 2, corner & 4);
        const double depth = glm::dot(glm::mix(box.minimum, box.maximum, upper) - fromLps, forward);
        depths = {std::min(depths[0], depth), std::max(depths[1], depth)};
    }
    return depths;
}

/// World planes as the shader wants them: hidden where dot(xyz, place) > w.
glm::vec4 planeOf(const glm::dvec3& normal, double offset)
{
    return {glm::vec3(normal), float(offset)};
}

void setCamera(Program& program, const WorldBox& bounds, const glm::ivec2& pictureSize,
    const VolumeScene& scene, const PassTarget& target)
{
    const ViewFrame view = ViewFrame::of(scene, target.frameSize);
    const double distance = view.distanceMm;
    const glm::dvec2 middle = view.middle - glm::dvec2(target.pixelJitter);
    const glm::dvec2 texels(pictureSize);
    // Columns: right, down and forward in mm from the target, then 1.
    const glm::dvec2 perMm = 2.0 / (view.mmPerPixel * double(target.pixelScale) * texels);
    const glm::dvec2 centre = 2.0 * middle / (double(target.pixelScale) * texels) - 1.0;
    glm::dmat4 clip{0.0};
    clip[0][0] = perMm.x;
    clip[1][1] = perMm.y;
    const glm::dvec3 eye = scene.targetLps - view.forward * distance;
    const double shear = glm::dot(view.across, view.forward);
    if (scene.orthographic) {
        const auto [near, far] = depthsOf(bounds, scene.targetLps, view.forward);
        const double margin = 0.01 * (far - near) + 1e-3;
        const double range = far - near + 2.0 * margin;
        clip[2] = glm::dvec4(perMm.x * shear, 0.0, 2.0 / range, 0.0);
        clip[3] = glm::dvec4(centre, -2.0 * (near - margin) / range - 1.0, 1.0);
    } else {
        auto [near, far] = depthsOf(bounds, eye, view.forward);
        near = std::max(0.99 * near, 0.1);
        far = std::max(1.01 * far, 2.0 * near);
        // w is the depth from the eye in distances of the target.
        const double slope = (far + near) / (far - near);
        clip[2] = glm::dvec4(centre / distance, slope / distance, 1.0 / distance);
        clip[2].x += perMm.x * shear;
        clip[3] = glm::dvec4(centre, slope - 2.0 * far * near / (far - near) / distance, 1.0);
    }
    const glm::dvec3 up = -view.down;
    const glm::dvec3 toLight = glm::normalize(-view.forward * 0.80 + up * 0.48 - view.right * 0.36);
    program.set("clipFromView", glm::mat4(clip))
        .set("viewRight", glm::vec3(view.right))
        .set("viewDown", glm::vec3(view.down))
        .set("viewForward", glm::vec3(view.forward))
        .set("viewTarget", glm::vec3(scene.targetLps))
        .set("sight", glm::vec3(view.sight))
        .set("eyeToTarget", glm::vec3(view.targetLps - view.eyeLps))
        .set("orthographic", scene.orthographic)
        .set("wayPerDepth", float(1.0 / glm::dot(view.sight, view.forward)))
        .set("toLight", glm::vec3(toLight))
        .set("viewUp", glm::vec3(up));
}

/// What hides parts of it.
std::vector<glm::vec4> planesOf(const VolumeTextures& volume, const VolumeScene& scene)
{
    std::vector<glm::vec4> planes;
    const glm::dmat4 worldToIndex = volume.geometry().worldToIndex();
    for (const core::HalfSpace& half : core::halfSpaces(scene.clip, volume.geometry())) {
        // dot(n, M p + b) ≤ w
        const glm::dvec3 normal = glm::transpose(glm::dmat3(worldToIndex)) * half.normal;
        const double offset = half.offset - glm::dot(half.normal, glm::dvec3(worldToIndex[3]));
        const double length = glm::length(normal);
        if (length > 0.0)
            planes.push_back(planeOf(normal / length, offset / length));
    }
    const core::ClipPlane& own = scene.surface->clip;
    if (own.on)
        planes.push_back(planeOf(own.normalLps, glm::dot(own.normalLps, own.pointLps)));
    return planes;
}

void setLook(Program& program, const VolumeTextures& volume, const SceneSurface& look,
    const PassTarget& target)
{
    const glm::dvec3 voxel = 1.0 / glm::dvec3(volume.size());
    const glm::dmat4 worldToIndex = volume.geometry().worldToIndex();
    glm::dmat4 worldToTexture = worldToIndex;
    worldToTexture[3] += glm::dvec4(glm::dvec3(0.5), 0.0);
    for (int column = 0; column < 4; ++column)
        worldToTexture[column] *= glm::dvec4(voxel, 1.0);
    setMarkColours(program, look.colours);
    program.set("wireHalf", std::max(0.5f * wireWidth / target.pixelScale, 0.35f))
        .set("worldToTexture", glm::mat4(worldToTexture))
        .set("window", glm::vec2(greyOfTexel(volume.encoding(), look.window)));
}

/// Whether an eye may look at the inside of a surface that is closed and whole.
bool mayBeInside(const WorldBox& bounds, const VolumeScene& scene)
{
    const double margin =
        1.0 + std::abs(scene.eyeShiftMm) + 0.01 * glm::length(bounds.maximum - bounds.minimum);
    return !scene.orthographic && glm::all(glm::greaterThan(scene.eyeLps, bounds.minimum - margin))
        && glm::all(glm::lessThan(scene.eyeLps, bounds.maximum + margin));
}

} // namespace

SurfacePass::SurfacePass(const ShaderLibrary& library)
    : m_library(library)
{
}

Program& SurfacePass::programFor(SurfaceStyle style, bool hides)
{
    Program& known = m_programs[2 * std::size_t(style) + std::size_t(hides)];
    if (!known)
        known = Program(m_library,
            {.label = "surface",
                .vertexPath = "render/surfacePass.vert",
                .fragmentPath = "render/surfacePass.frag",
                .defines = {{"WIRES", style == SurfaceStyle::Wireframe ? 1 : 0},
                    {"GREYS", style == SurfaceStyle::GreyValues ? 1 : 0},
                    {"HIDES", hides ? 1 : 0}}});
    return known;
}

void SurfacePass::draw(SurfacePicture& picture, const SurfaceBuffers& surface,
    VolumeTextures& volume, const VolumeScene& scene, const PassTarget& target)
{
    picture.blocks = {};
    if (surface.empty() || !scene.surface || scene.surface->opacity <= 0.0f)
        return;
    const WorldBox& bounds = surface.bounds();
    picture.blocks = blocksAround(
        glm::vec3(bounds.minimum), glm::vec3(bounds.maximum), glm::dmat4(1.0), scene, target);
    resize(picture, target.frameSize);
    const std::vector<glm::vec4> planes = planesOf(volume, scene);
    Program& program = programFor(scene.surface->style, !planes.empty());
    setCamera(program, bounds, picture.colours.size(), scene, target);
    setLook(program, volume, *scene.surface, target);
    if (!planes.empty())
        program.set("hiddenBeyond", std::span<const glm::vec4>(planes))
            .set("hiddenCount", int(planes.size()));
    volume.intensity().bindUnit(0);

    picture.frame.bind();
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    picture.frame.clear();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    const bool frontAlone = planes.empty() && scene.surface->style != SurfaceStyle::Wireframe
        && !mayBeInside(bounds, scene);
    if (frontAlone) {
        glEnable(GL_CULL_FACE);
        glCullFace(GL_FRONT); // rows run downwards: what faces the viewer turns to the right
    }
    program.use();
    surface.draw();
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
}

} // namespace gpu
