// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SurfaceUpdate.h"

#include <mutex>
#include <optional>

namespace gpu {

/// Merges a later update into one that was not taken yet. What both contain is taken from the later
/// one. Linear in both.
void mergeUpdate(core::SurfaceUpdate& pending, core::SurfaceUpdate later);

/// Where updates of the surface wait for the engine thread, merged into one. Any thread. The lock
/// is held at most for a merge, so callers never wait for a picture.
class SurfaceInbox {
public:
    void put(core::SurfaceUpdate update);
    /// The update that arrived since the last call; none if there was none.
    [[nodiscard]] std::optional<core::SurfaceUpdate> take();

private:
    std::mutex m_mutex;
    std::optional<core::SurfaceUpdate> m_pending; ///< guarded by m_mutex
};

} // namespace gpu
