// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace core {

/// How likely each voxel of a volume belongs to one structure, as computed by a network or another
/// program: one byte per voxel, x fastest, from 0 (certainly not) to 255 (certainly). Seed B,
/// section 4: chunks are "regions of different likelihood to be part of the final segmentation".
class ProbabilityMap {
public:
    static constexpr int certain = 255;
    /// The lowest byte that counts as belonging to the structure, that is a probability of at least
    /// one half.
    static constexpr int half = 128;

    /// The byte for a probability. Values outside 0 … 1 are clamped; not-a-number becomes 0.
    [[nodiscard]] static std::uint8_t byteOf(double probability);

    /// Compresses a map (zstd), as an edit stores it. Cost: one pass; most maps shrink to a
    /// hundredth.
    [[nodiscard]] static QByteArray packed(std::span<const std::uint8_t> probabilities);
    /// Whether the header of a compressed map states this number of voxels; the data behind it may
    /// still be damaged. Cost: none.
    [[nodiscard]] static bool isOf(const QByteArray& bytes, std::uint64_t voxels);
    /// Decompresses a map. None if it is damaged or has another number of voxels. It never
    /// allocates more than this number of bytes.
    [[nodiscard]] static std::optional<std::vector<std::uint8_t>> unpacked(
        const QByteArray& bytes, std::uint64_t voxels);
};

} // namespace core
