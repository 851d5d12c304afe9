// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/contour/ContourState.h"

#include <cstdint>
#include <vector>

namespace core {

/// What a generation of a contour changed, and how much the segment would have gained and lost by
/// then.
struct ContourGeneration {
    ContourPlaces changed{};
    std::int64_t gained = 0;
    std::int64_t lost = 0;
};

/// The generations of a contour that are known, for one who watches it and goes forwards and
/// backwards in them. It has no voxels: those are a ContourState's, which another thread takes from
/// one generation to another (between()). So going there costs nothing.
class ContourTrack {
public:
    /// @param start generation 0
    explicit ContourTrack(const ContourState& start);

    /// One generation more is known; the one that is shown stays.
    void append(ContourGeneration generation);
    [[nodiscard]] int known() const { return int(m_generations.size()) - 1; }
    /// @pre 0 ≤ generation ≤ known()
    void goTo(int generation) { m_shown = generation; }
    [[nodiscard]] int shown() const { return m_shown; }
    /// How many voxels the segment would have gained and lost at the generation that is shown.
    [[nodiscard]] std::int64_t gained() const;
    [[nodiscard]] std::int64_t lost() const;

    /// What takes a state from one generation to another, either way.
    /// @pre 0 ≤ from, to ≤ known()
    [[nodiscard]] std::vector<ContourPlaces> between(int from, int to) const;

private:
    std::vector<ContourGeneration> m_generations; ///< that of the start has no changes
    int m_shown = 0;
};

} // namespace core
