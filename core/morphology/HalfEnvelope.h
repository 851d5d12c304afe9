// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/morphology/LowerEnvelope.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

/// The least sum of a squared distance across a line, which is known at each place, and the square
/// of the steps along it, taken in one direction only. Each place thus contributes half a parabola
/// that begins there. Two of these meet once at most, and from there on the later one is lower, so
/// they form an envelope as in LowerEnvelope. Places must be ascending over all calls of add() and
/// at() since the last clear(); a parabola may be added at the place that was asked for last.
class HalfEnvelope {
public:
    /// @param curvature squared length of one step along the line
    void clear(std::int64_t curvature)
    {
        m_curvature = curvature;
        m_parabolas.clear();
        m_lowest = 0;
    }
    [[nodiscard]] bool empty() const { return m_parabolas.empty(); }
    /// The least value at a place. @pre not empty()
    [[nodiscard]] std::int64_t at(int place)
    {
        while (m_lowest + 1 < m_parabolas.size() && m_parabolas[m_lowest + 1].from <= place)
            ++m_lowest;
        return m_parabolas[m_lowest].at(place, m_curvature);
    }
    void add(int place, std::int64_t least)
    {
        if (empty() || least <= at(place)) {
            // The others grow at least as fast from here on.
            m_parabolas.assign(1, {.place = place, .from = place, .least = least});
            m_lowest = 0;
            return;
        }
        // The one that is lowest here stays: the new one meets it beyond this place.
        std::int64_t from = place;
        while (true) {
            const EnvelopeParabola& last = m_parabolas.back();
            from = last.endBefore(place, least, m_curvature);
            if (from > last.from)
                break;
            m_parabolas.pop_back();
        }
        if (from < never)
            m_parabolas.push_back({.place = place, .from = int(from), .least = least});
    }

private:
    static constexpr std::int64_t never = std::int64_t(1) << 30;

    std::int64_t m_curvature = 1;
    std::size_t m_lowest = 0; ///< which one is the lowest at the place that was asked for last
    std::vector<EnvelopeParabola> m_parabolas;
};

} // namespace core
