// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "gpu/gl/Texture3D.h"

#include <bitset>
#include <cstdint>
#include <span>

namespace gpu {

class Program;

/// The labels that the 3D view sees where segments overlap. At each voxel that is the label of the
/// highest plane whose segment there is shown and opaque; if there is none, of the highest whose
/// segment there is shown and translucent; else 0. So an opaque segment inside of a translucent one
/// is seen through it, whichever of the two lies in the higher plane.
///
/// It is needed, and costs a byte per voxel, only while a volume has several label planes
/// (composeLabels.comp). Engine thread only.
class ShownLabels {
public:
    /// Holds what the first plane does until it is composed. Throws GlFailure.
    ShownLabels(const core::BrickGrid& grid, const Texture3D& firstPlane);

    /// What is shown, by label.
    struct Looks {
        const std::bitset<256>& shown;
        const std::bitset<256>& translucent; ///< those that are not shown count as nothing
    };
    /// Composes the given bricks anew.
    /// @param compose composeLabels.comp
    /// @param planes 1 to core::mostLabelPlanes, ascending
    void update(Program& compose, std::span<const Texture3D* const> planes, const Looks& looks,
        std::span<const std::uint32_t> bricks);
    [[nodiscard]] const Texture3D& texture() const { return m_texture; } ///< R8UI

private:
    core::BrickGrid m_grid;
    Texture3D m_texture;
};

} // namespace gpu
