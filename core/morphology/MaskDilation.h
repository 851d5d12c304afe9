// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/morphology/BallFilters.h"
#include "core/morphology/MillimetreBall.h"

#include <cstdint>
#include <vector>

namespace core {

class StageCounter;

/// Dilation on a grid with perpendicular axes. First each slice is processed independently, then
/// the voxels of each column along z in both directions.
///
/// Within a slice, the squared distance of each voxel to the mask is exact: along x by counting,
/// along y by the lower envelope of the parabolas of the rows (LowerEnvelope.h). Only the reach
/// along z is stored: one more than the number of slices that the rest of the radius spans, or 0 if
/// the distance is greater than the radius. So two bytes per voxel suffice, and along z each voxel
/// takes the greater of its own reach and that of its neighbour less one.
class MaskDilation {
public:
    MaskDilation(ByteMask& mask, const MillimetreBall& ball);

    /// Processes a slice. May run in parallel for different z.
    void lookAlongSlice(int z);
    /// Processes the columns along z at one y; then their voxels in the mask are dilated. To be
    /// called after all slices; may run in parallel for different y.
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
    /// Squared length of 0, 1, 2 … steps along z, up to the squared radius.
    std::vector<std::int64_t> m_upTo;
    std::vector<std::uint16_t> m_reach;
};

} // namespace core
