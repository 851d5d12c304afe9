// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// Voxels of a grid, by their places x fastest, then y, then z.
struct VoxelRun {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
    bool operator==(const VoxelRun&) const = default;
};

/// A set of voxels as runs: ascending, apart from each other, none empty.
class VoxelRuns {
public:
    /// Joins what touches. @pre @p first is not before the end of the last run
    void append(std::uint64_t first, std::uint64_t count);
    void append(const VoxelRuns& behind);

    [[nodiscard]] const std::vector<VoxelRun>& runs() const { return m_runs; }
    [[nodiscard]] bool empty() const { return m_runs.empty(); }
    [[nodiscard]] std::uint64_t voxelCount() const;
    /// One past the last voxel; 0: there is none.
    [[nodiscard]] std::uint64_t end() const;
    bool operator==(const VoxelRuns&) const = default;

private:
    std::vector<VoxelRun> m_runs;
};

[[nodiscard]] VoxelRuns united(const VoxelRuns& one, const VoxelRuns& other);
/// How many voxels are in both.
[[nodiscard]] std::uint64_t sharedVoxels(const VoxelRuns& one, const VoxelRuns& other);

// Packed: zstd over two numbers a run, how many voxels are left out before it and how many it has,
// each in base 128, low digits first, with bit 7 of a byte set where another digit follows.

/// Empty where it would take more than mostPackedRunBytes, unpacked.
[[nodiscard]] QByteArray packedRuns(const VoxelRuns& runs);
/// None if the bytes are not what packedRuns() makes, or a voxel lies at @p voxels or beyond.
[[nodiscard]] std::optional<VoxelRuns> unpackedRuns(const QByteArray& bytes, std::uint64_t voxels);

/// Some thirty million runs.
constexpr qsizetype mostPackedRunBytes = qsizetype(1) << 26;

} // namespace core
