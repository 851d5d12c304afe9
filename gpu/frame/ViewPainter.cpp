// SPDX-License-Identifier: Apache-2.0
#include "gpu/frame/ViewPainter.h"

#include "gpu/fields/textures/VolumeTextures.h"

namespace gpu {

ViewPainter::ViewPainter(VolumeTextures& volume, const ShaderLibrary& shaders)
    : m_volume(volume)
    , m_shaders(shaders)
    , m_raycast(shaders)
    , m_slice(shaders)
    , m_noVertices("no vertices")
{
}

ContourPass* ViewPainter::contours(bool wanted)
{
    if (!wanted || m_surface.empty())
        return nullptr;
    if (!m_contourPass)
        m_contourPass.emplace(m_shaders);
    return &*m_contourPass;
}

bool ViewPainter::begin(ViewPictures& pictures, const Scene& scene, const PassTarget& target)
{
    if (const auto* volume = std::get_if<VolumeScene>(&scene)) {
        pictures.contour = {};
        return beginVolume(pictures, *volume, target);
    }
    pictures.surface = {};
    pictures.plane = {};
    return beginSlice(pictures, std::get<SliceScene>(scene), target);
}

bool ViewPainter::beginVolume(
    ViewPictures& pictures, const VolumeScene& scene, const PassTarget& target)
{
    pictures.surface.blocks = {};
    if (m_surface.empty() || !scene.surface) {
        pictures.surface = {};
    } else {
        if (!m_surfacePass)
            m_surfacePass.emplace(m_shaders);
        m_surfacePass->draw(pictures.surface, m_surface, m_volume, scene, target);
    }
    if (!scene.plane) {
        pictures.plane = {};
        return !pictures.surface.isEmpty();
    }
    if (!m_planePass)
        m_planePass.emplace();
    m_planePass->begin(
        pictures.plane, contours(scene.plane->contour.has_value()), m_surface, scene, target);
    return !pictures.surface.isEmpty() || !pictures.plane.contour.isEmpty();
}

bool ViewPainter::beginSlice(
    ViewPictures& pictures, const SliceScene& scene, const PassTarget& target)
{
    pictures.contour.reach = {};
    ContourPass* pass = contours(scene.contour.has_value());
    if (!pass) {
        pictures.contour = {};
        return false;
    }
    pass->draw(pictures.contour, m_surface, SeenPlane::of(scene, target.frameSize), *scene.contour,
        target);
    return !pictures.contour.isEmpty();
}

void ViewPainter::draw(ViewPictures& pictures, const FrameRequest& request,
    const PassTarget& target, const Tile& tile, const Framebuffer& into, bool add)
{
    m_palette.set(request.segments);
    const auto* volume = std::get_if<VolumeScene>(&request.scene);
    const ChunkTextures* bodies =
        volume && m_chunks.update(volume->chunks.get(), ChunkTextures::Drawn::Bodies) ? &m_chunks
                                                                                      : nullptr;
    if (volume && !pictures.plane.isEmpty())
        m_planePass->draw(pictures.plane, m_slice, m_volume, *volume, request.segments, m_palette,
            target, tile, m_noVertices, bodies);
    into.bind();
    if (add) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
    } else {
        glDisable(GL_BLEND);
    }
    if (volume) {
        m_raycast.draw(m_volume, *volume, m_palette, target, tile, m_noVertices,
            {.surface = pictures.surface.isEmpty() ? nullptr : &pictures.surface,
                .plane = pictures.plane.isEmpty() ? nullptr : &pictures.plane},
            bodies);
        glDisable(GL_BLEND);
        return;
    }
    const auto& slice = std::get<SliceScene>(request.scene);
    m_slice.prepare(m_volume, slice, request.segments, m_palette, target,
        m_chunks.update(slice.chunks.get(), ChunkTextures::Drawn::Areas) ? &m_chunks : nullptr);
    glEnable(GL_SCISSOR_TEST);
    glScissor(tile.minimum.x, tile.minimum.y, tile.size.x, tile.size.y);
    m_noVertices.drawFullScreenTriangle();
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    if (!pictures.contour.isEmpty())
        m_contourPass->lay(pictures.contour, *slice.contour, tile, m_noVertices);
}

void ViewPainter::warmUp(const VolumeScene& scene, const glm::ivec2& frameSize)
{
    m_raycast.warmUp(m_volume, scene, m_palette, PassTarget{.frameSize = frameSize}, m_noVertices);
}

} // namespace gpu
