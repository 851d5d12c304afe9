// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// Add chunks of the newest division to a segment, or remove them from it.
struct ChunkToggle {
    enum class Mode {
        Toggle, ///< removes a chunk of which the segment has more than half, and adds any other
        Add,
        Remove,
    };
    int segment = 0; ///< label
    int chunks = 0; ///< number of chunks into which the whole is divided
    Mode mode = Mode::Toggle;
    std::vector<glm::dvec3> pointsLps{}; ///< each selects the chunk in which it lies
    bool overwriteUnlocked = false;
    /// The bricks in which the chunks lie, ascending. They are added when it is carried out, for
    /// dependencies().
    std::optional<std::vector<std::int64_t>> bricks{};
    /// Which voxels may change; none: any. Whether the segment has more than half of a chunk is
    /// decided for the whole chunk.
    std::optional<EditableRange> editable{};
};

[[nodiscard]] Result<void> check(const ChunkToggle& edit, const Document& document);
Result<bool> apply(const ChunkToggle& edit, Document& document);
[[nodiscard]] EditEffects effects(const ChunkToggle& edit);
[[nodiscard]] RowTitle rowTitle(const ChunkToggle& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const ChunkToggle& edit, const DependencyFacts& row);

} // namespace core
