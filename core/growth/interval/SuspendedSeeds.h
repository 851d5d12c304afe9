// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/WordBricks.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// The suspended voxels of a growth (seed A §5.3): those that its members touch and that only the
/// interval keeps out. The seed word of such a voxel has no room to say so, so they are listed
/// beside it, by value: what another interval lets in is one piece of the list on either side of
/// the present interval. A voxel that the interval admits and that was not reached yet, because the
/// growth stopped early, is listed too.
class SuspendedSeeds {
public:
    using Voxel = WordBricks::Voxel;

    SuspendedSeeds() = default;
    /// @param voxels each once
    /// @param codes one for each voxel
    SuspendedSeeds(std::span<const Voxel> voxels, std::span<const std::uint16_t> codes);

    [[nodiscard]] std::size_t count() const { return m_voxels.size(); }
    /// Those with a code from @p low to @p high, both included; at no cost that grows with the
    /// list.
    [[nodiscard]] std::span<const Voxel> within(int low, int high) const;

private:
    std::vector<Voxel> m_voxels; ///< by code
    std::vector<std::uint32_t> m_first; ///< by code: the place of the first with that or a greater
};

} // namespace core
