// SPDX-License-Identifier: Apache-2.0
#include "core/growth/front/BrickFront.h"

#include "core/growth/SeedWord.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>

namespace core {

namespace {

constexpr int side = BrickGrid::side;
constexpr int wordsOfSlice = 4; // of 64 bits, four rows each

/// Four words with the rows of a slice, row 0 in the lowest bits.
using SliceWords = std::array<std::uint64_t, wordsOfSlice>;
static_assert(std::endian::native == std::endian::little);

bool isEmpty(const SliceWords& words)
{
    return (words[0] | words[1] | words[2] | words[3]) == 0;
}

/// The sides along x and y (sidesReached()).
unsigned sidesOfSlice(const SliceWords& words)
{
    constexpr std::uint64_t lowest = 0x0001000100010001; // the first voxel of each row
    constexpr std::uint64_t row = 0xFFFF;
    const std::uint64_t all = words[0] | words[1] | words[2] | words[3];
    unsigned sides = 0;
    if ((all & lowest) != 0)
        sides |= 1u << 0;
    if ((all & lowest << (side - 1)) != 0)
        sides |= 1u << 1;
    if ((words.front() & row) != 0)
        sides |= 1u << 2;
    if ((words.back() & row << 48) != 0)
        sides |= 1u << 3;
    return sides;
}

/// The front in a brick and one voxel around it. A row holds 16 voxels along x, shifted so that bit
/// x tells whether the voxel at x + dx is in the front.
class PaddedFront {
public:
    PaddedFront(const FrontsAround& fronts, int connectivity)
    {
        for (int dz = -1; dz <= 1; ++dz) {
            for (int dy = -1; dy <= 1; ++dy) {
                const auto at = std::size_t(3 * (dy + 1) + 9 * (dz + 1));
                if (!fronts[at] && !fronts[at + 1] && !fronts[at + 2])
                    continue;
                // Neighbours along edges need no corners, and those across faces no edges.
                const int aside = std::abs(dy) + std::abs(dz);
                const bool shifts =
                    aside == 0 || (aside == 1 && connectivity > 6) || connectivity > 18;
                const Row row{.left = bitsOf(fronts[at]),
                    .own = bitsOf(fronts[at + 1]),
                    .right = bitsOf(fronts[at + 2]),
                    .shifts = shifts};
                if (dy == 0)
                    fill<side>(row, 0, 1, dz);
                else
                    fill<1>(row, dy < 0 ? side - 1 : 0, dy < 0 ? 0 : side + 1, dz);
            }
        }
    }

    /// Whether no voxel of a slice has a neighbour in the front.
    [[nodiscard]] bool isFarFrom(int slice) const { return (m_filled >> slice & 7u) == 0; }
    /// Whether the voxels of a slice have a neighbour in the front, one step back.
    [[nodiscard]] SliceWords cameBy(const std::array<int, 3>& step, int slice) const
    {
        SliceWords words;
        std::memcpy(words.data(),
            &m_rows[std::size_t(1 - step[0])][std::size_t(slice + 1 - step[2])]
                   [std::size_t(1 - step[1])],
            sizeof words);
        return words;
    }

private:
    /// Three bricks that follow each other along x.
    struct Row {
        const VoxelBits& left;
        const VoxelBits& own;
        const VoxelBits& right;
        bool shifts = false; ///< whether rows shifted along x are needed, too
    };
    [[nodiscard]] static const VoxelBits& bitsOf(const VoxelBits* front)
    {
        return front ? *front : nothing;
    }
    /// Fills rows of each slice that is needed.
    /// @param from their first row in the bricks
    /// @param to their first row here
    template <int Rows> void fill(const Row& bricks, int from, int to, int dz)
    {
        if (dz < 0) {
            fillSlice<Rows>(bricks, side * (side - 1) + from, to, 0);
        } else if (dz > 0) {
            fillSlice<Rows>(bricks, from, to, side + 1);
        } else {
            for (int slice = 0; slice < side; ++slice)
                fillSlice<Rows>(bricks, side * slice + from, to, slice + 1);
        }
    }
    template <int Rows> void fillSlice(const Row& bricks, int from, int to, int z)
    {
        const std::uint16_t* const left = bricks.left.data() + from;
        const std::uint16_t* const own = bricks.own.data() + from;
        const std::uint16_t* const right = bricks.right.data() + from;
        unsigned any = 0;
        for (int i = 0; i < Rows; ++i)
            any |= unsigned(left[i] | own[i] | right[i]);
        if (any == 0)
            return;
        m_filled |= 1u << z;
        std::uint16_t* const before = &m_rows[0][z][to]; // the voxels at x − 1
        std::uint16_t* const here = &m_rows[1][z][to];
        std::uint16_t* const after = &m_rows[2][z][to];
        std::copy_n(own, Rows, here);
        if (!bricks.shifts)
            return;
        for (int i = 0; i < Rows; ++i)
            before[i] = std::uint16_t(own[i] << 1 | left[i] >> (side - 1));
        for (int i = 0; i < Rows; ++i)
            after[i] = std::uint16_t(own[i] >> 1 | right[i] << (side - 1));
    }

    static constexpr VoxelBits nothing{};
    std::uint16_t m_rows[3][side + 2][side + 2] = {}; ///< by dx + 1, slice + 1 and row + 1
    unsigned m_filled = 0; ///< bit slice + 1: something is in the front there
};

} // namespace

Claimed claimVoxels(int connectivity, int ring, const FrontsAround& fronts, VoxelBits& open,
    VoxelBits& next, BrickClaims& claims)
{
    const PaddedFront front(fronts, connectivity);
    Claimed claimed;
    SliceWords all{}; // of all slices together
    for (int slice = 0; slice < side; ++slice) {
        const auto at = std::size_t(side * slice);
        SliceWords left;
        std::memcpy(left.data(), &open[at], sizeof left);
        SliceWords taken{};
        if (isEmpty(left) || front.isFarFrom(slice)) {
            std::memcpy(&next[at], taken.data(), sizeof taken);
            continue;
        }
        for (std::uint32_t direction = 0; direction < std::uint32_t(connectivity); ++direction) {
            const SliceWords came = front.cameBy(seedWord::offsets[direction], slice);
            for (std::size_t i = 0; i < wordsOfSlice; ++i) {
                std::uint64_t bits = came[i] & left[i];
                left[i] &= ~bits;
                taken[i] |= bits;
                for (; bits != 0; bits &= bits - 1, ++claimed.voxels)
                    claims.add(
                        ring, at * side + 64 * i + std::size_t(std::countr_zero(bits)), direction);
            }
        }
        std::memcpy(&open[at], left.data(), sizeof left);
        std::memcpy(&next[at], taken.data(), sizeof taken);
        for (std::size_t i = 0; i < wordsOfSlice; ++i)
            all[i] |= taken[i];
        if (slice == 0 && !isEmpty(taken))
            claimed.sides |= 1u << 4;
        if (slice == side - 1 && !isEmpty(taken))
            claimed.sides |= 1u << 5;
    }
    claimed.sides |= sidesOfSlice(all);
    return claimed;
}

void writeClaims(const ClaimRule& rule, const BrickClaims& claims, const GrownVoxels& voxels)
{
    claims.forEach([&](std::uint32_t ring, std::size_t offset, std::uint32_t direction) {
        const std::uint8_t there = voxels.labels[offset];
        const bool held = rule.tellsHeld && there == rule.label;
        voxels.words[offset] = seedWord::member(
            rule.generation + ring, rule.label, held ? seedWord::heldDirection : direction);
        if (voxels.overwritten && !held)
            voxels.overwritten[offset] = rule.tellsHeld ? there : 0;
        voxels.labels[offset] = rule.label;
    });
}

VoxelBits besideOpen(int connectivity, const FrontsAround& open, const VoxelBits& voxels)
{
    const PaddedFront around(open, connectivity);
    VoxelBits beside{};
    for (int slice = 0; slice < side; ++slice) {
        const auto at = std::size_t(side * slice);
        SliceWords asked;
        std::memcpy(asked.data(), &voxels[at], sizeof asked);
        if (isEmpty(asked) || around.isFarFrom(slice))
            continue;
        SliceWords near{};
        for (std::uint32_t direction = 0; direction < std::uint32_t(connectivity); ++direction) {
            const SliceWords there = around.cameBy(seedWord::offsets[direction], slice);
            for (std::size_t i = 0; i < wordsOfSlice; ++i)
                near[i] |= there[i] & asked[i];
        }
        std::memcpy(&beside[at], near.data(), sizeof near);
    }
    return beside;
}

unsigned sidesReached(const VoxelBits& bits)
{
    unsigned sides = 0;
    for (int slice = 0; slice < side; ++slice) {
        SliceWords words;
        std::memcpy(words.data(), &bits[std::size_t(side * slice)], sizeof words);
        if (isEmpty(words))
            continue;
        sides |= sidesOfSlice(words);
        if (slice == 0)
            sides |= 1u << 4;
        if (slice == side - 1)
            sides |= 1u << 5;
    }
    return sides;
}

void appendVoxels(const VoxelBits& bits, std::uint32_t brick, std::vector<BrickVoxel>& voxels)
{
    for (std::uint32_t row = 0; row < bits.size(); ++row) {
        for (unsigned left = bits[row]; left != 0; left &= left - 1)
            voxels.push_back(
                {.brick = brick, .offset = row << 4 | std::uint32_t(std::countr_zero(left))});
    }
}

} // namespace core
