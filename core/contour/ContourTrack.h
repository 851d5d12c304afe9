// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/contour/ContourState.h"

#include <cstdint>
#include <vector>

namespace core {

/// One generation of a contour: which voxels it changed, and how many voxels the segment would have
/// gained and lost in all by then.
struct ContourGeneration {
    ContourPlaces changed{};
    std::int64_t gained = 0;
    std::int64_t lost = 0;
};

/// The generations of a contour that are known so far. It lets a viewer move forwards and backwards
/// among them. It holds changes but no state: another thread takes a ContourState from one
/// generation to another with between(). So goTo() costs nothing.
class ContourTrack {
public:
    /// @param start the state at generation 0
    explicit ContourTrack(const ContourState& start);

    /// Adds the next generation. The one that is shown does not change.
    void append(ContourGeneration generation);
    [[nodiscard]] int known() const { return int(m_generations.size()) - 1; }
    /// @pre 0 ≤ generation ≤ known()
    void goTo(int generation) { m_shown = generation; }
    [[nodiscard]] int shown() const { return m_shown; }
    /// How many voxels the segment would have gained and lost at the generation that is shown.
    [[nodiscard]] std::int64_t gained() const;
    [[nodiscard]] std::int64_t lost() const;

    /// The voxels to be flipped, generation by generation, to turn the state of one generation into
    /// that of another (ContourState::pass()).
    /// @pre 0 ≤ from, to ≤ known()
    [[nodiscard]] std::vector<ContourPlaces> between(int from, int to) const;

private:
    std::vector<ContourGeneration> m_generations; ///< the first one, of the start, has no changes
    int m_shown = 0;
};

} // namespace core
