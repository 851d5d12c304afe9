// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/cut/LabelMembers.h"

#include <vector>

namespace core {

/// Finds the members that are nearer to the roots than to a sketch, in steps over members
/// (GrowthCut.h, rule 9). Both spread at once, ring by ring; a member that both reach in the same
/// ring belongs to the sketch.
class NearerMembers {
public:
    /// @param sketch members of which none is a root
    NearerMembers(const LabelMembers& members, const std::vector<WordBricks::Voxel>& sketch);

    [[nodiscard]] bool nearerToRoots(WordBricks::Voxel voxel) const
    {
        return m_whose[voxel] == roots;
    }

private:
    static constexpr std::uint8_t nobody = 0;
    static constexpr std::uint8_t sketched = 1;
    static constexpr std::uint8_t roots = 2;

    std::vector<std::uint8_t> m_whose; ///< of each voxel
};

} // namespace core
