// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// The box of voxels that is to be divided, x fastest.
struct ChunkSource {
    /// Owner of voxels that are not divided.
    static constexpr std::uint8_t outside = 255;

    glm::ivec3 size{0};
    std::span<const std::uint16_t> codes;
    /// The segment's label; 0: no segment; `outside`: left out. A chunk never contains voxels of
    /// two owners.
    std::span<const std::uint8_t> owners;
    /// How likely each voxel belongs to `likely`, 0 … 255, from a probability map
    /// (ProbabilityMap.h). Empty: the likelihood is computed from the codes.
    std::span<const std::uint8_t> probabilities{};
    std::uint8_t likely = 0; ///< the owner that the probabilities are of
};

/// How strongly each voxel is connected with its owner, by multi-object fuzzy connectedness (seed
/// B, section 4; Udupa and Saha; Carvalho et al. for several objects). All numbers are integers, so
/// that chunks are the same on every machine.
///
/// 1. The step between two neighbours (six) is the greater of their difference and the difference
///    of both together from the owner's mean, in units of mean deviations: `deviation` stands for
///    one of them, and values above `most` are clamped.
/// 2. The core of an owner is the set of its deepest voxels: those at least three quarters as deep
///    as the deepest one, where depth is the number of steps to another owner.
/// 3. The cost of a voxel for an owner is the least possible greatest step of a path from that
///    owner's core.
/// 4. The likelihood of a voxel is the least cost for any other owner minus that for its own owner:
///    from −most (it looks as if it belonged to another) to most.
///
/// With a probability map the likelihood comes from the map instead, on the same scale: 2 · p −
/// most where the voxel has the owner that the map is of, and most − 2 · p elsewhere.
class ChunkField {
public:
    static constexpr int deviation = 64;
    static constexpr int most = 255;

    /// Computes it, on all cores. Cost: one pass through the box for each owner; with a probability
    /// map one pass. Errors: Cancelled.
    [[nodiscard]] static Result<ChunkField> of(const ChunkSource& source, const Progress& progress);

    /// The likelihood of each voxel of the box; 0 for voxels that are left out.
    [[nodiscard]] std::span<const std::int16_t> likelihoods() const { return m_likelihoods; }
    /// The greatest difference of two codes that is at most this much in units of mean deviations.
    [[nodiscard]] int codesWithin(int deviations) const;
    /// The difference of codes that is one mean deviation between neighbours of one owner; at least
    /// 1.
    [[nodiscard]] int noise() const { return m_noise; }

private:
    std::vector<std::int16_t> m_likelihoods;
    int m_noise = 1;
};

} // namespace core
