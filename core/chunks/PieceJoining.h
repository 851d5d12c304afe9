// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <queue>
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
    std::vector<std::uint32_t> m_became; ///< by piece: the piece that it was joined into, or itself
    /// by piece; may refer to pieces that were joined since
    std::vector<std::vector<Neighbour>> m_neighbours;
    std::priority_queue<Offer, std::vector<Offer>, std::greater<>> m_offers;
    std::uint32_t m_left = 0;
    int m_noise;
};

} // namespace core
