// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "gpu/gl/Texture3D.h"

#include <bitset>
#include <cstdint>
#include <span>

namespace gpu {

class Program;

/// A label plane composed for the 3D view of volumes whose segments overlap. Each voxel gets the
/// label of the highest plane whose segment there is shown and opaque; if there is none, of the
/// highest plane whose segment there is shown and translucent; else 0. So an opaque segment is seen
/// through a translucent one that surrounds it, whichever of them lies in the higher plane.
///
/// It is needed only while a volume has several label planes, and takes one byte per voxel. Engine
/// thread only.
class ShownLabels {
public:
    /// Starts as a copy of the first plane, until update() composes bricks. Throws GlFailure.
    ShownLabels(const core::BrickGrid& grid, const Texture3D& firstPlane);

    /// Which segments are shown, by label.
    struct Looks {
        const std::bitset<256>& shown;
        const std::bitset<256>& translucent; ///< labels that are not shown are ignored
    };
    /// Composes the given bricks.
    /// @param compose the program composeLabels.comp
    /// @param planes 1 to core::mostLabelPlanes textures, in ascending order of planes
    /// @param bricks brick numbers
    void update(Program& compose, std::span<const Texture3D* const> planes, const Looks& looks,
        std::span<const std::uint32_t> bricks);
    [[nodiscard]] const Texture3D& texture() const { return m_texture; } ///< R8UI

private:
    core::BrickGrid m_grid;
    Texture3D m_texture;
};

} // namespace gpu
