// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"
#include "tests/reference/fields/DenseFields.h"

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace reference {

/// The rule of core/growth/Passage.h, as it is written: balls, voxel by voxel.
class Passage {
public:
    Passage(const core::GrowBurst& burst, const glm::ivec3& volumeSize);

    [[nodiscard]] bool isAsked() const { return m_isAsked; }

    /// Works out rooms and entries of a label as words and labels stand now: after the opening.
    /// @param allows of GrowLimits, asked of voxels of the volume
    void look(std::uint32_t label, const std::function<bool(const glm::ivec3&)>& allows,
        const DenseArray<std::uint32_t>& words, const DenseArray<std::uint8_t>& labels,
        const std::function<bool(const glm::ivec3&)>& isInRange);
    /// Of a label that was looked at.
    [[nodiscard]] bool passes(
        std::uint32_t label, const glm::ivec3& parent, const glm::ivec3& voxel) const;
    [[nodiscard]] bool knows(std::uint32_t label) const { return m_rooms.count(label) != 0; }

private:
    struct Offset {
        glm::ivec3 step{0};
        int square = 0;
    };
    struct Rooms {
        DenseArray<int> room;
        DenseArray<int> entry;
    };
    [[nodiscard]] DenseArray<int> nearest(const DenseArray<std::uint8_t>& centres) const;

    core::GrowBurst m_burst;
    glm::ivec3 m_size;
    bool m_isAsked;
    std::vector<Offset> m_ball; ///< near ones first
    std::map<std::uint32_t, Rooms> m_rooms;
};

} // namespace reference
