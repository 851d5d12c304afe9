// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SurfaceUpdate.h"

#include <mutex>
#include <optional>

namespace gpu {

/// Adds a later update to one that nobody has taken in yet: what both tell of is as the later one
/// has it. Linear in both.
void mergeUpdate(core::SurfaceUpdate& pending, core::SurfaceUpdate later);

/// Where updates of the surface wait for the engine's thread, as one. Any thread; the lock is held
/// for a merge at most, so it never waits for a picture.
class SurfaceInbox {
public:
    void put(core::SurfaceUpdate update);
    /// What came since it was last asked; none: nothing.
    [[nodiscard]] std::optional<core::SurfaceUpdate> take();

private:
    std::mutex m_mutex;
    std::optional<core::SurfaceUpdate> m_pending; ///< guarded
};

} // namespace gpu
