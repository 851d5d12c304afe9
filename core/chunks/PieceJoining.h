// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <queue>
#include <vector>

namespace core {

/// Pieces of a volume that touch, joined two by two, those that hang together best first. Whole
/// numbers; of equal pairs the one with the lesser numbers goes first.
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
    /// The two pieces, and the number that both have from now on.
    struct Joined {
        std::uint32_t first = 0;
        std::uint32_t second = 0;
        std::uint32_t piece = 0;
    };

    /// @param contacts each pair once, in any order
    /// @param noise codes that make one mean deviation
    PieceJoining(std::vector<Piece> pieces, const std::vector<Contact>& contacts, int noise);

    /// The next two; none: no pieces touch any more. They become a new piece with the next number.
    [[nodiscard]] std::optional<Joined> next();
    [[nodiscard]] const Piece& piece(std::uint32_t number) const { return m_pieces[number]; }
    [[nodiscard]] std::uint32_t left() const { return m_left; }

private:
    struct Neighbour {
        std::uint32_t piece = 0;
        std::uint32_t faces = 0;
    };
    struct Offer {
        std::uint64_t price = 0;
        std::uint32_t first = 0;
        std::uint32_t second = 0;
        [[nodiscard]] bool operator>(const Offer& other) const;
    };

    [[nodiscard]] std::uint64_t priceOf(
        const Piece& one, const Piece& other, std::uint32_t faces) const;
    [[nodiscard]] std::uint32_t nowOf(std::uint32_t piece);
    void offer(std::uint32_t piece, const Neighbour& neighbour);
    [[nodiscard]] std::vector<Neighbour> neighboursOfBoth(
        std::uint32_t first, std::uint32_t second, std::uint32_t joined);

    std::vector<Piece> m_pieces;
    std::vector<std::uint32_t> m_became; ///< by piece: what it was joined into, or itself
    std::vector<std::vector<Neighbour>> m_neighbours; ///< by piece; may name pieces of before
    std::priority_queue<Offer, std::vector<Offer>, std::greater<>> m_offers;
    std::uint32_t m_left = 0;
    int m_noise;
};

} // namespace core
