// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace core::seedWord {

/// The state of one voxel in a growth, as one 32-bit word (the "seed map" of seed A §5.1).
///
///   bit 31      1: not a member
///   bits 30..13 generation of a member, 1 … 262143; 0: painted, before any growth (PaintLabel)
///   bits 12..5  label of the segment it grows
///   bits 4..0   direction from the parent, or 29 … 31 (below)
///
/// A claim on a voxel is the minimum of its word and the claimed one. So the earliest generation
/// wins, then the lowest label, then the lowest direction, and the result does not depend on
/// scheduling.
///
/// A direction d < 26 says that the parent is the neighbour at −offsets[d]: offsets[d] is the step
/// from parent to child, and direction d ^ 1 is the opposite of d. 0 … 5 are faces, 6 … 17 edges,
/// 18 … 25 corners. 31 is a seed. Shrinking must not remove labels that were there before the
/// growth: where the label plane already held the label when the voxel was claimed, the direction
/// is 30 for a seed and 29 for any other member. (The real direction of a 29 follows from the
/// generations: it is the lowest one that leads from a neighbour of the earliest generation.)
///
/// A word of 0 is a barrier. It is the least of all words, so no claim changes it. It is no member.
constexpr std::uint32_t directions = 26;
constexpr std::array<std::array<int, 3>, directions> offsets{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0},
    {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {1, 0, 1},
    {-1, 0, -1}, {1, 0, -1}, {-1, 0, 1}, {0, 1, 1}, {0, -1, -1}, {0, 1, -1}, {0, -1, 1}, {1, 1, 1},
    {-1, -1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, -1}, {-1, 1, 1}, {1, -1, -1}}};
constexpr std::uint32_t unvisited = 0xFFFFFFFFu;
constexpr std::uint32_t notMember = 0x80000000u;
constexpr std::uint32_t barrier = 0;
constexpr std::uint32_t seedDirection = 31;
constexpr std::uint32_t heldSeedDirection = 30;
constexpr std::uint32_t heldDirection = 29;
constexpr std::uint32_t maxGeneration = (1u << 18) - 1;

constexpr std::uint32_t member(
    std::uint32_t generation, std::uint32_t label, std::uint32_t direction)
{
    return generation << 13 | label << 5 | direction;
}
/// The word of a seed that was sketched and has not yet been admitted to a growth; not a member.
constexpr std::uint32_t pendingSeed(std::uint32_t label)
{
    return notMember | label << 5 | seedDirection;
}
/// Reads a word from the bytes of a brick, which are little-endian.
constexpr std::uint32_t wordAt(const std::uint8_t* bytes)
{
    return std::uint32_t(bytes[0]) | std::uint32_t(bytes[1]) << 8 | std::uint32_t(bytes[2]) << 16
        | std::uint32_t(bytes[3]) << 24;
}
constexpr bool isMember(std::uint32_t word)
{
    return (word & notMember) == 0 && word != barrier;
}
constexpr bool isPendingSeed(std::uint32_t word)
{
    return word != unvisited && (word & notMember) != 0 && (word & 31u) == seedDirection;
}
constexpr std::uint32_t generation(std::uint32_t word)
{
    return word >> 13 & maxGeneration;
}
constexpr std::uint32_t label(std::uint32_t word)
{
    return word >> 5 & 0xFFu;
}
constexpr std::uint32_t direction(std::uint32_t word)
{
    return word & 31u;
}
/// For a member: whether the label plane already held its label when it was claimed.
constexpr bool wasHeld(std::uint32_t word)
{
    return direction(word) == heldDirection || direction(word) == heldSeedDirection;
}
/// For a member: whether it began as a seed.
constexpr bool isSeed(std::uint32_t word)
{
    return direction(word) >= heldSeedDirection;
}

} // namespace core::seedWord
