// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/CoarseChunks.h"

#include "core/base/ParallelFor.h"

#include <algorithm>
#include <span>
#include <utility>

namespace core {

namespace {

/// The cells of a box.
class Cells {
public:
    Cells(const glm::ivec3& boxSize, std::int64_t most)
        : m_boxSize(boxSize)
    {
        do {
            ++m_side;
            m_size = (boxSize + m_side - 1) / m_side;
        } while (std::int64_t(m_size.x) * m_size.y * m_size.z > most && m_size != glm::ivec3(1));
    }

    [[nodiscard]] int side() const { return m_side; }
    [[nodiscard]] const glm::ivec3& size() const { return m_size; }
    /// What the middle voxels of the cells have. Empty for nothing.
    template <class T> [[nodiscard]] std::vector<T> sampled(std::span<const T> voxels) const
    {
        if (voxels.empty())
            return {};
        const auto row = std::size_t(m_size.x);
        std::vector<T> cells(row * std::size_t(m_size.y) * std::size_t(m_size.z));
        parallelFor(m_size.z, [&](int z) {
            std::size_t cell = std::size_t(z) * row * std::size_t(m_size.y);
            for (int y = 0; y < m_size.y; ++y) {
                for (int x = 0; x < m_size.x; ++x, ++cell)
                    cells[cell] = voxels[middleOf({x, y, z})];
            }
        });
        return cells;
    }

private:
    [[nodiscard]] std::size_t middleOf(const glm::ivec3& cell) const
    {
        const glm::ivec3 at = glm::min(m_side * cell + m_side / 2, m_boxSize - 1);
        return std::size_t(at.x)
            + std::size_t(m_boxSize.x)
            * (std::size_t(at.y) + std::size_t(m_boxSize.y) * std::size_t(at.z));
    }

    glm::ivec3 m_boxSize;
    int m_side = 1;
    glm::ivec3 m_size{0};
};

} // namespace

Result<CoarseChunks> CoarseChunks::of(
    const ChunkSource& source, const VoxelBox& box, const Progress& progress, std::int64_t most)
{
    const Cells cells(source.size, most);
    const std::vector<std::uint16_t> codes = cells.sampled(source.codes);
    const std::vector<std::uint8_t> owners = cells.sampled(source.owners);
    const std::vector<std::uint8_t> probabilities = cells.sampled(source.probabilities);
    Result<ChunkTree> tree = ChunkTree::of({.size = cells.size(),
                                               .codes = codes,
                                               .owners = owners,
                                               .probabilities = probabilities,
                                               .likely = source.likely},
        progress);
    if (!tree)
        return tl::unexpected(tree.error());
    auto leaves = std::make_shared<std::vector<std::uint16_t>>(tree->leaves().size());
    std::transform(
        tree->leaves().begin(), tree->leaves().end(), leaves->begin(), [](ChunkTree::Chunk leaf) {
            return std::uint16_t(leaf == ChunkTree::noLeaf ? 0 : leaf + 1);
        });
    ChunkColours colours(*tree, cells.size());
    return CoarseChunks{.box = box,
        .cell = cells.side(),
        .tree = *std::move(tree),
        .leaves = std::move(leaves),
        .colours = std::move(colours)};
}

} // namespace core
