// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/ChunkSurvey.h"

#include "core/base/ParallelFor.h"
#include "core/chunks/BoxWalk.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace core {

namespace {

using Border = ChunkSurvey::Border;

/// Greater differences count like this one; in units of ChunkField::deviation.
constexpr std::int64_t mostApart = 1023;
constexpr std::size_t bordersLookedBack = 24;
constexpr std::int64_t lastCode = std::numeric_limits<std::uint16_t>::max();

/// The alikeness for each difference of codes; the last entry stands for all greater ones.
std::vector<std::uint16_t> alikenessTable(int noise)
{
    constexpr auto one = std::int64_t(ChunkField::deviation);
    constexpr auto alike = std::int64_t(ChunkSurvey::alike);
    std::vector<std::uint16_t> table;
    for (std::int64_t difference = 0, apart = 0; difference <= lastCode && apart < mostApart;
         ++difference) {
        apart = std::min(mostApart, difference * one / noise);
        table.push_back(std::uint16_t(alike * one * one / (one * one + apart * apart)));
    }
    return table;
}

class Surveying {
public:
    Surveying(const ChunkSource& source, const ChunkTree& tree)
        : m_source(source)
        , m_tree(tree)
        , m_alikeness(alikenessTable(tree.noise()))
        , m_leaves(tree.leaves())
        , m_means(std::size_t(tree.finest()))
        , m_row(std::size_t(source.size.x))
        , m_slice(m_row * std::size_t(source.size.y))
    {
    }

    /// What is known of a leaf from its voxels alone: its mean and its middle.
    std::uint32_t lookAt(ChunkTree::Chunk leaf)
    {
        const auto voxels = m_tree.voxels(leaf);
        const BoxWalk walk(m_source.size);
        std::int64_t codes = 0;
        glm::i64vec3 sum(0);
        for (const std::uint32_t voxel : voxels) {
            codes += m_source.codes[voxel];
            sum += glm::i64vec3(walk.placeOf(voxel));
        }
        const auto count = std::int64_t(voxels.size());
        m_means[leaf] = std::int32_t(codes / count);
        std::uint32_t middle = voxels.front();
        std::int64_t nearest = std::numeric_limits<std::int64_t>::max();
        const glm::i64vec3 centre = sum / count;
        for (const std::uint32_t voxel : voxels) {
            const glm::i64vec3 off = glm::i64vec3(walk.placeOf(voxel)) - centre;
            const std::int64_t squared = off.x * off.x + off.y * off.y + off.z * off.z;
            if (squared < nearest || (squared == nearest && voxel < middle)) {
                nearest = squared;
                middle = voxel;
            }
        }
        return middle;
    }

    /// The borders between chunks within a slice, and between it and the next slice.
    [[nodiscard]] std::vector<Border> bordersOf(int z) const
    {
        std::vector<Border> all;
        for (int y = 0; y < m_source.size.y; ++y) {
            const std::size_t row = std::size_t(z) * m_slice + std::size_t(y) * m_row;
            add(row, m_row - 1, 1, all);
            if (y + 1 < m_source.size.y)
                add(row, m_row, m_row, all);
            if (z + 1 < m_source.size.z)
                add(row, m_row, m_slice, all);
        }
        return summedUp(std::move(all));
    }

    [[nodiscard]] static std::vector<Border> summedUp(std::vector<Border> all)
    {
        std::sort(all.begin(), all.end(),
            [](const Border& one, const Border& other) { return one.pair() < other.pair(); });
        std::size_t count = 0;
        for (const Border& border : all) {
            if (count > 0 && all[count - 1].pair() == border.pair()) {
                all[count - 1].faces += border.faces;
                all[count - 1].bond += border.bond;
            } else {
                all[count++] = border;
            }
        }
        all.resize(count);
        all.shrink_to_fit();
        return all;
    }

private:
    [[nodiscard]] std::uint64_t alikenessOf(int difference) const
    {
        return m_alikeness[std::min(std::size_t(difference), m_alikeness.size() - 1)];
    }

    void add(std::size_t first, std::size_t count, std::size_t way, std::vector<Border>& all) const
    {
        for (std::size_t voxel = first; voxel < first + count; ++voxel) {
            const std::uint32_t one = m_leaves[voxel];
            const std::uint32_t other = m_leaves[voxel + way];
            if (one == other || one == ChunkTree::noLeaf || other == ChunkTree::noLeaf)
                continue;
            const int step =
                std::abs(int(m_source.codes[voxel]) - int(m_source.codes[voxel + way]));
            const int apart = std::max(std::abs(m_means[one] - m_means[other]), step / 2);
            const Border border{.first = std::min(one, other),
                .second = std::max(one, other),
                .faces = 1,
                .bond = alikenessOf(apart)};
            // Consecutive faces mostly belong to the same two chunks.
            const auto end = all.rbegin() + std::ptrdiff_t(std::min(bordersLookedBack, all.size()));
            const auto known = std::find_if(all.rbegin(), end,
                [&](const Border& before) { return before.pair() == border.pair(); });
            if (known == end) {
                all.push_back(border);
            } else {
                ++known->faces;
                known->bond += border.bond;
            }
        }
    }

    const ChunkSource& m_source;
    const ChunkTree& m_tree;
    std::vector<std::uint16_t> m_alikeness;
    std::span<const ChunkTree::Chunk> m_leaves; ///< by voxel
    std::vector<std::int32_t> m_means; ///< of codes, by leaf
    std::size_t m_row;
    std::size_t m_slice;
};

} // namespace

ChunkSurvey ChunkSurvey::of(const ChunkSource& source, const ChunkTree& tree)
{
    ChunkSurvey survey;
    survey.size = source.size;
    survey.middles.resize(std::size_t(tree.finest()));
    Surveying surveying(source, tree);
    parallelFor(tree.finest(), [&](int leaf) {
        survey.middles[std::size_t(leaf)] = surveying.lookAt(ChunkTree::Chunk(leaf));
    });
    auto slices = std::vector<std::vector<Border>>(std::size_t(source.size.z));
    parallelFor(source.size.z, [&](int z) { slices[std::size_t(z)] = surveying.bordersOf(z); });
    for (const std::vector<Border>& slice : slices)
        survey.borders.insert(survey.borders.end(), slice.begin(), slice.end());
    survey.borders = Surveying::summedUp(std::move(survey.borders));
    return survey;
}

} // namespace core
