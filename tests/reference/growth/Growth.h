// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/LabelCommands.h"
#include "core/growth/GrowthProgress.h"
#include "tests/reference/fields/DenseFields.h"
#include "tests/reference/growth/FrontWatch.h"
#include "tests/reference/growth/GrowCriterion.h"
#include "tests/reference/growth/Passage.h"

#include <bitset>
#include <memory>
#include <optional>

namespace reference {

/// Marks pending seeds (core::SeedPlacement).
void placeSeeds(DenseFields& fields, const core::SeedPlacement& placement);

/// Takes a label out of labels and seed words (core::EraseLabel).
void eraseLabel(DenseFields& fields, const core::EraseLabel& erase);

/// A member is about to leave: what it added to the plane is given back
/// (core/growth/GrowthCommands.h). @param word its own
void giveBack(DenseFields& fields, std::uint8_t plane, const glm::ivec3& voxel, std::uint32_t word);

/// What core::PaintBarrier does to one voxel.
void setOrClearBarrier(DenseFields& fields, std::uint8_t plane, bool erase,
    const std::bitset<256>& lockedLabels, const glm::ivec3& voxel);

/// Takes back what a growth added (core::ShrinkGrowth). @return the generation then
std::uint32_t shrinkGrowth(DenseFields& fields, const core::ShrinkGrowth& shrink);

/// One open burst of growth (core::GrowBurst). Codes and fields are borrowed.
class Growth {
public:
    /// Takes back what has to leave, and admits the pending seeds. @param coverage of the composed
    /// layers
    Growth(const DenseArray<std::uint16_t>& codes, DenseArray<std::uint8_t> coverage,
        DenseFields& fields, core::GrowBurst burst);

    /// @param steps negative: to closure
    void advance(int steps);

    [[nodiscard]] std::uint8_t plane() const { return m_burst.plane; }
    [[nodiscard]] std::uint32_t openedAt() const { return m_burst.generation; }
    [[nodiscard]] std::uint32_t generation() const { return m_generation; }
    [[nodiscard]] bool atClosure() const { return m_atClosure; }
    [[nodiscard]] const std::vector<std::uint32_t>& frontSizes() const { return m_frontSizes; }
    [[nodiscard]] const std::optional<core::LeakAlarm>& alarm() const { return m_alarm; }

private:
    [[nodiscard]] bool accepts(std::uint32_t label, const glm::ivec3& voxel) const;
    /// The same of a member, as if it had been given back.
    [[nodiscard]] bool acceptsMember(const glm::ivec3& voxel) const;
    [[nodiscard]] std::uint8_t heldBefore(const glm::ivec3& voxel) const;
    [[nodiscard]] bool isInRange(const glm::ivec3& voxel, std::uint8_t held) const;
    [[nodiscard]] bool mayEnter(
        std::uint32_t label, const glm::ivec3& voxel, std::uint8_t held) const;
    /// Whether the label plane held the label there before, where that is told.
    [[nodiscard]] bool holds(std::uint32_t label, const glm::ivec3& voxel) const;
    /// core::GrowOpening::Narrow.
    void narrow();
    /// The lowest direction from a member of the same label and of an earlier generation.
    [[nodiscard]] std::optional<std::uint32_t> parentDirection(const glm::ivec3& voxel) const;
    /// Works out what the passage width asks, for every label that has a seed or a member.
    void lookForPassages();
    [[nodiscard]] bool follows(
        std::uint32_t label, const glm::ivec3& parent, const glm::ivec3& voxel) const;
    /// True if anything was added.
    bool step();
    /// One more generation is finished: counts it and shows it in the label plane.
    void finishGeneration(std::vector<glm::ivec3> added);

    core::GrowBurst m_burst;
    DenseFields& m_fields;
    DenseArray<std::uint32_t>& m_words;
    DenseArray<std::uint8_t>& m_labels;
    DenseArray<std::uint8_t>& m_overwritten;
    GrowCriterion m_criterion;
    std::unique_ptr<Passage> m_passage; ///< none where it asks nothing
    std::vector<glm::ivec3> m_front; ///< members that may have neighbours to take
    std::uint32_t m_generation = 0;
    bool m_atClosure = false;
    std::vector<std::uint32_t> m_frontSizes;
    std::optional<FrontWatch> m_watch;
    std::optional<core::LeakAlarm> m_alarm;
};

} // namespace reference
