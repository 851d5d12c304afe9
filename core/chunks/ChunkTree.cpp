// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/ChunkTree.h"

#include "core/base/LargePages.h"
#include "core/base/ParallelFor.h"
#include "core/chunks/ChunkPieces.h"

#include <algorithm>
#include <numeric>

namespace core {

namespace {

/// Which piece holds each of those at the beginning, while they are joined.
class Holders {
public:
    explicit Holders(std::size_t pieces)
        : m_holder(pieces)
    {
        std::iota(m_holder.begin(), m_holder.end(), std::uint32_t(0));
    }
    void join(const PieceJoining::Joined& joined)
    {
        m_holder.push_back(joined.piece);
        m_holder[joined.first] = joined.piece;
        m_holder[joined.second] = joined.piece;
    }
    [[nodiscard]] std::uint32_t of(std::uint32_t piece)
    {
        while (m_holder[piece] != piece) {
            m_holder[piece] = m_holder[m_holder[piece]];
            piece = m_holder[piece];
        }
        return piece;
    }

private:
    std::vector<std::uint32_t> m_holder;
};

constexpr std::uint32_t joinsBetweenReports = 4096;

} // namespace

Result<ChunkTree> ChunkTree::of(const ChunkSource& source, const Progress& progress)
{
    const std::size_t voxels =
        std::size_t(source.size.x) * std::size_t(source.size.y) * std::size_t(source.size.z);
    const bool fits = source.codes.size() == voxels && source.owners.size() == voxels
        && (source.probabilities.empty() || source.probabilities.size() == voxels);
    if (voxels == 0 || !fits)
        return failure(ErrorCode::InvalidField, QStringLiteral("chunks"),
            Clause::saying("a box of another size"));
    const Result<ChunkField> field = ChunkField::of(source, progress);
    if (!field)
        return tl::unexpected(field.error());
    Result<ChunkPieces> made = chunkPieces(source, *field, progress);
    if (!made)
        return tl::unexpected(made.error());
    ChunkPieces& cut = *made;
    PieceJoining joining(std::move(cut.pieces), cut.contacts, field->noise());
    Holders holders(cut.owners.size());
    const std::uint32_t pieces = joining.left();

    const auto report = [&] {
        progress.report(ProgressStep::JoiningParts, int(pieces - joining.left()), int(pieces));
    };
    report();
    // What is finer than the finest division is nobody's to choose.
    while (joining.left() > std::uint32_t(mostChunks)) {
        const auto joined = joining.next();
        if (!joined)
            break;
        holders.join(*joined);
        if (joining.left() % joinsBetweenReports == 0) {
            if (progress.cancelled())
                return failure(ErrorCode::Cancelled);
            report();
        }
    }
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    ChunkTree tree;
    tree.m_noise = field->noise();
    std::vector<std::uint32_t> chunkOfPiece(std::size_t(pieces) * 2, none);
    // Pieces are numbered by their first voxels, and so are leaves.
    std::vector<std::uint32_t> leafOfPiece(pieces, none);
    for (std::uint32_t piece = 0; piece < pieces; ++piece) {
        const std::uint32_t holder = holders.of(piece);
        std::uint32_t& leaf = chunkOfPiece[holder];
        if (leaf == none) {
            leaf = tree.m_leaves++;
            tree.m_owners.push_back(cut.owners[piece]);
            const PieceJoining::Piece& sums = joining.piece(holder);
            tree.m_likelihoods.push_back(std::int16_t(sums.likelihoods / sums.voxels));
            tree.m_spans.push_back({.begin = 0, .count = std::uint32_t(sums.voxels)});
        }
        leafOfPiece[piece] = leaf;
    }
    tree.m_leafOfVoxel = std::move(cut.ofVoxel);
    const std::size_t slice = std::size_t(source.size.x) * std::size_t(source.size.y);
    parallelFor(source.size.z, [&](int z) {
        for (std::size_t voxel = std::size_t(z) * slice; voxel < std::size_t(z + 1) * slice;
             ++voxel) {
            std::uint32_t& its = tree.m_leafOfVoxel[voxel];
            its = its == ChunkPieces::none ? none : leafOfPiece[its];
        }
    });
    tree.m_parents.assign(tree.m_leaves, none);
    while (const auto joined = joining.next()) {
        const auto chunk = std::uint32_t(tree.m_parents.size());
        const Join join{chunkOfPiece[joined->first], chunkOfPiece[joined->second]};
        tree.m_joins.push_back(join);
        tree.m_parents[join.first] = chunk;
        tree.m_parents[join.second] = chunk;
        tree.m_parents.push_back(none);
        tree.m_owners.push_back(tree.m_owners[join.first]);
        const PieceJoining::Piece& sums = joining.piece(joined->piece);
        tree.m_likelihoods.push_back(std::int16_t(sums.likelihoods / sums.voxels));
        chunkOfPiece[joined->piece] = chunk;
    }
    tree.order();
    return tree;
}

/// Lays the voxels so that those of every chunk stand beside each other.
void ChunkTree::order()
{
    std::uint32_t all = 0;
    for (const Span& leaf : m_spans)
        all += leaf.count;
    m_spans.resize(m_parents.size());
    for (std::size_t i = 0; i < m_joins.size(); ++i)
        m_spans[m_leaves + i].count =
            m_spans[m_joins[i].first].count + m_spans[m_joins[i].second].count;
    std::uint32_t begin = 0;
    for (std::size_t chunk = 0; chunk < m_spans.size(); ++chunk) {
        if (m_parents[chunk] == none) {
            m_spans[chunk].begin = begin;
            begin += m_spans[chunk].count;
        }
    }
    for (std::size_t i = m_joins.size(); i-- > 0;) {
        const Join& join = m_joins[i];
        m_spans[join.first].begin = m_spans[m_leaves + i].begin;
        m_spans[join.second].begin = m_spans[join.first].begin + m_spans[join.first].count;
    }
    resizeInLargePages(m_voxels, all);
    std::vector<std::uint32_t> next(m_leaves);
    for (std::uint32_t leaf = 0; leaf < m_leaves; ++leaf)
        next[leaf] = m_spans[leaf].begin;
    for (std::size_t voxel = 0; voxel < m_leafOfVoxel.size(); ++voxel) {
        if (m_leafOfVoxel[voxel] != none)
            m_voxels[next[m_leafOfVoxel[voxel]]++] = std::uint32_t(voxel);
    }
}

std::optional<ChunkTree::Chunk> ChunkTree::parent(Chunk chunk) const
{
    return m_parents[chunk] == none ? std::nullopt : std::optional(m_parents[chunk]);
}

int ChunkTree::fewestWith(Chunk chunk) const
{
    // The division before the one in which it is joined.
    return m_parents[chunk] == none ? fewest() : int(2 * m_leaves - m_parents[chunk]);
}

int ChunkTree::mostWith(Chunk chunk) const
{
    return chunk < m_leaves ? finest() : int(2 * m_leaves - chunk) - 1;
}

std::uint32_t ChunkTree::firstUnmade(int count) const
{
    return m_leaves + m_leaves - std::uint32_t(std::clamp(count, fewest(), finest()));
}

std::vector<ChunkTree::Chunk> ChunkTree::division(int count) const
{
    const std::uint32_t unmade = firstUnmade(count);
    std::vector<Chunk> chunks;
    for (Chunk chunk = 0; chunk < unmade; ++chunk) {
        if (m_parents[chunk] >= unmade)
            chunks.push_back(chunk);
    }
    return chunks;
}

std::optional<ChunkTree::Chunk> ChunkTree::chunkAt(std::size_t voxel, int count) const
{
    const std::uint32_t unmade = firstUnmade(count);
    Chunk chunk = m_leafOfVoxel[voxel];
    if (chunk == none)
        return std::nullopt;
    while (m_parents[chunk] < unmade)
        chunk = m_parents[chunk];
    return chunk;
}

std::optional<ChunkTree::Chunk> ChunkTree::leafAt(std::size_t voxel) const
{
    const Chunk leaf = m_leafOfVoxel[voxel];
    return leaf == none ? std::nullopt : std::optional(leaf);
}

std::vector<ChunkTree::Chunk> ChunkTree::chunksOfLeaves(int count) const
{
    const std::uint32_t unmade = firstUnmade(count);
    // A chunk stands before the one that it is joined into.
    std::vector<Chunk> chunks(m_parents.size());
    for (std::size_t chunk = m_parents.size(); chunk-- > 0;)
        chunks[chunk] = m_parents[chunk] < unmade ? chunks[m_parents[chunk]] : Chunk(chunk);
    chunks.resize(m_leaves);
    return chunks;
}

std::span<const std::uint32_t> ChunkTree::voxels(Chunk chunk) const
{
    return std::span(m_voxels).subspan(m_spans[chunk].begin, m_spans[chunk].count);
}

std::uint8_t ChunkTree::owner(Chunk chunk) const
{
    return m_owners[chunk];
}

int ChunkTree::likelihood(Chunk chunk) const
{
    return m_likelihoods[chunk];
}

} // namespace core
