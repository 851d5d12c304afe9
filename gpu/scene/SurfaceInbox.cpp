// SPDX-License-Identifier: Apache-2.0
#include "gpu/scene/SurfaceInbox.h"

#include <utility>

namespace gpu {

namespace {

/// Both ascend by id.
template <class Part> void mergeParts(std::vector<Part>& parts, std::vector<Part> later)
{
    if (later.empty())
        return;
    if (parts.empty() || parts.back().id < later.front().id) {
        parts.insert(parts.end(), std::make_move_iterator(later.begin()),
            std::make_move_iterator(later.end()));
        return;
    }
    std::vector<Part> merged;
    merged.reserve(parts.size() + later.size());
    auto before = parts.begin();
    for (Part& part : later) {
        for (; before != parts.end() && before->id < part.id; ++before)
            merged.push_back(std::move(*before));
        if (before != parts.end() && before->id == part.id)
            ++before;
        merged.push_back(std::move(part));
    }
    merged.insert(
        merged.end(), std::make_move_iterator(before), std::make_move_iterator(parts.end()));
    parts = std::move(merged);
}

} // namespace

void mergeUpdate(core::SurfaceUpdate& pending, core::SurfaceUpdate later)
{
    if (later.isWhole) {
        pending = std::move(later);
        return;
    }
    mergeParts(pending.vertices, std::move(later.vertices));
    mergeParts(pending.faces, std::move(later.faces));
}

void SurfaceInbox::put(core::SurfaceUpdate update)
{
    const std::lock_guard lock(m_mutex);
    if (m_pending)
        mergeUpdate(*m_pending, std::move(update));
    else
        m_pending = std::move(update);
}

std::optional<core::SurfaceUpdate> SurfaceInbox::take()
{
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_pending, std::nullopt);
}

} // namespace gpu
