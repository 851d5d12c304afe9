// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/Tolerance.h"
#include "gpu/gl/Texture3D.h"

#include <array>
#include <cstdint>
#include <vector>

namespace gpu {

/// What tracing works out (core/growth/Tolerance.h): 2 bytes a voxel of whole bricks, only while a
/// field is asked for. Engine thread only.
struct ToleranceField {
    Texture3D tolerances; ///< R16UI; above ToleranceRule::greatest: none
    core::ToleranceRule rule;
    core::ToleranceCurve curve;
    std::vector<std::uint32_t> ranges; ///< of each brick: least | greatest << 16; none: 0xFFFF
    /// What seeds and walls it came of, as one number: where another look finds the same, what it
    /// holds is still true.
    std::array<std::uint32_t, 2> digest{};
    bool worked = false; ///< all of it is worked out
    bool stands = false; ///< and nothing has changed since: it may be told and shown

    [[nodiscard]] std::size_t bytes() const { return tolerances ? tolerances.bytes() : 0; }
};

} // namespace gpu
