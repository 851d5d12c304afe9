// SPDX-License-Identifier: Apache-2.0
#include "gpu/frame/FrameDelivery.h"

#include "gpu/fields/textures/VolumeTextures.h"
#include "gpu/gl/GlFailure.h"

#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gpu {

namespace {

core::TraceName pictureName(Frame::Quality quality)
{
    switch (quality) {
    case Frame::Quality::Coarse:
        return "coarse picture";
    case Frame::Quality::Full:
        return "full picture";
    case Frame::Quality::Refined:
        return "refined picture";
    }
    return {};
}

} // namespace

FrameDelivery::FrameDelivery(VolumeTextures& volume, FrameMail& mail)
    : m_volume(volume)
    , m_mail(mail)
{
}

void FrameDelivery::send(ViewProgress& view, Frame::Quality quality)
{
    view.targets.pictureFrame.readInto(view.targets.home.id());
    Sent sent;
    sent.frame = Frame{
        .view = view.request.view,
        .sizePixels = view.targets.size,
        .rgba = nullptr,
        .quality = quality,
        .renderMilliseconds = view.milliseconds,
        .pieces = {},
        .scene = view.request.scene,
    };
    if (const auto* scene = std::get_if<VolumeScene>(&view.request.scene)) {
        for (const ScenePiece& piece : scene->pieces) {
            const auto* entry = m_volume.pieces().entry({piece.layer, piece.segment});
            if (piece.id != 0 && entry && !entry->filled.empty())
                sent.frame.pieces.push_back({.id = piece.id, .filled = entry->filled});
        }
    }
    sent.fence = Fence::insert();
    sent.begun = std::exchange(view.begun, std::nullopt).value_or(core::Trace::Clock::now());
    if (core::Trace::isOn() && !view.lane)
        view.lane.emplace("view " + std::to_string(view.request.view));
    m_sent.insert_or_assign(view.request.view, std::move(sent));
}

void FrameDelivery::await(ViewId view)
{
    if (const auto sent = m_sent.find(view); sent != m_sent.end())
        sent->second.fence.wait();
}

void FrameDelivery::awaitFirst()
{
    if (!m_sent.empty())
        m_sent.begin()->second.fence.wait();
}

int FrameDelivery::deliver(const std::map<ViewId, ViewProgress>& views)
{
    int handed = 0;
    for (auto it = m_sent.begin(); it != m_sent.end();) {
        if (!it->second.fence.passed()) {
            ++it;
            continue;
        }
        requireContext(); // else what lies there is no picture
        Frame frame = std::move(it->second.frame);
        const core::Trace::Clock::time_point begun = it->second.begun;
        const auto view = views.find(it->first);
        it = m_sent.erase(it);
        if (view == views.end())
            continue;
        const Buffer& home = view->second.targets.home;
        std::vector<std::uint8_t> bytes(home.bytes());
        std::memcpy(bytes.data(), home.mapped(), bytes.size());
        frame.rgba = std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes));
        ++handed;
        if (view->second.lane)
            core::Trace::add({.category = "frame",
                .name = pictureName(frame.quality),
                .lane = view->second.lane->id(),
                .begin = begun,
                .end = core::Trace::Clock::now()});
        m_mail.hand(frame);
    }
    return handed;
}

} // namespace gpu
