// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace core {

/// How likely each voxel of a volume belongs to one structure, as a network or another program has
/// worked it out: one byte a voxel, x fastest, 0 (certainly not) … 255 (certainly). Seed B,
/// section 4: chunks are "regions of different likelihood to be part of the final segmentation".
class ProbabilityMap {
public:
    static constexpr int certain = 255;
    /// The least byte that counts as belonging to the structure: at least one half.
    static constexpr int half = 128;

    /// The byte of a probability from 0 to 1; what lies outside is clamped, and what is no number
    /// is 0.
    [[nodiscard]] static std::uint8_t byteOf(double probability);

    /// As an edit stores it. Cost: one pass; most maps shrink to a hundredth.
    [[nodiscard]] static QByteArray packed(std::span<const std::uint8_t> probabilities);
    /// Whether the bytes say that they are of so many voxels; what follows may be damaged. No cost.
    [[nodiscard]] static bool isOf(const QByteArray& bytes, std::uint64_t voxels);
    /// None: damaged, or of another number of voxels. Nothing larger than that is ever allocated.
    [[nodiscard]] static std::optional<std::vector<std::uint8_t>> unpacked(
        const QByteArray& bytes, std::uint64_t voxels);
};

} // namespace core
