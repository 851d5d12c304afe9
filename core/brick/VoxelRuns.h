// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// Consecutive voxels of a grid, numbered x fastest, then y, then z.
struct VoxelRun {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
    bool operator==(const VoxelRun&) const = default;
};

/// A set of voxels as runs that are ascending, not adjacent and not empty.
class VoxelRuns {
public:
    /// Adds a run, joined with the last one if they touch. @pre @p first is not before the end of
    /// the last run
    void append(std::uint64_t first, std::uint64_t count);
    void append(const VoxelRuns& behind);

    [[nodiscard]] const std::vector<VoxelRun>& runs() const { return m_runs; }
    [[nodiscard]] bool empty() const { return m_runs.empty(); }
    [[nodiscard]] std::uint64_t voxelCount() const;
    /// One past the last voxel; 0 if there is none.
    [[nodiscard]] std::uint64_t end() const;
    bool operator==(const VoxelRuns&) const = default;

private:
    std::vector<VoxelRun> m_runs;
};

[[nodiscard]] VoxelRuns united(const VoxelRuns& one, const VoxelRuns& other);
/// Number of voxels that are in both.
[[nodiscard]] std::uint64_t sharedVoxels(const VoxelRuns& one, const VoxelRuns& other);

// Packed form: zstd over two numbers for each run, the number of voxels before it that are left out
// and the number of its voxels. Each is in base 128, low digits first; bit 7 of a byte is set if
// another digit follows.

/// Empty if the unpacked form would exceed mostPackedRunBytes.
[[nodiscard]] QByteArray packedRuns(const VoxelRuns& runs);
/// Counts as reading voxels (ThreadWithoutVoxels.h): a mask may have millions of runs.
/// None if packedRuns() cannot have made the bytes, or if a voxel lies at @p voxels or beyond.
[[nodiscard]] std::optional<VoxelRuns> unpackedRuns(const QByteArray& bytes, std::uint64_t voxels);

/// About thirty million runs.
constexpr qsizetype mostPackedRunBytes = qsizetype(1) << 26;

} // namespace core
