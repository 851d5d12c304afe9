// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/LastingFrames.h"

#include <utility>

namespace gpu {

void LastingFrames::setSource(FrameSource* source)
{
    const std::lock_guard lock(m_mutex);
    if (m_source)
        m_source->setListener({});
    m_source = source;
    if (m_source)
        m_source->setListener(m_listener);
}

void LastingFrames::request(FrameRequest request)
{
    const std::lock_guard lock(m_mutex);
    if (m_source)
        m_source->request(std::move(request));
}

void LastingFrames::forget(ViewId view)
{
    const std::lock_guard lock(m_mutex);
    if (m_source)
        m_source->forget(view);
}

void LastingFrames::setListener(Listener listener)
{
    const std::lock_guard lock(m_mutex);
    m_listener = std::move(listener);
    if (m_source)
        m_source->setListener(m_listener);
}

void LastingFrames::updateSurface(core::SurfaceUpdate update)
{
    const std::lock_guard lock(m_mutex);
    if (m_source)
        m_source->updateSurface(std::move(update));
}

} // namespace gpu
