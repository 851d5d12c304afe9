// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// Chunks of the newest division become a segment's, or are taken from it.
struct ChunkToggle {
    enum class Mode {
        Toggle, ///< one that the segment has more than half of goes, any other one comes
        Add,
        Remove,
    };
    int segment = 0; ///< label
    int chunks = 0; ///< into how many the whole is divided
    Mode mode = Mode::Toggle;
    std::vector<glm::dvec3> pointsLps{}; ///< each stands for the chunk that it lies in
    bool overwriteUnlocked = false;
    /// That the chunks lie in, ascending: whoever carries it out adds them, for reach().
    std::optional<std::vector<std::int64_t>> bricks{};
};

[[nodiscard]] Result<void> check(const ChunkToggle& edit, const Document& document);
Result<bool> apply(const ChunkToggle& edit, Document& document);
[[nodiscard]] EditEffects effects(const ChunkToggle& edit);
[[nodiscard]] RowTitle rowTitle(const ChunkToggle& edit, const RowFacts& row);
[[nodiscard]] EditReach reach(const ChunkToggle& edit, const ReachFacts& row);

} // namespace core
