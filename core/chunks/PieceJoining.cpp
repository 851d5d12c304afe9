// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/PieceJoining.h"

#include "core/base/LargePages.h"
#include "core/chunks/ChunkField.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>
#include <utility>

namespace core {

namespace {

constexpr std::uint64_t greatest = std::numeric_limits<std::uint64_t>::max();
constexpr std::int64_t mostTaken = 1023;
constexpr std::size_t fetchedAhead = 32;

std::uint64_t timesAtMost(std::uint64_t a, std::uint64_t b)
{
    std::uint64_t product = 0;
    return __builtin_mul_overflow(a, b, &product) ? greatest : product;
}

/// The greatest whole number whose cube is not greater.
std::uint64_t cubeRoot(std::uint64_t value)
{
    std::uint64_t root = 0;
    // The root has a third of the bits, and at most 21.
    const int bits = std::min(20, int(std::bit_width(value)) / 3);
    for (std::uint64_t bit = std::uint64_t(1) << unsigned(bits); bit > 0; bit >>= 1U) {
        const std::uint64_t tried = root | bit;
        if (tried * tried * tried <= value)
            root = tried;
    }
    return root;
}

/// Where numbers are small they are divided faster.
std::uint64_t divided(std::uint64_t value, std::uint64_t by)
{
    constexpr std::uint64_t small = std::numeric_limits<std::uint32_t>::max();
    return value <= small && by <= small ? std::uint32_t(value) / std::uint32_t(by) : value / by;
}

} // namespace

bool PieceJoining::Offer::operator>(const Offer& than) const
{
    if (price != than.price)
        return price > than.price;
    return std::pair(std::min(by, other), std::max(by, other))
        > std::pair(std::min(than.by, than.other), std::max(than.by, than.other));
}

PieceJoining::Node PieceJoining::nodeOf(const Piece& piece, std::uint32_t number)
{
    return {.became = number,
        .voxels = piece.voxels,
        .code = std::int32_t(piece.codes / piece.voxels),
        .likelihood = std::int32_t(piece.likelihoods / piece.voxels)};
}

PieceJoining::PieceJoining(
    std::vector<Piece> pieces, const std::vector<Contact>& contacts, int noise)
    : m_pieces(std::move(pieces))
    , m_left(std::uint32_t(m_pieces.size()))
{
    constexpr std::int64_t greatestCode = std::numeric_limits<std::uint16_t>::max();
    for (std::int64_t apart = 0;
         apart <= greatestCode && (m_deviations.empty() || m_deviations.back() < mostTaken);
         ++apart)
        m_deviations.push_back(
            std::uint16_t(std::min(mostTaken, apart * ChunkField::deviation / noise)));
    // Each join leaves one piece less and makes one.
    m_pieces.reserve(2 * m_pieces.size());
    reserveInLargePages(m_nodes, 2 * m_pieces.size());
    reserveInLargePages(m_neighbours, 2 * m_pieces.size());
    m_neighbours.resize(m_pieces.size());
    for (std::uint32_t i = 0; i < m_pieces.size(); ++i)
        m_nodes.push_back(nodeOf(m_pieces[i], i));
    std::vector<std::uint32_t> counts(m_pieces.size(), 0);
    for (const Contact& contact : contacts) {
        ++counts[contact.first];
        ++counts[contact.second];
    }
    for (std::size_t i = 0; i < counts.size(); ++i)
        m_neighbours[i].all.reserve(counts[i]);
    for (const Contact& contact : contacts) {
        m_neighbours[contact.first].all.push_back(
            {.piece = contact.second, .faces = contact.faces});
        m_neighbours[contact.second].all.push_back(
            {.piece = contact.first, .faces = contact.faces});
    }
    for (std::uint32_t i = 0; i < m_pieces.size(); ++i)
        offerFirst(i);
}

/// (what they differ by² + noise²) · size · how narrow: the size is the harmonic one, h =
/// a·b/(a+b), and a contact is narrow by h^⅔ over its faces.
std::uint64_t PieceJoining::priceOf(const Node& one, const Node& other, std::uint32_t faces) const
{
    const auto difference = std::size_t(std::abs(one.code - other.code));
    const std::int64_t values = m_deviations[std::min(difference, m_deviations.size() - 1)];
    const std::int64_t likelihoods = std::abs(one.likelihood - other.likelihood);
    const auto apart = std::uint64_t(std::min(mostTaken, values + likelihoods));
    const auto all = std::uint64_t(one.voxels + other.voxels);
    const std::uint64_t size =
        divided(std::uint64_t(one.voxels) * std::uint64_t(other.voxels), all) + 1;
    const std::uint64_t edge = cubeRoot(size);
    constexpr auto noise = std::uint64_t(ChunkField::deviation);
    return divided(
        timesAtMost(timesAtMost(apart * apart + noise * noise, size), edge * edge), faces);
}

std::uint32_t PieceJoining::nowOf(std::uint32_t piece)
{
    while (m_nodes[piece].became != piece) {
        m_nodes[piece].became = m_nodes[m_nodes[piece].became].became;
        piece = m_nodes[piece].became;
    }
    return piece;
}

void PieceJoining::fetch(const Offer& offer) const
{
    for (const std::uint32_t piece : {offer.by, offer.other}) {
        __builtin_prefetch(&m_nodes[piece], 1);
        __builtin_prefetch(&m_neighbours[piece], 1);
    }
}

void PieceJoining::offerFirst(std::uint32_t piece)
{
    const Node& its = m_nodes[piece];
    Offer cheapest{.price = greatest, .by = piece, .other = piece};
    for (Neighbour& neighbour : m_neighbours[piece].all) {
        neighbour.price = priceOf(its, m_nodes[neighbour.piece], neighbour.faces);
        const Offer offer{.price = neighbour.price, .by = piece, .other = neighbour.piece};
        if (cheapest.other == piece || cheapest > offer)
            cheapest = offer;
    }
    if (cheapest.other != piece)
        m_offers.push(cheapest);
}

void PieceJoining::offerNext(std::uint32_t piece)
{
    Neighbours& neighbours = m_neighbours[piece];
    const auto dearer = [piece](const Neighbour& one, const Neighbour& other) {
        return Offer{.price = one.price, .by = piece, .other = one.piece}
        > Offer{.price = other.price, .by = piece, .other = other.piece};
    };
    const auto begin = neighbours.all.begin();
    if (neighbours.left == Neighbours::unsorted) {
        neighbours.left = std::uint32_t(neighbours.all.size());
        std::make_heap(begin, neighbours.all.end(), dearer);
    }
    while (neighbours.left > 0) {
        std::pop_heap(begin, begin + neighbours.left, dearer);
        --neighbours.left;
        const Neighbour& cheapest = neighbours.all[neighbours.left];
        if (isLeft(cheapest.piece)) {
            m_offers.push({.price = cheapest.price, .by = piece, .other = cheapest.piece});
            return;
        }
    }
}

std::vector<PieceJoining::Neighbour> PieceJoining::neighboursOfBoth(
    std::uint32_t first, std::uint32_t second, std::uint32_t joined)
{
    std::vector<Neighbour> once = std::move(m_neighbours[first].all);
    std::vector<Neighbour> others = std::move(m_neighbours[second].all);
    if (once.size() < others.size())
        once.swap(others);
    // They lie anywhere in memory: all are on their way before the first is looked at.
    for (const std::vector<Neighbour>* all : {&once, &others}) {
        for (std::size_t i = 0; i < std::min(all->size(), fetchedAhead); ++i)
            __builtin_prefetch(&m_nodes[(*all)[i].piece], 1);
    }
    std::size_t count = 0;
    const auto take = [&](const Neighbour& neighbour) {
        const std::uint32_t piece = nowOf(neighbour.piece);
        if (piece == joined)
            return;
        std::uint32_t& place = m_nodes[piece].place;
        if (place != 0) {
            once[place - 1].faces += neighbour.faces;
            return;
        }
        const Neighbour taken{.piece = piece, .faces = neighbour.faces};
        if (count < once.size())
            once[count] = taken;
        else
            once.push_back(taken);
        place = std::uint32_t(++count);
    };
    // What is overwritten was taken.
    for (std::size_t i = 0, size = once.size(); i < size; ++i) {
        if (i + fetchedAhead < size)
            __builtin_prefetch(&m_nodes[once[i + fetchedAhead].piece], 1);
        take(Neighbour(once[i]));
    }
    once.resize(count);
    for (const Neighbour& neighbour : others)
        take(neighbour);
    for (const Neighbour& neighbour : once)
        m_nodes[neighbour.piece].place = 0;
    return once;
}

std::optional<PieceJoining::Joined> PieceJoining::next()
{
    while (!m_offers.empty()) {
        const Offer offered = m_offers.pop();
        if (!m_offers.empty())
            fetch(m_offers.top());
        if (!isLeft(offered.by))
            continue;
        if (!isLeft(offered.other)) {
            offerNext(offered.by);
            continue;
        }
        const std::uint32_t first = std::min(offered.by, offered.other);
        const std::uint32_t second = std::max(offered.by, offered.other);
        const auto joined = std::uint32_t(m_pieces.size());
        const Piece& one = m_pieces[first];
        const Piece& other = m_pieces[second];
        m_pieces.push_back({.voxels = one.voxels + other.voxels,
            .codes = one.codes + other.codes,
            .likelihoods = one.likelihoods + other.likelihoods});
        m_nodes.push_back(nodeOf(m_pieces.back(), joined));
        m_nodes[first].became = joined;
        m_nodes[second].became = joined;
        m_neighbours.push_back({.all = neighboursOfBoth(first, second, joined)});
        offerFirst(joined);
        --m_left;
        return Joined{first, second, joined};
    }
    return std::nullopt;
}

} // namespace core
