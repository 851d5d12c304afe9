// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/chunks/LeastFirst.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// Joins pieces of a volume that touch, in pairs, most similar first. All numbers are integers; of
/// equal pairs the one with the lower numbers goes first.
class PieceJoining {
public:
    struct Piece {
        std::int64_t voxels = 0;
        std::int64_t codes = 0; ///< their sum
        std::int64_t likelihoods = 0; ///< their sum
    };
    struct Contact {
        std::uint32_t first = 0;
        std::uint32_t second = 0; ///< greater than first
        std::uint32_t faces = 1;
        [[nodiscard]] std::uint64_t pair() const { return std::uint64_t(first) << 32U | second; }
    };
    /// Two pieces, and the number of the piece that they became.
    struct Joined {
        std::uint32_t first = 0;
        std::uint32_t second = 0;
        std::uint32_t piece = 0;
    };

    /// @param contacts each pair once, in any order
    /// @param noise difference of codes that is one mean deviation
    PieceJoining(std::vector<Piece> pieces, const std::vector<Contact>& contacts, int noise);

    /// The next pair; none: no pieces touch any more. Both become a new piece with the next number.
    [[nodiscard]] std::optional<Joined> next();
    [[nodiscard]] const Piece& piece(std::uint32_t number) const { return m_pieces[number]; }
    [[nodiscard]] std::uint32_t left() const { return m_left; }

private:
    /// The properties of a piece that are needed for each of its neighbours, side by side in
    /// memory.
    struct Node {
        std::uint32_t became = 0; ///< the piece into which it was joined, or itself
        /// Its place in the list of neighbours that is being built; 0: none.
        std::uint32_t place = 0;
        std::int64_t voxels = 0;
        std::int32_t code = 0; ///< mean
        std::int32_t likelihood = 0; ///< mean
    };
    struct Neighbour {
        std::uint64_t price = 0;
        std::uint32_t piece = 0; ///< may have been joined since
        std::uint32_t faces = 0;
    };
    /// The neighbours that a piece had when it was made. A pair of pieces is offered by the piece
    /// that was made later; at the beginning by both.
    struct Neighbours {
        static constexpr std::uint32_t unsorted = ~std::uint32_t(0);
        std::vector<Neighbour> all;
        /// This many at the front form a heap of neighbours that were not offered yet. If it is not
        /// a heap yet, only the cheapest was offered.
        std::uint32_t left = unsorted;
    };
    struct Offer {
        std::uint64_t price = 0;
        std::uint32_t by = 0;
        std::uint32_t other = 0;
        [[nodiscard]] bool operator>(const Offer& than) const;
    };

    [[nodiscard]] static Node nodeOf(const Piece& piece, std::uint32_t number);
    [[nodiscard]] std::uint64_t priceOf(
        const Node& one, const Node& other, std::uint32_t faces) const;
    [[nodiscard]] std::uint32_t nowOf(std::uint32_t piece);
    [[nodiscard]] bool isLeft(std::uint32_t piece) const { return m_nodes[piece].became == piece; }
    /// Prefetches the memory of both pieces, before they are joined.
    void fetch(const Offer& offer) const;
    /// Prices all neighbours of a new piece and offers the cheapest.
    void offerFirst(std::uint32_t piece);
    /// Offers the cheapest remaining neighbour, after the previous one was joined with another
    /// piece.
    void offerNext(std::uint32_t piece);
    [[nodiscard]] std::vector<Neighbour> neighboursOfBoth(
        std::uint32_t first, std::uint32_t second, std::uint32_t joined);

    std::vector<Piece> m_pieces;
    std::vector<Node> m_nodes; ///< by piece
    std::vector<Neighbours> m_neighbours; ///< by piece
    LeastFirst<Offer> m_offers;
    std::uint32_t m_left = 0;
    /// For each difference of codes; the last entry stands for all greater ones.
    std::vector<std::uint16_t> m_deviations;
};

} // namespace core
