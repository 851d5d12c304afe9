// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/PlanePass.h"

#include "gpu/fields/textures/VolumeTextures.h"
#include "gpu/render/SlicePass.h"
#include "gpu/render/parts/RayBlocks.h"
#include "gpu/render/parts/SurfaceBuffers.h"
#include "gpu/render/parts/SurfaceColour.h"
#include "gpu/scene/ViewFrame.h"

#include <cmath>
#include <cstddef>

namespace gpu {

namespace {

constexpr double edgeOn = 1e-5; // 1: straight on

void resize(PlanePicture& picture, const glm::ivec2& size)
{
    if (picture.colours && picture.colours.size() == size)
        return;
    picture.colours = Texture2D({.label = "plane's colours", .size = size});
    picture.ways = Texture2D({.label = "ways to the plane", .size = size, .format = GL_R32F});
    picture.frame = Framebuffer({.label = "plane", .colours = {&picture.colours, &picture.ways}});
}

Tile blocksOf(const ScenePlane& plane, const VolumeScene& scene, const PassTarget& target)
{
    const glm::dmat4 fromMm(glm::dvec4(plane.rightLps, 0.0), glm::dvec4(plane.downLps, 0.0),
        glm::dvec4(glm::cross(plane.rightLps, plane.downLps), 0.0),
        glm::dvec4(plane.centreLps, 1.0));
    const glm::vec3 corner(glm::vec2(plane.halfSizeMm), 0.0f);
    return blocksAround(-corner, corner, fromMm, scene, target);
}

glm::vec3 colourOf(std::uint32_t rgb)
{
    return glm::vec3(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255) / 255.0f;
}

/// What of a slice it shows.
SliceScene lookOf(const ScenePlane& plane, const VolumeScene& scene)
{
    return {.centreLps = plane.centreLps,
        .rightLps = plane.rightLps,
        .downLps = plane.downLps,
        .window = plane.window,
        .inverted = plane.inverted,
        .colours = plane.colours,
        .interpolation = plane.interpolation,
        .showCarved = plane.showCarved,
        .chunks = scene.chunks};
}

/// Uniforms of planePixel.glsl.
void setPlane(Program& program, const VolumeTextures& volume, const VolumeScene& scene,
    const PassTarget& target)
{
    const ScenePlane& plane = *scene.plane;
    const ViewFrame view = ViewFrame::of(scene, target.frameSize);
    // From the frame's middle: fewer digits are lost.
    const glm::dmat3 fromMiddle(
        glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(-view.middle, 1.0));
    const glm::dmat3 mmFromPixel =
        glm::inverse(fromMiddle * SeenPlane::of(plane, view).pixelFromMm);
    const glm::dmat4 worldToIndex = volume.geometry().worldToIndex();
    const glm::dmat3 directions(worldToIndex);
    const auto wayOf = [&view](const glm::dvec3& mm) {
        return glm::dot(mm, view.forward) / glm::dot(view.sight, view.forward);
    };
    const glm::dvec3 wayAlong(
        wayOf(plane.rightLps), wayOf(plane.downLps), wayOf(plane.centreLps - view.targetLps));
    program.set("mmFromPixel", glm::mat3(mmFromPixel))
        .set("middle", glm::vec2(view.middle))
        .set("centreIndex", glm::vec3(worldToIndex * glm::dvec4(plane.centreLps, 1.0)))
        .set("perRight", glm::vec3(directions * plane.rightLps))
        .set("perDown", glm::vec3(directions * plane.downLps))
        .set("halfSize", glm::vec2(plane.halfSizeMm))
        .set("wayAlong", glm::vec3(wayAlong))
        .set("eyeDistance", view.orthographic ? 0.0f : float(view.distanceMm))
        .set("ahead", glm::vec2(view.ahead))
        .set("pixelMm", float(view.mmPerPixel))
        .set("opacity", plane.opacity)
        .set("rimColour", colourOf(plane.rimRgb))
        .set("rimWidth", plane.rimWidthPixels);
}

} // namespace

PlanePass::PlanePass()
    : m_noContour({.label = "no contour"})
{
    m_noContour.clear();
}

void PlanePass::begin(PlanePicture& picture, ContourPass* contours, const SurfaceBuffers& surface,
    const VolumeScene& scene, const PassTarget& target)
{
    picture.blocks = {};
    const ScenePlane& plane = *scene.plane;
    const ViewFrame view = ViewFrame::of(scene, target.frameSize);
    const SeenPlane seen = SeenPlane::of(plane, view);
    // 0 also where the eye lies in it.
    const double straightOn =
        std::abs(glm::determinant(seen.pixelFromMm)) * view.mmPerPixel * view.mmPerPixel;
    const bool lines = contours && plane.contour && !surface.empty();
    if (!lines)
        picture.contour = {};
    if (straightOn < edgeOn || (plane.opacity <= 0.0f && !lines))
        return;
    // Of pictures with moved sampling points it is the same: it is smooth without them.
    if (lines && target.sample == 0)
        contours->draw(picture.contour, surface, seen, *plane.contour, target);
    if (plane.opacity <= 0.0f && picture.contour.isEmpty())
        return;
    picture.blocks = blocksOf(plane, scene, target);
    resize(picture, target.frameSize);
    picture.frame.bind();
    glDisable(GL_SCISSOR_TEST);
    picture.frame.clear();
}

void PlanePass::draw(PlanePicture& picture, SlicePass& slices, VolumeTextures& volume,
    const VolumeScene& scene, const SegmentDisplay& segments, const Palette& palette,
    const PassTarget& target, const Tile& tile, const VertexArray& noVertices,
    const ChunkTextures* chunks)
{
    const glm::ivec2 low = glm::max(tile.minimum, picture.blocks.minimum);
    const glm::ivec2 high =
        glm::min(tile.minimum + tile.size, picture.blocks.minimum + picture.blocks.size);
    if (!glm::all(glm::lessThan(low, high)))
        return;
    Program& program = slices.prepareOnPlane(
        volume, lookOf(*scene.plane, scene), segments, palette, target, chunks);
    program.set("maskLabel", unsigned(scene.plane->mask));
    setPlane(program, volume, scene, target);
    const bool lines = !picture.contour.isEmpty();
    (lines ? picture.contour.cover : m_noContour).bindUnit(23);
    program.set("contourThere", lines ? 1 : 0);
    setMarkColours(program, scene.plane->contour.value_or(SceneContour{}).colours);
    picture.frame.bind();
    glDisable(GL_BLEND);
    glEnable(GL_SCISSOR_TEST);
    glScissor(low.x, low.y, high.x - low.x, high.y - low.y);
    program.use();
    noVertices.drawFullScreenTriangle();
    glDisable(GL_SCISSOR_TEST);
}

} // namespace gpu
