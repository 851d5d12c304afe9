// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/WordBricks.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace core {

/// The contents of one brick as an engine hands them over. Empty words, labels or overwritten
/// labels mean that all of its voxels have none.
struct GrowthBrick {
    std::vector<std::uint8_t> words{}; ///< 4096 seed words, little-endian
    std::vector<std::uint8_t> labels{};
    std::vector<std::uint8_t> overwritten{}; ///< Field::Overwritten
    std::vector<std::uint16_t> codes{}; ///< 4096; whatever lies outside the volume is not read
};

/// A changed voxel, in the layout that the kernel growChange.comp reads.
struct GrowthChange {
    std::uint32_t brick = 0;
    std::uint32_t word = 0;
    /// Label of the plane | overwritten label << 8 | offset in the brick << 16.
    std::uint32_t labelsAndOffset = 0;
};

/// Reads bricks; the results are in the order of the list.
using ReadGrowthBricks =
    std::function<std::vector<GrowthBrick>(std::span<const std::uint32_t> bricks)>;

/// A growth in memory, brick by brick: seed words, labels and codes of all bricks that contain
/// members or seeds, and of the bricks that such voxels touch. Everything that was written since
/// keep() can be reverted, at a cost ∝ what was written.
///
/// In words(), voxels outside the volume are barriers, so callers need not check where the volume
/// ends.
class GrowthBricks {
public:
    using Voxel = WordBricks::Voxel;

    /// What an edit can change at one voxel.
    struct State {
        std::uint32_t word = seedWord::unvisited;
        std::uint8_t label = 0; ///< label of the plane
        std::uint8_t overwritten = 0;
        bool operator==(const State&) const = default;
    };

    /// @param held all bricks with seed words, each once
    GrowthBricks(
        const BrickGrid& grid, std::span<const std::uint32_t> held, const ReadGrowthBricks& read);

    [[nodiscard]] const WordBricks& words() const { return m_words; }
    [[nodiscard]] std::size_t brickCount() const { return m_words.count() >> 12; }
    [[nodiscard]] int code(Voxel voxel) const { return m_codes[voxel]; }
    [[nodiscard]] std::uint8_t label(Voxel voxel) const { return m_labels[voxel]; }
    [[nodiscard]] State at(Voxel voxel) const
    {
        return {m_words[voxel], m_labels[voxel], m_overwritten[voxel]};
    }

    void write(Voxel voxel, const State& state);
    /// Makes the present state the one to which revert() returns.
    void keep();
    /// @param onWord called for each voxel with its present word and the one that is restored
    template <class OnWord> void revert(const OnWord& onWord)
    {
        for (auto former = m_log.rbegin(); former != m_log.rend(); ++former) {
            onWord(m_words[former->voxel], former->state.word);
            put(former->voxel, former->state);
        }
        m_log.clear();
    }

    /// The present contents of all voxels that were written since they were read and not reverted.
    /// A voxel that was written several times may occur several times.
    [[nodiscard]] std::vector<GrowthChange> changes() const;

private:
    void add(std::span<const std::uint32_t> bricks, const ReadGrowthBricks& read);
    /// Bricks that are not here yet and are touched by members or seeds.
    [[nodiscard]] std::vector<std::uint32_t> touchedBricks() const;
    [[nodiscard]] std::uint32_t sidesTouched(std::size_t place) const;
    void put(Voxel voxel, const State& state);

    WordBricks m_words;
    std::vector<std::uint16_t> m_codes;
    std::vector<std::uint8_t> m_labels;
    std::vector<std::uint8_t> m_overwritten;
    struct Former {
        Voxel voxel = 0;
        State state;
    };
    std::vector<Former> m_log; ///< since keep()
    std::vector<Voxel> m_kept; ///< written before keep()
};

} // namespace core
