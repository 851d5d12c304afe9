// SPDX-License-Identifier: Apache-2.0
#include "tests/support/FakeFrames.h"

#include <cmath>
#include <utility>

namespace test {

namespace {

struct Plane {
    glm::dvec3 centre;
    glm::dvec3 right;
    glm::dvec3 down;
    double mmPerPixel;
};

Plane planeOf(const gpu::FrameRequest& request)
{
    if (const auto* slice = std::get_if<gpu::SliceScene>(&request.scene))
        return {slice->centreLps, slice->rightLps, slice->downLps, slice->mmPerPixel};
    const auto& volume = std::get<gpu::VolumeScene>(request.scene);
    const glm::dvec3 forward = glm::normalize(volume.targetLps - volume.eyeLps);
    const glm::dvec3 right = glm::cross(forward, volume.up);
    return {volume.targetLps, right, -volume.up, volume.heightMm / request.sizePixels.y};
}

} // namespace

glm::ivec3 FakeFrames::colourAt(const glm::dvec3& lps)
{
    return glm::clamp(glm::ivec3(glm::round(lps)) + 128, glm::ivec3(0), glm::ivec3(255));
}

void FakeFrames::request(gpu::FrameRequest request)
{
    ++m_requestCount;
    m_requests[request.view] = request;
    deliver(request, gpu::Frame::Quality::Coarse);
    if (!request.interacting)
        deliver(request, gpu::Frame::Quality::Refined);
}

void FakeFrames::forget(gpu::ViewId view)
{
    m_requests.erase(view);
}

void FakeFrames::setListener(Listener listener)
{
    m_listener = std::move(listener);
}

void FakeFrames::updateSurface(core::SurfaceUpdate update)
{
    m_surfaceUpdates.push_back(std::move(update));
}

const gpu::FrameRequest& FakeFrames::lastRequest(gpu::ViewId view) const
{
    return m_requests.at(view);
}

void FakeFrames::deliver(const gpu::FrameRequest& request, gpu::Frame::Quality quality) const
{
    if (!m_listener)
        return;
    const Plane plane = planeOf(request);
    const glm::ivec2 size = request.sizePixels;
    std::vector<std::uint8_t> bytes(std::size_t(size.x) * std::size_t(size.y) * 4, 255);
    std::uint8_t* next = bytes.data();
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const glm::dvec2 mm =
                (glm::dvec2(x + 0.5, y + 0.5) - glm::dvec2(size) / 2.0) * plane.mmPerPixel;
            const glm::ivec3 colour =
                colourAt(plane.centre + plane.right * mm.x + plane.down * mm.y);
            for (int channel = 0; channel < 3; ++channel)
                next[channel] = std::uint8_t(colour[channel]);
            next += 4;
        }
    }
    gpu::Frame frame;
    frame.view = request.view;
    frame.sizePixels = size;
    frame.rgba = std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes));
    frame.quality = quality;
    frame.renderMilliseconds = 1.0;
    frame.scene = request.scene;
    m_listener(frame);
}

} // namespace test
