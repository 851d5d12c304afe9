// SPDX-License-Identifier: Apache-2.0
#include "core/growth/front/BrickFront.h"

#include "core/growth/SeedWord.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace core {

namespace {

constexpr int side = BrickGrid::side;
constexpr int wordsOfSlice = 4; // of 64 bits, four rows each

/// Four words with the rows of a slice, row 0 in the lowest bits.
using SliceWords = std::array<std::uint64_t, wordsOfSlice>;
static_assert(std::endian::native == std::endian::little);

/// The front in a brick and one voxel around it. A row holds 16 voxels along x, shifted so that bit
/// x tells whether the voxel at x + dx is in the front.
class PaddedFront {
public:
    PaddedFront(const FrontsAround& fronts, int connectivity)
    {
        for (int slice = -1; slice <= side; ++slice) {
            for (int dy = -1; dy <= 1; ++dy)
                fill(fronts, slice, dy, connectivity);
        }
    }

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
    /// Fills the rows of a slice that lie in the brick, or beside it along y.
    void fill(const FrontsAround& fronts, int slice, int dy, int connectivity)
    {
        const int dz = slice < 0 ? -1 : slice == side ? 1 : 0;
        const int aside = std::abs(dy) + std::abs(dz);
        const std::size_t first = dy < 0 ? 0 : dy > 0 ? side + 1 : 1;
        const std::size_t count = dy == 0 ? side : 1;
        const std::size_t from = std::size_t(side * (slice & (side - 1)) + (dy < 0 ? side - 1 : 0));
        const auto at = std::size_t(3 * (dy + 1) + 9 * (dz + 1));
        const auto frontAt = [&](std::size_t place) {
            return (fronts[place] ? *fronts[place] : nothing).data() + from;
        };
        const std::uint16_t* const left = frontAt(at);
        const std::uint16_t* const own = frontAt(at + 1);
        const std::uint16_t* const right = frontAt(at + 2);
        const auto z = std::size_t(slice + 1);
        std::uint16_t* const before = &m_rows[0][z][first]; // the voxels at x − 1
        std::uint16_t* const here = &m_rows[1][z][first];
        std::uint16_t* const after = &m_rows[2][z][first];
        std::copy_n(own, count, here);
        // Neighbours along edges need no corners, and those across faces no edges.
        if (aside != 0 && (aside != 1 || connectivity == 6) && connectivity <= 18)
            return;
        for (std::size_t i = 0; i < count; ++i)
            before[i] = std::uint16_t(own[i] << 1 | left[i] >> (side - 1));
        for (std::size_t i = 0; i < count; ++i)
            after[i] = std::uint16_t(own[i] >> 1 | right[i] << (side - 1));
    }

    static constexpr BrickBits nothing{};
    std::uint16_t m_rows[3][side + 2][side + 2] = {}; ///< by dx + 1, slice + 1 and row + 1
};

} // namespace

int claimVoxels(int connectivity, int ring, const FrontsAround& fronts, BrickBits& open,
    BrickBits& next, BrickClaims& claims)
{
    const PaddedFront front(fronts, connectivity);
    int claimed = 0;
    for (int slice = 0; slice < side; ++slice) {
        const auto at = std::size_t(side * slice);
        SliceWords left;
        std::memcpy(left.data(), &open[at], sizeof left);
        SliceWords taken{};
        if ((left[0] | left[1] | left[2] | left[3]) == 0) {
            std::memcpy(&next[at], taken.data(), sizeof taken);
            continue;
        }
        for (std::uint32_t direction = 0; direction < std::uint32_t(connectivity); ++direction) {
            const SliceWords came = front.cameBy(seedWord::offsets[direction], slice);
            for (std::size_t i = 0; i < wordsOfSlice; ++i) {
                std::uint64_t bits = came[i] & left[i];
                left[i] &= ~bits;
                taken[i] |= bits;
                for (; bits != 0; bits &= bits - 1, ++claimed)
                    claims.add(
                        ring, at * side + 64 * i + std::size_t(std::countr_zero(bits)), direction);
            }
        }
        std::memcpy(&open[at], left.data(), sizeof left);
        std::memcpy(&next[at], taken.data(), sizeof taken);
    }
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

unsigned sidesReached(const BrickBits& bits)
{
    unsigned rows = 0; // all of them together
    unsigned reached = 0;
    for (std::size_t z = 0; z < side; ++z) {
        unsigned slice = 0;
        for (std::size_t y = 0; y < side; ++y)
            slice |= bits[side * z + y];
        rows |= slice;
        if (bits[side * z] != 0)
            reached |= 1u << 2;
        if (bits[side * z + side - 1] != 0)
            reached |= 1u << 3;
        if (slice != 0 && z == 0)
            reached |= 1u << 4;
        if (slice != 0 && z == side - 1)
            reached |= 1u << 5;
    }
    if ((rows & 1u) != 0)
        reached |= 1u << 0;
    if ((rows >> (side - 1) & 1u) != 0)
        reached |= 1u << 1;
    return reached;
}

} // namespace core
