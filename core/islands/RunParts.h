// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// The runs of voxels in the rows of a box, and which of them hang together. Memory ∝ the runs.
class RunParts {
public:
    /// Voxels of one row that hang together: columns [begin, end).
    struct Run {
        int begin = 0;
        int end = 0;
    };

    /// @param touch by how many columns runs of neighbouring rows may miss each other and still
    /// touch: 1 with 26 neighbours, 0 with 6
    RunParts(const glm::ivec3& size, int touch);

    /// Rows in the order of memory, all of them, also those without runs.
    void beginRow(std::size_t row) { m_firstOfRow[row] = m_runs.size(); }
    void add(int begin, int end);
    void endRows() { m_firstOfRow.back() = m_runs.size(); }

    /// Joins the runs of each row with those of its neighbours before it.
    /// @return false: cancelled
    bool join(const Progress& progress);

    [[nodiscard]] std::size_t count() const { return m_runs.size(); }
    [[nodiscard]] const Run& run(std::size_t at) const { return m_runs[at]; }
    /// The part of a run: the number of its first run in memory.
    [[nodiscard]] std::uint32_t partOf(std::size_t run);
    /// The part that holds a voxel; none if no run does.
    [[nodiscard]] std::optional<std::uint32_t> partAt(const glm::ivec3& voxel);

    /// Calls @p visit(run, y, z) for all of them in the order of memory.
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
    void joinRows(std::size_t row, std::size_t other);
    void joinRuns(std::size_t one, std::size_t two);

    glm::ivec3 m_size;
    int m_touch;
    std::vector<std::size_t> m_firstOfRow; ///< and the end of the last one
    std::vector<Run> m_runs;
    std::vector<std::uint32_t> m_parent;
};

} // namespace core
