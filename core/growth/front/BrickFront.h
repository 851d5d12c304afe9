// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickVoxel.h"

#include <array>
#include <cstdint>
#include <vector>

namespace core {

/// The voxels of a brick as bits: row y + 16 z holds the 16 voxels along x, bit x that at x.
using VoxelBits = std::array<std::uint16_t, BrickGrid::side * BrickGrid::side>;

/// The fronts in a brick and in its 26 neighbours; null: none there. The brick at an offset of
/// (dx, dy, dz) has the index dx + 1 + 3 (dy + 1) + 9 (dz + 1).
using FrontsAround = std::array<const VoxelBits*, 27>;

/// The voxels that generations of a growth claim in a brick, each with the direction of its claim,
/// until they are written. A voxel is claimed once, so there is always room.
class BrickClaims {
public:
    static constexpr int mostRings = 16;

    /// @param ring the generation, counted from that before the first which is kept here
    void add(int ring, std::size_t offset, std::uint32_t direction)
    {
        m_entries[m_count++] = std::uint32_t(ring) << 17 | std::uint32_t(offset) << 5 | direction;
    }
    void clear() { m_count = 0; }
    [[nodiscard]] bool empty() const { return m_count == 0; }
    [[nodiscard]] std::size_t size() const { return m_count; }

    /// Calls work(ring, offset, direction) for each of them.
    template <typename Work> void forEach(const Work& work) const
    {
        for (std::size_t i = 0; i < m_count; ++i) {
            const std::uint32_t entry = m_entries[i];
            work(entry >> 17, std::size_t(entry >> 5 & 4095u), entry & 31u);
        }
    }

private:
    std::array<std::uint32_t, BrickGrid::voxelsPerBrick> m_entries{};
    std::size_t m_count = 0;
};

struct Claimed {
    int voxels = 0;
    unsigned sides = 0; ///< that they reach, as by sidesReached()
};

/// Computes one generation of a growth in one brick: every open voxel that has a neighbour in the
/// front is claimed, by the lowest direction (seedWord::offsets) that leads to it from the front.
/// Any thread.
/// @param connectivity 6, 18 or 26
/// @param ring as for BrickClaims::add()
/// @param open the voxels that may be claimed; those that are claimed are taken out
/// @param next receives the claimed voxels, and nothing else
Claimed claimVoxels(int connectivity, int ring, const FrontsAround& fronts, VoxelBits& open,
    VoxelBits& next, BrickClaims& claims);

/// How a growth of one label writes the voxels that it claims.
struct ClaimRule {
    std::uint8_t label = 0;
    bool tellsHeld = false; ///< GrowBurst::tellsHeld
    std::uint32_t generation = 0; ///< that of ring 0
};

/// The voxels of a brick that a growth writes, `BrickGrid::voxelsPerBrick` of each kind.
struct GrownVoxels {
    std::uint32_t* words = nullptr; ///< seed words
    std::uint8_t* labels = nullptr;
    std::uint8_t* overwritten = nullptr; ///< Field::Overwritten; null: not kept here
};

/// Writes the words, labels and overwritten labels of claimed voxels, as growRing.comp does, to the
/// bit. Any thread.
void writeClaims(const ClaimRule& rule, const BrickClaims& claims, const GrownVoxels& voxels);

/// Those of some voxels of a brick that have an open neighbour. Any thread.
/// @param connectivity 6, 18 or 26
/// @param open the open voxels in the brick and around it, laid out as fronts are
[[nodiscard]] VoxelBits besideOpen(
    int connectivity, const FrontsAround& open, const VoxelBits& voxels);

/// The sides of a brick at which it has voxels of a set: bit 2 · axis for the lower end of an axis,
/// bit 2 · axis + 1 for the upper one.
[[nodiscard]] unsigned sidesReached(const VoxelBits& bits);

/// Appends voxels of a brick to a list, by offset.
void appendVoxels(const VoxelBits& bits, std::uint32_t brick, std::vector<BrickVoxel>& voxels);

} // namespace core
