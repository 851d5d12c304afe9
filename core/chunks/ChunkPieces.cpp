// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/ChunkPieces.h"

#include "core/base/LargePages.h"
#include "core/base/ParallelFor.h"
#include "core/chunks/SharedProgress.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>

namespace core {

namespace {

constexpr int cellSide = 4; ///< of a cell; its voxels are the bits of one number
constexpr int alikeCodes = ChunkField::deviation * 3 / 2;
constexpr std::size_t contactsLookedBack = 24;

using Cell = std::uint64_t;

/// What is in a layer of cells: its pieces are numbered by their first voxels.
struct Layer {
    struct Found {
        std::uint32_t first = 0; ///< voxel of the box
        PieceJoining::Piece piece{};
        std::uint8_t owner = 0;
    };
    std::vector<Found> found;
    std::uint32_t begin = 0; ///< number of its first piece
    std::vector<PieceJoining::Contact> contacts;
};

/// Cuts a box, one layer of cells after the other; layers do not depend on each other.
class Cutting {
public:
    Cutting(const ChunkSource& source, const ChunkField& field, ChunkPieces& pieces)
        : m_source(source)
        , m_likelihoods(field.likelihoods())
        , m_within(field.codesWithin(alikeCodes))
        , m_pieces(pieces)
        , m_row(std::size_t(source.size.x))
        , m_slice(m_row * std::size_t(source.size.y))
    {
    }

    /// The pieces of a layer, and for each voxel of which of them it is.
    void cut(int z, Layer& layer)
    {
        for (int y = 0; y < m_source.size.y; y += cellSide) {
            for (int x = 0; x < m_source.size.x; x += cellSide)
                cutCell({x, y, z}, layer);
        }
        std::vector<std::uint32_t> order(layer.found.size());
        for (std::uint32_t i = 0; i < order.size(); ++i)
            order[i] = i;
        std::sort(order.begin(), order.end(), [&](std::uint32_t one, std::uint32_t other) {
            return layer.found[one].first < layer.found[other].first;
        });
        std::vector<std::uint32_t> ranks(order.size());
        std::vector<Layer::Found> sorted;
        sorted.reserve(order.size());
        for (const std::uint32_t found : order) {
            ranks[found] = std::uint32_t(sorted.size());
            sorted.push_back(layer.found[found]);
        }
        layer.found = std::move(sorted);
        forEachVoxelOf(z, [&](std::uint32_t& piece) { piece = ranks[piece]; });
    }
    /// Numbers its pieces on from those of the layers before.
    void number(int z, const Layer& layer)
    {
        forEachVoxelOf(z, [&](std::uint32_t& piece) { piece += layer.begin; });
        for (std::size_t i = 0; i < layer.found.size(); ++i) {
            m_pieces.pieces[layer.begin + i] = layer.found[i].piece;
            m_pieces.owners[layer.begin + i] = layer.found[i].owner;
        }
    }
    /// Those whose first piece is in the layer, ascending.
    void findContacts(int z, Layer& layer) const
    {
        std::vector<PieceJoining::Contact> all;
        const glm::ivec3 size = m_source.size;
        const int end = std::min(z + cellSide, size.z);
        for (int at = z; at < end; ++at) {
            for (int y = 0; y < size.y; ++y) {
                const std::size_t row = std::size_t(at) * m_slice + std::size_t(y) * m_row;
                addContacts(row, m_row - 1, 1, all);
                if (y + 1 < size.y)
                    addContacts(row, m_row, m_row, all);
                if (at + 1 < size.z)
                    addContacts(row, m_row, m_slice, all);
            }
        }
        const auto before = [](const PieceJoining::Contact& one,
                                const PieceJoining::Contact& other) {
            return one.pair() < other.pair();
        };
        std::sort(all.begin(), all.end(), before);
        for (const PieceJoining::Contact& contact : all) {
            if (!layer.contacts.empty() && layer.contacts.back().pair() == contact.pair())
                layer.contacts.back().faces += contact.faces;
            else
                layer.contacts.push_back(contact);
        }
    }

private:
    template <class Visit> void forEachVoxelOf(int z, const Visit& visit)
    {
        const std::size_t end = std::size_t(std::min(z + cellSide, m_source.size.z)) * m_slice;
        for (std::size_t voxel = std::size_t(z) * m_slice; voxel < end; ++voxel) {
            if (m_pieces.ofVoxel[voxel] != ChunkPieces::none)
                visit(m_pieces.ofVoxel[voxel]);
        }
    }

    void cutCell(const glm::ivec3& from, Layer& layer)
    {
        const glm::ivec3 size = glm::min(glm::ivec3(cellSide), m_source.size - from);
        std::array<std::uint32_t, 64> voxels{};
        std::array<int, 64> codes{};
        std::array<int, 64> likelihoods{};
        std::array<std::uint8_t, 64> owners{};
        owners.fill(ChunkSource::outside);
        Cell left = 0;
        for (int z = 0; z < size.z; ++z) {
            for (int y = 0; y < size.y; ++y) {
                std::size_t voxel = std::size_t(from.z + z) * m_slice
                    + std::size_t(from.y + y) * m_row + std::size_t(from.x);
                auto bit = std::size_t(z * cellSide + y) * std::size_t(cellSide);
                for (int x = 0; x < size.x; ++x, ++voxel, ++bit) {
                    voxels[bit] = std::uint32_t(voxel);
                    codes[bit] = m_source.codes[voxel];
                    likelihoods[bit] = m_likelihoods[voxel];
                    owners[bit] = m_source.owners[voxel];
                    left |= Cell(owners[bit] != ChunkSource::outside) << bit;
                }
            }
        }
        // A bit: the voxel hangs together with the next one along the axis.
        const auto linked = [&](int way) {
            Cell links = 0;
            for (std::size_t bit = 0; bit + std::size_t(way) < 64; ++bit) {
                const std::size_t next = bit + std::size_t(way);
                const bool isLinked = owners[bit] == owners[next]
                    && std::abs(codes[bit] - codes[next]) <= m_within
                    && std::abs(likelihoods[bit] - likelihoods[next]) <= alikeCodes;
                links |= Cell(isLinked) << bit;
            }
            return links;
        };
        constexpr Cell notLastColumn = 0x7777777777777777;
        constexpr Cell notLastRow = 0x0FFF0FFF0FFF0FFF;
        const Cell alongX = linked(1) & notLastColumn;
        const Cell alongY = linked(cellSide) & notLastRow;
        const Cell alongZ = linked(cellSide * cellSide);
        while (left != 0) {
            Cell piece = left & ~(left - 1);
            for (Cell before = 0; before != piece;) {
                before = piece;
                piece |= (piece & alongX) << 1U | (piece >> 1U & alongX);
                piece |= (piece & alongY) << 4U | (piece >> 4U & alongY);
                piece |= (piece & alongZ) << 16U | (piece >> 16U & alongZ);
            }
            const auto first = std::size_t(std::countr_zero(piece));
            const auto number = std::uint32_t(layer.found.size());
            Layer::Found found{.first = voxels[first], .piece = {}, .owner = owners[first]};
            for (Cell rest = piece; rest != 0; rest &= rest - 1) {
                const auto bit = std::size_t(std::countr_zero(rest));
                ++found.piece.voxels;
                found.piece.codes += codes[bit];
                found.piece.likelihoods += likelihoods[bit];
                m_pieces.ofVoxel[voxels[bit]] = number;
            }
            layer.found.push_back(found);
            left &= ~piece;
        }
    }

    /// The contacts of the voxels of a row with those at a distance in memory.
    void addContacts(std::size_t first, std::size_t count, std::size_t way,
        std::vector<PieceJoining::Contact>& all) const
    {
        const std::uint32_t* pieces = m_pieces.ofVoxel.data();
        for (std::size_t voxel = first; voxel < first + count; ++voxel) {
            const std::uint32_t one = pieces[voxel];
            const std::uint32_t other = pieces[voxel + way];
            if (one == other || m_source.owners[voxel] != m_source.owners[voxel + way]
                || one == ChunkPieces::none)
                continue;
            const PieceJoining::Contact contact{
                .first = std::min(one, other), .second = std::max(one, other)};
            // Faces between the same two mostly follow each other.
            const std::size_t back = std::min(contactsLookedBack, all.size());
            const auto known = std::find_if(all.rbegin(), all.rbegin() + std::ptrdiff_t(back),
                [&](const PieceJoining::Contact& before) {
                    return before.pair() == contact.pair();
                });
            if (known != all.rbegin() + std::ptrdiff_t(back))
                ++known->faces;
            else
                all.push_back(contact);
        }
    }

    const ChunkSource& m_source;
    std::span<const std::int16_t> m_likelihoods;
    int m_within;
    ChunkPieces& m_pieces;
    std::size_t m_row;
    std::size_t m_slice;
};

} // namespace

Result<ChunkPieces> chunkPieces(
    const ChunkSource& source, const ChunkField& field, const Progress& progress)
{
    ChunkPieces pieces;
    resizeInLargePages(pieces.ofVoxel, source.owners.size(), ChunkPieces::none);
    const int count = (source.size.z + cellSide - 1) / cellSide;
    auto layers = std::vector<Layer>(std::size_t(count));
    Cutting cutting(source, field, pieces);
    SharedProgress shared(progress, ProgressStep::CuttingIntoPieces, 2 * count);
    const auto forEachLayer = [&](const auto& visit) {
        parallelFor(count, [&](int i) {
            if (progress.cancelled())
                return;
            visit(i * cellSide, layers[std::size_t(i)]);
            shared.advance(1);
        });
    };
    forEachLayer([&](int z, Layer& layer) { cutting.cut(z, layer); });
    std::uint32_t pieceCount = 0;
    for (Layer& layer : layers) {
        layer.begin = pieceCount;
        pieceCount += std::uint32_t(layer.found.size());
    }
    // Each join makes one more (PieceJoining).
    reserveInLargePages(pieces.pieces, 2 * std::size_t(pieceCount));
    pieces.pieces.resize(pieceCount);
    pieces.owners.resize(pieceCount);
    parallelFor(count, [&](int i) { cutting.number(i * cellSide, layers[std::size_t(i)]); });
    forEachLayer([&](int z, Layer& layer) { cutting.findContacts(z, layer); });
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    std::size_t contacts = 0;
    for (const Layer& layer : layers)
        contacts += layer.contacts.size();
    reserveInLargePages(pieces.contacts, contacts);
    for (const Layer& layer : layers)
        pieces.contacts.insert(pieces.contacts.end(), layer.contacts.begin(), layer.contacts.end());
    return pieces;
}

} // namespace core
