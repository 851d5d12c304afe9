// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/PieceJoining.h"

#include "core/chunks/ChunkField.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <tuple>

namespace core {

namespace {

constexpr std::uint64_t greatest = std::numeric_limits<std::uint64_t>::max();

std::uint64_t timesAtMost(std::uint64_t a, std::uint64_t b)
{
    return b != 0 && a > greatest / b ? greatest : a * b;
}

/// The greatest whole number whose cube is not greater.
std::uint64_t cubeRoot(std::uint64_t value)
{
    std::uint64_t root = 0;
    for (std::uint64_t bit = std::uint64_t(1) << 20U; bit > 0; bit >>= 1U) {
        const std::uint64_t tried = root | bit;
        if (tried * tried * tried <= value)
            root = tried;
    }
    return root;
}

} // namespace

bool PieceJoining::Offer::operator>(const Offer& other) const
{
    return std::tie(price, first, second) > std::tie(other.price, other.first, other.second);
}

PieceJoining::PieceJoining(
    std::vector<Piece> pieces, const std::vector<Contact>& contacts, int noise)
    : m_pieces(std::move(pieces))
    , m_left(std::uint32_t(m_pieces.size()))
    , m_noise(noise)
{
    m_became.resize(m_pieces.size());
    for (std::uint32_t i = 0; i < m_became.size(); ++i)
        m_became[i] = i;
    m_neighbours.resize(m_pieces.size());
    std::vector<Offer> offers;
    offers.reserve(contacts.size());
    for (const Contact& contact : contacts) {
        m_neighbours[contact.first].push_back({contact.second, contact.faces});
        m_neighbours[contact.second].push_back({contact.first, contact.faces});
        offers.push_back({priceOf(m_pieces[contact.first], m_pieces[contact.second], contact.faces),
            contact.first, contact.second});
    }
    m_offers = decltype(m_offers)(std::greater<>(), std::move(offers));
}

/// (what they differ by² + noise²) · size · how narrow: the size is the harmonic one, h =
/// a·b/(a+b), and a contact is narrow by h^⅔ over its faces.
std::uint64_t PieceJoining::priceOf(const Piece& one, const Piece& other, std::uint32_t faces) const
{
    constexpr std::int64_t mostDeviations = 1023;
    const std::int64_t values = std::abs(one.codes / one.voxels - other.codes / other.voxels)
        * ChunkField::deviation / m_noise;
    const std::int64_t likelihoods =
        std::abs(one.likelihoods / one.voxels - other.likelihoods / other.voxels);
    const auto apart = std::uint64_t(std::min(mostDeviations, values + likelihoods));
    const auto all = std::uint64_t(one.voxels + other.voxels);
    const std::uint64_t size = std::uint64_t(one.voxels) * std::uint64_t(other.voxels) / all + 1;
    const std::uint64_t edge = cubeRoot(size);
    constexpr auto noise = std::uint64_t(ChunkField::deviation);
    return timesAtMost(timesAtMost(apart * apart + noise * noise, size), edge * edge) / faces;
}

std::uint32_t PieceJoining::nowOf(std::uint32_t piece)
{
    while (m_became[piece] != piece) {
        m_became[piece] = m_became[m_became[piece]];
        piece = m_became[piece];
    }
    return piece;
}

void PieceJoining::offer(std::uint32_t piece, const Neighbour& neighbour)
{
    m_offers.push({priceOf(m_pieces[piece], m_pieces[neighbour.piece], neighbour.faces),
        std::min(piece, neighbour.piece), std::max(piece, neighbour.piece)});
}

std::vector<PieceJoining::Neighbour> PieceJoining::neighboursOfBoth(
    std::uint32_t first, std::uint32_t second, std::uint32_t joined)
{
    std::vector<Neighbour> all = std::move(m_neighbours[first]);
    all.insert(all.end(), m_neighbours[second].begin(), m_neighbours[second].end());
    m_neighbours[first] = {};
    m_neighbours[second] = {};
    for (Neighbour& neighbour : all)
        neighbour.piece = nowOf(neighbour.piece);
    std::sort(all.begin(), all.end(),
        [](const Neighbour& a, const Neighbour& b) { return a.piece < b.piece; });
    std::vector<Neighbour> once;
    for (const Neighbour& neighbour : all) {
        if (neighbour.piece == joined)
            continue;
        if (!once.empty() && once.back().piece == neighbour.piece)
            once.back().faces += neighbour.faces;
        else
            once.push_back(neighbour);
    }
    return once;
}

std::optional<PieceJoining::Joined> PieceJoining::next()
{
    while (!m_offers.empty()) {
        const Offer offered = m_offers.top();
        m_offers.pop();
        // A piece that has been joined since has new offers under its new number.
        if (m_became[offered.first] != offered.first || m_became[offered.second] != offered.second)
            continue;
        const auto joined = std::uint32_t(m_pieces.size());
        const Piece& one = m_pieces[offered.first];
        const Piece& other = m_pieces[offered.second];
        m_pieces.push_back({.voxels = one.voxels + other.voxels,
            .codes = one.codes + other.codes,
            .likelihoods = one.likelihoods + other.likelihoods});
        m_became.push_back(joined);
        m_became[offered.first] = joined;
        m_became[offered.second] = joined;
        m_neighbours.push_back(neighboursOfBoth(offered.first, offered.second, joined));
        // By value: offer() does not touch the neighbours, but the list may move.
        for (const Neighbour& neighbour : std::vector<Neighbour>(m_neighbours.back()))
            offer(joined, neighbour);
        --m_left;
        return Joined{offered.first, offered.second, joined};
    }
    return std::nullopt;
}

} // namespace core
