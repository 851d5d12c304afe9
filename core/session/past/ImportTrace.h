// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/history/History.h"

#include <QByteArray>

#include <glm/glm.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace core {

/// Where imports of masks have voxels, which is where they read labels (RowTrace::importedTo). A
/// row holds them packed, and there may be millions of runs: they are noted on the session's thread
/// and unpacked on another.
class ImportTrace {
public:
    /// Keeps what a row imported; a row with any other edit is not noted. Cheap: packed voxels are
    /// shared.
    void note(RowId row, const Edit& edit);
    /// Whether none was noted.
    [[nodiscard]] bool empty() const { return m_packed.empty() && m_bricks.empty(); }
    /// Unpacks what was noted. Cost: that of all its runs; it checks @p progress before each
    /// segment, and stops if that was cancelled. Any thread that may work on voxels.
    /// @param size of the volume
    void workOut(const glm::ivec3& size, const Progress& progress);

    /// None: that row was not noted, or not unpacked yet. Voxels that are damaged are in no brick.
    [[nodiscard]] std::optional<std::set<std::uint32_t>> bricksOf(RowId row) const;

private:
    std::map<RowId, std::vector<QByteArray>> m_packed; ///< until they are unpacked
    std::map<RowId, std::set<std::uint32_t>> m_bricks;
};

} // namespace core
