// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

namespace core {

/// How much an edit changed.
struct EditStatistics {
    std::int64_t voxelsChanged = 0; ///< values that differ, of coverage and labels
    std::int64_t verticesChanged = 0; ///< of the surface; no engine's
    int bricks = 0; ///< changed, of coverage and labels
    /// Steps a growth advanced (the admission of seeds included), or was taken back.
    int generations = 0;
    double milliseconds = 0.0; ///< engine time; never part of a hash
    /// Of a cut that starts from the surface: how deep the surface was looked for, in mm16 of its
    /// plane (searchEnd() in core/sculpt/MaskFrame.h); none: no ray was cast, or nobody noted it.
    std::optional<std::int32_t> searchedTo{};
    /// Voxels of the segment that a surface lies around were changed; no engine's. Sessions before
    /// 2026-11-25 do not say so.
    bool surfaceMaskChanged = false;
};

} // namespace core
