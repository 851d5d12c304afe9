// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Texture3D.h"

#include <cstdint>

namespace gpu {

class VolumeTextures;

/// The distances by which a ray that looks for shown segments alone may skip macro-cells. Engine
/// thread only.
class SegmentCells {
public:
    /// The Chebyshev distance of each cell, in cells, to the nearest cell with a part of a segment
    /// (R8UI). Computed again only after a change of the volume, in time linear in the number of
    /// cells.
    [[nodiscard]] const Texture3D& distances(VolumeTextures& volume);

private:
    Texture3D m_distances;
    std::uint64_t m_revision = 0; ///< revision of the volume for which they were computed
};

} // namespace gpu
