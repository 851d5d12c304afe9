// SPDX-License-Identifier: Apache-2.0
#include "ui/views/FrameInbox.h"

#include <utility>

namespace ui {

FrameInbox::FrameInbox(gpu::FrameSource& source, QObject* parent)
    : QObject(parent)
    , m_source(source)
{
    m_source.setListener([this](const gpu::Frame& frame) { put(frame); });
}

FrameInbox::~FrameInbox()
{
    m_source.setListener({});
}

void FrameInbox::drop()
{
    const std::lock_guard lock(m_mutex);
    m_waiting.clear();
}

void FrameInbox::put(const gpu::Frame& frame)
{
    bool first = false;
    {
        const std::lock_guard lock(m_mutex);
        first = m_waiting.empty();
        m_waiting[frame.view] = frame;
    }
    if (first)
        QMetaObject::invokeMethod(
            this, [this] { deliver(); }, Qt::QueuedConnection);
}

void FrameInbox::deliver()
{
    std::map<gpu::ViewId, gpu::Frame> frames;
    {
        const std::lock_guard lock(m_mutex);
        frames.swap(m_waiting);
    }
    for (const auto& [view, frame] : frames)
        Q_EMIT arrived(frame);
}

} // namespace ui
