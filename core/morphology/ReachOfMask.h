// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/morphology/BallFilters.h"
#include "core/morphology/MillimetreBall.h"

#include <cstdint>
#include <vector>

namespace core {

class StageCounter;

/// Dilation on a grid with axes at right angles, in three passes: slices, which are independent of
/// each other, then the two directions along z.
///
/// Within a slice each voxel's squared distance to the mask is exact: along x by counting, along y
/// by the lower envelope of the parabolas that the rows stand for (LowerEnvelope.h).
/// What is kept of it is one more than the slices up to which the rest of the radius reaches; 0:
/// none. So two bytes a voxel are enough, and what is left to do along z is to take the greater of
/// a voxel's reach and that of its neighbour less one.
class ReachOfMask {
public:
    ReachOfMask(ByteMask& mask, const MillimetreBall& ball);

    /// Independent for each z.
    void lookAlongSlice(int z);
    /// After all slices; independent for each y. The mask is then what the ball makes of it.
    void spreadAlongZ(int y);

private:
    [[nodiscard]] std::size_t rowAt(int y, int z) const
    {
        return (std::size_t(z) * std::size_t(m_mask.size.y) + std::size_t(y))
            * std::size_t(m_mask.size.x);
    }
    bool measureRows(int z, std::vector<int>& steps) const;

    ByteMask& m_mask;
    const MillimetreBall& m_ball;
    std::vector<std::int64_t> m_upTo; ///< squared length of so many slices, as far as it matters
    std::vector<std::uint16_t> m_reach;
};

} // namespace core
