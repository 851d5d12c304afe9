// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/WordBricks.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// The suspended voxels of a growth (seed A §5.3): voxels that its members touch and that only the
/// interval keeps out. Seed words have no room for this state, so these voxels are kept in a list
/// sorted by code: those that another interval lets in are one contiguous piece of it on either
/// side of the present interval. The list also contains voxels that the interval admits but that
/// the growth has not reached because it stopped early.
class SuspendedSeeds {
public:
    using Voxel = WordBricks::Voxel;

    SuspendedSeeds() = default;
    /// @param voxels each once
    /// @param codes one for each voxel
    SuspendedSeeds(std::span<const Voxel> voxels, std::span<const std::uint16_t> codes);

    [[nodiscard]] std::size_t count() const { return m_voxels.size(); }
    /// The voxels with codes from @p low to @p high, both included. The cost does not depend on the
    /// length of the list.
    [[nodiscard]] std::span<const Voxel> within(int low, int high) const;

private:
    std::vector<Voxel> m_voxels; ///< in ascending order of their codes
    /// For each code, the index of the first voxel with this or a greater code.
    std::vector<std::uint32_t> m_first;
};

} // namespace core
