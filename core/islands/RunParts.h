// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/ParallelFor.h"
#include "core/base/Progress.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// The runs of voxels in the rows of a box, joined to connected parts. Use: find(), or beginRow()
/// and add() for all rows and endRows(); then join(); then ask. Memory ∝ the runs. Where the box
/// has several slices, not within a parallelFor().
class RunParts {
public:
    /// Consecutive voxels of one row: columns [begin, end).
    struct Run {
        int begin = 0;
        int end = 0;
    };

    /// @param touch by how many columns runs of neighbouring rows may miss each other and still be
    /// connected: 1 for 26 neighbours, 0 for 6
    RunParts(const glm::ivec3& size, int touch);

    /// Finds the runs of all rows, in parallel slice by slice.
    /// @param runsOfRow called as runsOfRow(y, z, add) for each row, which is to call
    /// add(begin, end) for each of its runs, ascending
    /// @return false: cancelled
    template <class RunsOfRow> bool find(const Progress& progress, const RunsOfRow& runsOfRow)
    {
        std::vector<std::vector<Run>> slices(std::size_t(m_size.z));
        parallelFor(m_size.z, [&](int z) {
            if (progress.cancelled())
                return;
            std::vector<Run>& runs = slices[std::size_t(z)];
            for (int y = 0; y < m_size.y; ++y) {
                m_firstOfRow[rowAt(y, z)] = runs.size(); // of the slice, for the moment
                runsOfRow(y, z, [&runs](int begin, int end) { runs.push_back({begin, end}); });
            }
        });
        if (progress.cancelled())
            return false;
        gather(slices);
        return true;
    }
    /// Begins the next row. All rows must be begun in the order of memory, also those without runs.
    void beginRow(std::size_t row) { m_firstOfRow[row] = m_runs.size(); }
    void add(int begin, int end);
    void endRows() { m_firstOfRow.back() = m_runs.size(); }

    /// Joins connected runs of neighbouring rows, in parallel.
    /// @return false: cancelled
    bool join(const Progress& progress);

    [[nodiscard]] std::size_t count() const { return m_runs.size(); }
    [[nodiscard]] const Run& run(std::size_t at) const { return m_runs[at]; }
    /// The part that a run belongs to, named by the index of the part's first run in memory.
    [[nodiscard]] std::uint32_t partOf(std::size_t run);
    /// The part that contains a voxel; none if it is in no run.
    [[nodiscard]] std::optional<std::uint32_t> partAt(const glm::ivec3& voxel);

    /// Calls @p visit(index of the run, y, z) for all runs in the order of memory.
    template <class Visit> void forEach(const Visit& visit)
    {
        for (int z = 0; z < m_size.z; ++z) {
            for (int y = 0; y < m_size.y; ++y) {
                const std::size_t row = rowAt(y, z);
                for (std::size_t at = m_firstOfRow[row]; at < m_firstOfRow[row + 1]; ++at)
                    visit(at, y, z);
            }
        }
    }

private:
    [[nodiscard]] std::size_t rowAt(int y, int z) const
    {
        return std::size_t(z) * std::size_t(m_size.y) + std::size_t(y);
    }
    /// Puts the runs of the slices one behind the other, and empties @p slices.
    void gather(std::vector<std::vector<Run>>& slices);
    /// Joins the rows of a slice with each other, or with those of the slice before.
    void joinWithin(int z);
    void joinWithBefore(int z);
    void joinRows(std::size_t row, std::size_t other);
    void joinRuns(std::size_t one, std::size_t two);

    glm::ivec3 m_size;
    int m_touch;
    /// For each row, the index of its first run; at the end, the number of runs.
    std::vector<std::size_t> m_firstOfRow;
    std::vector<Run> m_runs;
    std::vector<std::uint32_t> m_parent;
};

} // namespace core
