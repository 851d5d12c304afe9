// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/Tolerance.h"
#include "gpu/gl/Texture3D.h"

#include <array>
#include <cstdint>
#include <vector>

namespace gpu {

/// The tolerance field (core/growth/Tolerance.h): for each voxel the least tolerance at which
/// growth would reach it. 2 bytes per voxel of whole bricks, allocated only while such a field is
/// in use. Engine thread only.
struct ToleranceField {
    /// R16UI; a value above ToleranceRule::greatest: never reached
    Texture3D tolerances;
    core::ToleranceRule rule;
    core::ToleranceCurve curve;
    /// For each brick: least | greatest << 16; a least of 0xFFFF means none.
    std::vector<std::uint32_t> ranges;
    /// A digest of the seeds and walls from which it was computed: if another look finds the same
    /// digest, the content is still valid.
    std::array<std::uint32_t, 2> digest{};
    bool worked = false; ///< the computation is complete
    bool stands = false; ///< complete, and nothing has changed since: it may be reported and shown

    [[nodiscard]] std::size_t bytes() const { return tolerances ? tolerances.bytes() : 0; }
};

} // namespace gpu
