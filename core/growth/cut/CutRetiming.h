// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/cut/LabelMembers.h"

#include <functional>
#include <utility>
#include <vector>

namespace core {

/// What members become that lie behind a cut and stay (GrowthCut.h, rule 10).
struct CutRetiming {
    std::vector<std::pair<WordBricks::Voxel, std::uint32_t>> words; ///< those that change
    std::vector<WordBricks::Voxel> lost; ///< without a generation that they could have
};

/// @param staying no roots; each once
/// @param leaves of any member
[[nodiscard]] CutRetiming retime(const LabelMembers& members,
    const std::vector<WordBricks::Voxel>& staying,
    const std::function<bool(WordBricks::Voxel)>& leaves);

} // namespace core
