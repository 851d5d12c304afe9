// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace peer {

// How the peers of the field keep an undo step of a label image, as small as their form allows: no
// headers, no padding, no slack of containers.

/// The whole image, each row of voxels as runs (length 16 bits, value 8 bits) behind one another:
/// the in-memory form of ITK-SNAP's segmentations.
class RunLengthImage {
public:
    RunLengthImage(std::span<const std::uint8_t> voxels, std::size_t rowLength);

    [[nodiscard]] std::size_t bytes() const { return m_runs.size() * 3; }
    void decode(std::span<std::uint8_t> voxels) const;

private:
    struct Run {
        std::uint16_t length;
        std::uint8_t value;
    };
    std::vector<Run> m_runs;
};

/// The difference of two images as runs (length 32 bits, value 8 bits) over the whole image: what
/// ITK-SNAP keeps per undo step. It has to look at every voxel of both.
class RunLengthDifference {
public:
    RunLengthDifference(std::span<const std::uint8_t> before, std::span<const std::uint8_t> after);

    [[nodiscard]] std::size_t bytes() const { return m_runs.size() * 5; }
    /// Back from after to before, or forth.
    void apply(std::span<std::uint8_t> voxels) const;

private:
    struct Run {
        std::uint32_t length;
        std::uint8_t value;
    };
    std::vector<Run> m_runs;
};

} // namespace peer
