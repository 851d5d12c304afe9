// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// A box of voxels that is to be divided, x fastest.
struct ChunkSource {
    /// What a voxel belongs to that nobody divides.
    static constexpr std::uint8_t outside = 255;

    glm::ivec3 size{0};
    std::span<const std::uint16_t> codes;
    /// 0: to no segment, else the segment's label; `outside`: it is left out. No chunk holds voxels
    /// of two of these.
    std::span<const std::uint8_t> owners;
};

/// How strongly voxels hang together with what owns them, by multi-object fuzzy connectedness
/// (seed B, section 4; Udupa and Saha; Carvalho et al. for many objects). In whole numbers, so that
/// chunks are the same everywhere.
///
/// 1. A step is what two neighbours (six) differ by, or what both together differ by from the
///    owner's mean, in mean deviations: `deviation` is one of them, more than `most` counts as
///    that.
/// 2. The core of an owner are the deepest voxels of what it owns: those at least three quarters
///    as deep as the deepest, by the number of steps to another owner.
/// 3. A voxel's cost for an owner is the greatest step of the way from that owner's core on which
///    this is least.
/// 4. Its likelihood is the least cost for any other owner less that for its own: from −most
///    (it looks as if it were another's) to most.
class ChunkField {
public:
    static constexpr int deviation = 64;
    static constexpr int most = 255;

    /// Cost: a walk through the box for each owner. Errors: Cancelled.
    [[nodiscard]] static Result<ChunkField> of(const ChunkSource& source, const Progress& progress);

    [[nodiscard]] int likelihood(std::size_t voxel) const { return m_likelihood[voxel]; }
    /// What two neighbours differ by, 0 … most: their codes in mean deviations, or their
    /// likelihood.
    [[nodiscard]] int step(std::size_t voxel, std::size_t neighbour) const;
    /// Codes of this much make one mean deviation between neighbours of one owner; at least 1.
    [[nodiscard]] int noise() const { return m_noise; }

private:
    std::span<const std::uint16_t> m_codes;
    std::vector<std::int16_t> m_likelihood;
    int m_noise = 1;
};

} // namespace core
