// SPDX-License-Identifier: Apache-2.0
#include "gpu/frame/FrameDelivery.h"

#include "gpu/fields/textures/VolumeTextures.h"
#include "gpu/gl/GlFailure.h"

#include <cstring>
#include <memory>
#include <utility>
#include <vector>

namespace gpu {

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
        const auto view = views.find(it->first);
        it = m_sent.erase(it);
        if (view == views.end())
            continue;
        const Buffer& home = view->second.targets.home;
        std::vector<std::uint8_t> bytes(home.bytes());
        std::memcpy(bytes.data(), home.mapped(), bytes.size());
        frame.rgba = std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes));
        ++handed;
        m_mail.hand(frame);
    }
    return handed;
}

} // namespace gpu
