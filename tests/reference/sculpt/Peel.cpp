// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/sculpt/Peel.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>
#include <vector>

namespace reference {

namespace {

using Place = ElementPlane::Place;
using Hits = std::map<Place, ElementPlane::Hit>;

/// Elements with a weight, and their weights.
std::map<Place, std::int64_t> weightsOf(const core::OutlineRaster& mask)
{
    std::map<Place, std::int64_t> weights;
    for (int b = 0; b < mask.size.y; ++b) {
        for (int a = 0; a < mask.size.x; ++a) {
            const std::int64_t m = mask.values[std::size_t(b * mask.size.x + a)];
            if (m > 0)
                weights[{mask.first.x + a, mask.first.y + b}] = m;
        }
    }
    return weights;
}

std::int64_t part(std::int64_t m)
{
    return (m * 255 + 128) / 256;
}

/// Everything that hangs together with an element, which leaves `rest`.
Hits takeSheet(Hits& rest, const Place& from, std::int64_t jump)
{
    Hits sheet;
    std::vector<Place> front{from};
    sheet[from] = rest.at(from);
    rest.erase(from);
    while (!front.empty()) {
        std::vector<Place> next;
        for (const Place& at : front) {
            for (const Place& step : {Place{1, 0}, Place{-1, 0}, Place{0, 1}, Place{0, -1}}) {
                const auto beside = rest.find({at.first + step.first, at.second + step.second});
                if (beside == rest.end()
                    || std::abs(beside->second.zSurface - sheet.at(at).zSurface) > jump)
                    continue;
                next.push_back(beside->first);
                sheet.insert(*beside);
                rest.erase(beside);
            }
        }
        front = std::move(next);
    }
    return sheet;
}

bool comesBefore(const Place& one, const Place& other)
{
    return one.second != other.second ? one.second < other.second : one.first < other.first;
}

Place firstOf(const Hits& sheet)
{
    Place first = sheet.begin()->first;
    for (const auto& [place, hit] : sheet)
        first = comesBefore(place, first) ? place : first;
    return first;
}

} // namespace

Peel::Peel(const DenseArray<std::uint16_t>& codes, DenseArray<std::uint8_t> radiation,
    DenseFields& fields, core::ShellPeel peel)
    : m_peel(std::move(peel))
    , m_coverage(fields.coverage(m_peel.layer))
    , m_before(m_coverage)
    , m_plane(codes, std::move(radiation), fields, m_peel.layer, m_peel.frame)
{
    Hits hits;
    for (const auto& [place, weight] : weightsOf(m_peel.mask)) {
        if (const auto hit = m_plane.cast(place.first, place.second))
            hits[place] = *hit;
    }
    if (m_peel.jump < 0) {
        m_sheet = std::move(hits);
        return;
    }
    while (!hits.empty()) {
        Hits sheet = takeSheet(hits, hits.begin()->first, m_peel.jump);
        if (sheet.size() > m_sheet.size()
            || (sheet.size() == m_sheet.size() && comesBefore(firstOf(sheet), firstOf(m_sheet))))
            m_sheet = std::move(sheet);
    }
}

void Peel::setDepth(std::int64_t depth)
{
    const core::CutFrame& frame = m_peel.frame;
    const std::int64_t sign = frame.restore ? -1 : 1;
    const std::int64_t pitch = frame.pitch;
    m_coverage = m_before;
    if (depth <= 0)
        return;
    std::map<Place, ElementPlane::Column> columns;
    for (const auto& [place, hit] : m_sheet) {
        std::int64_t end = sign * hit.zSurface;
        const std::int64_t reach = depth / pitch;
        for (std::int64_t q = -reach; q <= reach; ++q) {
            for (std::int64_t p = -reach; p <= reach; ++p) {
                const std::int64_t square = depth * depth - (p * p + q * q) * pitch * pitch;
                const auto other = m_sheet.find({place.first + p, place.second + q});
                if (square >= 0 && other != m_sheet.end())
                    end = std::max(end, sign * other->second.zSurface + squareRoot(square));
            }
        }
        end *= sign;
        ElementPlane::Column column;
        column.weight = part(m_peel.mask.at({int(place.first), int(place.second)}));
        if (frame.restore) {
            column =
                m_plane.restoring(hit, std::max(end, hit.zSurface - frame.maxDepth), column.weight);
        } else {
            column.zFrom = hit.zSurface - frame.front;
            column.zTo = std::min({end, hit.zExit, hit.zSurface + frame.maxDepth});
        }
        columns[place] = column;
    }
    m_plane.lay(columns, m_peel.laying);
}

std::optional<std::int32_t> cutWithScissors(const DenseArray<std::uint16_t>& codes,
    DenseArray<std::uint8_t> radiation, DenseFields& fields, const core::OutlineCut& scissors)
{
    const core::CutFrame& frame = scissors.frame;
    const std::int64_t r = frame.rampHalfWidth;
    ElementPlane plane(codes, std::move(radiation), fields, scissors.layer, frame);
    std::map<Place, ElementPlane::Column> columns;
    for (const auto& [place, weight] : weightsOf(scissors.mask)) {
        ElementPlane::Column column;
        column.weight = part(weight);
        column.zFrom = frame.zStart - 2 * r;
        column.zTo = frame.zStart + std::int64_t(frame.sampleCount) * frame.zPerSample + 2 * r;
        if (scissors.fromSurface) {
            const auto hit = plane.cast(place.first, place.second);
            if (!hit || frame.maxDepth <= 0)
                continue;
            if (frame.restore) {
                columns[place] =
                    plane.restoring(*hit, hit->zSurface - frame.maxDepth, column.weight);
                continue;
            }
            column.zFrom = hit->zSurface - frame.front;
            column.zTo = std::min(hit->zSurface + frame.maxDepth, hit->zExit);
        }
        columns[place] = column;
    }
    plane.lay(columns, scissors.laying);
    return plane.searchedTo();
}

} // namespace reference
