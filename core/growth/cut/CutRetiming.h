// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/cut/LabelMembers.h"

#include <functional>
#include <utility>
#include <vector>

namespace core {

/// New generations for the members behind a cut that stay in the growth (GrowthCut.h, rule 10).
struct CutRetiming {
    std::vector<std::pair<WordBricks::Voxel, std::uint32_t>> words; ///< the words that change
    std::vector<WordBricks::Voxel> lost; ///< members for which there is no generation
};

/// @param staying the members behind the cut that stay, each once; none is a root
/// @param leaves whether a member leaves the growth
[[nodiscard]] CutRetiming retime(const LabelMembers& members,
    const std::vector<WordBricks::Voxel>& staying,
    const std::function<bool(WordBricks::Voxel)>& leaves);

} // namespace core
