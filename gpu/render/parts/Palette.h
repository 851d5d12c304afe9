// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Texture2D.h"
#include "gpu/scene/Scene.h"

namespace gpu {

/// The colour of each label and its opacity, as a texture of 256 × 1 texels, RGBA8 (alpha 0: not
/// shown). Texel 0 holds the warning colour (alpha 0).
class Palette {
public:
    Palette();

    void set(const SegmentDisplay& segments);
    [[nodiscard]] const Texture2D& texture() const { return m_texture; }
    [[nodiscard]] bool warns() const { return warnAfterGeneration() != 0xFFFFFFFFu; }
    /// Members of later generations than this are drawn in the warning colour (SegmentDisplay).
    [[nodiscard]] std::uint32_t warnAfterGeneration() const
    {
        return m_current.warnAfterGeneration;
    }
    [[nodiscard]] bool showsBarriers() const { return m_current.showBarriers; }
    [[nodiscard]] bool showsSuspended() const { return m_current.suspendedBodies; }
    /// Whether bodies of segments are drawn voxel by voxel. A segment at a tolerance never is,
    /// since it has no voxels of its own.
    [[nodiscard]] bool voxelTrue() const { return m_current.voxelTrue && !m_current.atTolerance; }
    /// Whether some body of a segment is drawn other than opaque and smooth.
    [[nodiscard]] bool changesBodies() const { return m_translucent || voxelTrue(); }

private:
    Texture2D m_texture;
    SegmentDisplay m_current;
    bool m_translucent = false; ///< whether some shown segment is translucent
};

} // namespace gpu
