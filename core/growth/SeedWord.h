// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace core::seedWord {

/// One 32-bit word per voxel of a live growth (DESIGN §4; seed A §5.1 "seed map").
///
///   bit 31      1: not a member
///   bits 30..13 generation of a member, 1 … 262143; 0: painted, before any growth (PaintLabel)
///   bits 12..5  label of the segment it grows
///   bits 4..0   direction to the parent, see below; 29 … 31: see below
///
/// Members are claimed by `min`, so of all claims on a voxel the earliest generation wins, then the
/// lowest label, then the lowest direction: the result does not depend on scheduling.
///
/// Direction d < 26 means that the parent is the neighbour at −offsets[d] (offsets[d] is the step
/// from parent to child; that of d ^ 1 is the opposite one): 0 … 5 faces, 6 … 17 edges, 18 … 25
/// corners. 31: a seed. Shrinking must know what is not its own to take away, so where the label
/// plane held the label already when the voxel was claimed, a seed has 30, and any other member 29
/// instead of its direction (the generations tell it: the lowest that leads from an earliest
/// neighbour).
///
/// 0 is a barrier: least of all words, so nothing claims it, and no member.
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
/// A seed that was sketched and has not yet been admitted by a growth. It is no member.
constexpr std::uint32_t pendingSeed(std::uint32_t label)
{
    return notMember | label << 5 | seedDirection;
}
/// As bricks hold it: four bytes, little-endian.
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
/// Of a member: whether the label plane held its label before it came.
constexpr bool wasHeld(std::uint32_t word)
{
    return direction(word) == heldDirection || direction(word) == heldSeedDirection;
}
/// Of a member: whether it was a seed.
constexpr bool isSeed(std::uint32_t word)
{
    return direction(word) >= heldSeedDirection;
}

} // namespace core::seedWord
