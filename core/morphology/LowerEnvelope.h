// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

/// One of the parabolas of an envelope. They differ in their lowest points only, so two of them
/// meet once.
struct EnvelopeParabola {
    int place = 0; ///< where it is lowest
    int from = 0; ///< the first place at which it is the lowest of all
    std::int64_t least = 0;

    [[nodiscard]] std::int64_t at(int where, std::int64_t curvature) const
    {
        const std::int64_t step = where - place;
        return least + curvature * step * step;
    }
    /// The first place at which one that is lowest farther on is not above this one.
    [[nodiscard]] std::int64_t endBefore(
        int laterPlace, std::int64_t laterLeast, std::int64_t curvature) const
    {
        const std::int64_t apart = laterPlace - place;
        const std::int64_t number =
            laterLeast - least + curvature * apart * (std::int64_t(laterPlace) + place);
        const std::int64_t divisor = 2 * curvature * apart;
        return number / divisor + (number % divisor > 0 ? 1 : 0);
    }
};

/// The lower envelope of parabolas that differ only in their lowest points. Along a line it gives
/// the least squared distance to a set of places, each of which already has a squared distance
/// across the line (Felzenszwalb and Huttenlocher; Meijster, Roerdink and Hesselink). In whole
/// numbers: the place where two parabolas meet is an integer division, rounded up.
class LowerEnvelope {
public:
    /// @param curvature squared length of one step along the line
    /// @param most the greatest number of parabolas, for which memory is reserved
    LowerEnvelope(std::int64_t curvature, std::size_t most)
        : m_curvature(curvature)
    {
        m_parabolas.reserve(most);
    }

    /// Starts again. at() will be called for places from @p begin to before @p end.
    void clear(int begin, int end)
    {
        m_begin = begin;
        m_end = end;
        m_lowest = 0;
        m_parabolas.clear();
    }
    /// Adds a parabola. Places must be ascending.
    /// @param least squared distance at that place
    void add(int place, std::int64_t least)
    {
        std::int64_t from = m_begin;
        while (!m_parabolas.empty()) {
            const EnvelopeParabola& last = m_parabolas.back();
            from = last.endBefore(place, least, m_curvature);
            if (from > last.from)
                break;
            m_parabolas.pop_back();
            from = m_begin;
        }
        if (from < m_end)
            m_parabolas.push_back({.place = place, .from = int(from), .least = least});
    }
    [[nodiscard]] bool empty() const { return m_parabolas.empty(); }
    /// The least squared distance at a place. To be called after all parabolas were added, with
    /// ascending places.
    /// @pre not empty()
    [[nodiscard]] std::int64_t at(int place)
    {
        while (m_lowest + 1 < m_parabolas.size() && m_parabolas[m_lowest + 1].from <= place)
            ++m_lowest;
        return m_parabolas[m_lowest].at(place, m_curvature);
    }

private:
    std::int64_t m_curvature;
    int m_begin = 0;
    int m_end = 0;
    std::size_t m_lowest = 0;
    std::vector<EnvelopeParabola> m_parabolas; ///< from left to right
};

} // namespace core
