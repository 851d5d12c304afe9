// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Texture3D.h"

#include <cstdint>

namespace gpu {

class VolumeTextures;

/// The macro-cells as a ray sees them that looks for shown segments alone: how far the nearest one
/// with a part of a segment is, whatever else is visible. Engine thread.
class SegmentCells {
public:
    /// R8UI: the Chebyshev distance in cells. Computed again, in time linear in the cells, only
    /// when voxels have changed.
    [[nodiscard]] const Texture3D& distances(VolumeTextures& volume);

private:
    Texture3D m_distances;
    std::uint64_t m_revision = 0; ///< of the volume for which they were computed
};

} // namespace gpu
