// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"
#include "tests/reference/fields/DenseFields.h"

#include <optional>
#include <vector>

namespace reference {

/// The leak guard, by the rules in core/growth/LeakGuard.h: every front is kept with its whole
/// trunk.
class FrontWatch {
public:
    FrontWatch(const glm::ivec3& size, const core::GuardRule& rule);

    std::optional<core::LeakAlarm> look(
        std::uint32_t generation, const std::vector<glm::ivec3>& added);

private:
    struct Front {
        std::vector<glm::ivec3> voxels;
        std::vector<std::int64_t> sizes; ///< its own, its trunk's, and so on
        std::vector<std::int64_t> thicknesses; ///< likewise
        glm::ivec3 least{0}; ///< of its voxels, by isLess()
    };

    [[nodiscard]] bool isLess(const glm::ivec3& a, const glm::ivec3& b) const;
    /// Rule 2: what a voxel measures by where the generation before lies.
    [[nodiscard]] std::int64_t areaOf(const glm::ivec3& voxel) const;
    [[nodiscard]] int narrowPlace(const Front& front) const;

    core::GuardRule m_rule;
    core::BrickGrid m_grid;
    DenseArray<int> m_front; ///< of the last two generations: number + 1, negative before
    std::vector<Front> m_before;
};

} // namespace reference
